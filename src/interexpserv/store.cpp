#include "interexpserv/store.hpp"

#include <fmt/format.h>
#include <sqlite3.h>

#include <array>

#include "base/error.hpp"

namespace animado::interexpserv {
namespace {

constexpr int kBusyTimeout_ms = 2000;  // a reader such as the sqlite3 shell may hold the file for a moment
constexpr int64_t kSchemaVersion = 2;
constexpr size_t kMostPending = 1000;  // revisions; they take SQLite some milliseconds, while others wait
constexpr int64_t kRoomForOld =
    200'000;  // rows beyond twice what was needed when old ones were forgotten last

constexpr const char* kSchema = R"(
  CREATE TABLE IF NOT EXISTS revisions (
    version INTEGER NOT NULL, name TEXT NOT NULL, kind TEXT NOT NULL, text TEXT NOT NULL, type TEXT NOT NULL,
    array TEXT NOT NULL, element INTEGER NOT NULL, stride INTEGER NOT NULL, time_us INTEGER NOT NULL,
    who TEXT NOT NULL, PRIMARY KEY (version, name)) WITHOUT ROWID;
)";

constexpr std::array<std::string_view, 3> kKinds = {"definition", "binding", "removed"};
constexpr std::array<Type, 3> kTypes = {Type::boolean, Type::scalar, Type::vector};

Revision::Kind kind_named(std::string_view name) {
  const auto at = std::find(kKinds.begin(), kKinds.end(), name);
  return static_cast<Revision::Kind>(at - kKinds.begin());
}

Type type_named(std::string_view name) {
  const auto at =
      std::find_if(kTypes.begin(), kTypes.end(), [&](Type type) { return name_of(type) == name; });
  return at == kTypes.end() ? Type::scalar : *at;
}

}  // namespace

void Store::Close::operator()(sqlite3* database) const {
  sqlite3_close(database);
}

// A prepared statement: parameters are bound in order, columns are read in order.
class Store::Statement {
 public:
  Statement(const Store& store, const std::string& sql) : store_(store) {
    if (sqlite3_prepare_v2(store.database_.get(), sql.c_str(), -1, &statement_, nullptr) != SQLITE_OK)
      store.fail("read");
  }
  ~Statement() { sqlite3_finalize(statement_); }
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  // The texts of a revision stay where they are until it is written.
  void write(const NamedRevision& named) {
    const Revision& r = named.revision;
    parameter_ = 0;
    put(r.version).put(named.name).put(kKinds[static_cast<size_t>(r.kind)]).put(r.text).put(name_of(r.type));
    put(r.binding.array).put(r.binding.element).put(r.binding.stride).put(r.time_us).put(r.who);
    const bool written = sqlite3_step(statement_) == SQLITE_DONE;
    sqlite3_reset(statement_);
    if (!written) store_.fail("write");
  }

  bool step() {
    const int status = sqlite3_step(statement_);
    if (status != SQLITE_ROW && status != SQLITE_DONE) store_.fail("read");
    return status == SQLITE_ROW;
  }
  int64_t number(int column) const { return sqlite3_column_int64(statement_, column); }
  NamedRevision revision() const {
    return {text(1),
            {kind_named(text(2)),
             type_named(text(4)),
             text(3),
             {text(5), number(6), number(7)},
             number(0),
             number(8),
             text(9)}};
  }

 private:
  Statement& put(std::string_view text) {
    sqlite3_bind_text(statement_, ++parameter_, text.data(), static_cast<int>(text.size()), SQLITE_STATIC);
    return *this;
  }
  Statement& put(int64_t number) {
    sqlite3_bind_int64(statement_, ++parameter_, number);
    return *this;
  }
  std::string text(int column) const {
    const auto* bytes = reinterpret_cast<const char*>(sqlite3_column_text(statement_, column));
    return bytes ? std::string(bytes, static_cast<size_t>(sqlite3_column_bytes(statement_, column))) : "";
  }

  const Store& store_;
  sqlite3_stmt* statement_ = nullptr;
  int parameter_ = 0;
};

Store::Store(const std::filesystem::path& file) : file_(file) {
  sqlite3* database = nullptr;
  const int status = sqlite3_open(file.c_str(), &database);
  database_.reset(database);
  if (status != SQLITE_OK) fail("open");
  sqlite3_busy_timeout(database, kBusyTimeout_ms);
  execute("PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL");
  if (const int64_t version = number("PRAGMA user_version"); version != 0 && version != kSchemaVersion) {
    throw Error(Code::refused, fmt::format("written by another version ({})", version), file.string(),
                "use that version, or another file");
  }
  execute(kSchema);
  execute(fmt::format("PRAGMA user_version = {}", kSchemaVersion).c_str());
  insert_ = std::make_unique<Statement>(
      *this, "REPLACE INTO revisions VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9, ?10)");
  journal_ = std::make_unique<Journal>(file.native() + ".journal");
  pending_ = journal_->read();
  settle();
  journal_->clear();  // of what was left unfinished
  forget_oldest();
}

Store::~Store() {
  try {
    settle();
  } catch (const Error&) {  // the journal keeps what SQLite does not take
  }
}

std::vector<NamedRevision> Store::load() {
  settle();
  std::vector<NamedRevision> revisions;
  Statement all(*this, "SELECT * FROM revisions ORDER BY version, name");
  while (all.step()) revisions.push_back(all.revision());
  return revisions;
}

void Store::commit(std::span<const NamedRevision> transaction) {
  if (pending_.size() >= kMostPending || transaction.size() >= kMostPending) settle();
  if (transaction.size() >= kMostPending) return insert(transaction);
  journal_->append(transaction);
  pending_.insert(pending_.end(), transaction.begin(), transaction.end());
}

void Store::settle() {
  if (pending_.empty()) return;
  insert(pending_);
  journal_->clear();
  pending_.clear();
  if (rows_ > 2 * rows_after_forgetting_ + kRoomForOld) forget_oldest();
}

void Store::insert(std::span<const NamedRevision> revisions) {
  execute("BEGIN IMMEDIATE");
  try {
    for (const NamedRevision& revision : revisions) insert_->write(revision);
    execute("COMMIT");
  } catch (const Error&) {
    sqlite3_exec(database_.get(), "ROLLBACK", nullptr, nullptr, nullptr);
    throw;
  }
  rows_ += static_cast<int64_t>(revisions.size());
}

void Store::forget_oldest() {
  execute(
      fmt::format("DELETE FROM revisions WHERE (version, name) IN (SELECT version, name FROM ("
                  "SELECT version, name, row_number() OVER (PARTITION BY name ORDER BY version DESC) AS age "
                  "FROM revisions) WHERE age > {})",
                  kRevisionsKept)
          .c_str());
  rows_ = rows_after_forgetting_ = number("SELECT count(*) FROM revisions");
}

int64_t Store::number(const char* query) {
  Statement statement(*this, query);
  statement.step();
  return statement.number(0);
}

void Store::execute(const char* sql) {
  if (sqlite3_exec(database_.get(), sql, nullptr, nullptr, nullptr) != SQLITE_OK) fail("write");
}

void Store::fail(std::string_view doing) const {
  const int status = sqlite3_errcode(database_.get());
  const std::string message = fmt::format("cannot {}: {}", doing, sqlite3_errmsg(database_.get()));
  if (status == SQLITE_NOTADB || status == SQLITE_CORRUPT) {
    throw Error(Code::refused, message, file_.string(),
                "give another file to --store, or take this one away");
  }
  throw Error(Code::unavailable, message, file_.string(), "see that its folder exists and can be written");
}

}  // namespace animado::interexpserv
