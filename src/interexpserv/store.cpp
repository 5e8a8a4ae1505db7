#include "interexpserv/store.hpp"

#include <fmt/format.h>
#include <sqlite3.h>

#include <array>

namespace animado::interexpserv {
namespace {

constexpr int kBusyTimeout_ms = 2000;  // a reader such as the sqlite3 shell may hold the file for a moment
constexpr int64_t kSchemaVersion = 1;

constexpr const char* kSchema = R"(
  CREATE TABLE IF NOT EXISTS names (
    name TEXT PRIMARY KEY, kind TEXT NOT NULL, text TEXT NOT NULL, type TEXT NOT NULL,
    array TEXT NOT NULL, element INTEGER NOT NULL, stride INTEGER NOT NULL, version INTEGER NOT NULL) WITHOUT ROWID;
  CREATE TABLE IF NOT EXISTS log (
    version INTEGER NOT NULL, name TEXT NOT NULL, kind TEXT NOT NULL, text TEXT NOT NULL, type TEXT NOT NULL,
    array TEXT NOT NULL, element INTEGER NOT NULL, stride INTEGER NOT NULL, PRIMARY KEY (version, name)) WITHOUT ROWID;
)";

constexpr std::array<std::string_view, 3> kKinds = {"definition", "binding", "removed"};
constexpr std::array<Type, 3> kTypes = {Type::boolean, Type::scalar, Type::vector};

NameRow::Kind kind_named(std::string_view name) {
  const auto at = std::find(kKinds.begin(), kKinds.end(), name);
  return static_cast<NameRow::Kind>(at - kKinds.begin());
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
  Statement(const Store& store, const char* sql) : store_(store) {
    if (sqlite3_prepare_v2(store.database_.get(), sql, -1, &statement_, nullptr) != SQLITE_OK)
      store.fail("read");
  }
  ~Statement() { sqlite3_finalize(statement_); }
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  Statement& put(std::string_view text) {
    sqlite3_bind_text(statement_, ++parameter_, text.data(), static_cast<int>(text.size()), SQLITE_TRANSIENT);
    return *this;
  }
  Statement& put(int64_t number) {
    sqlite3_bind_int64(statement_, ++parameter_, number);
    return *this;
  }
  Statement& put(const NameRow& row) {
    put(row.name).put(kKinds[static_cast<size_t>(row.kind)]).put(row.text).put(name_of(row.type));
    return put(row.binding.array).put(row.binding.element).put(row.binding.stride).put(row.version);
  }

  bool step() {
    const int status = sqlite3_step(statement_);
    if (status != SQLITE_ROW && status != SQLITE_DONE) store_.fail("write");
    return status == SQLITE_ROW;
  }
  void run_again() {
    step();
    sqlite3_reset(statement_);
    parameter_ = 0;
  }

  std::string text(int column) const {
    const auto* bytes = reinterpret_cast<const char*>(sqlite3_column_text(statement_, column));
    return bytes ? std::string(bytes, static_cast<size_t>(sqlite3_column_bytes(statement_, column))) : "";
  }
  int64_t number(int column) const { return sqlite3_column_int64(statement_, column); }
  NameRow row() const {
    return {kind_named(text(1)),
            text(0),
            text(2),
            type_named(text(3)),
            {text(4), number(5), number(6)},
            number(7)};
  }

 private:
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
  // Kept consistent by the log when the process is killed; the last moments may be lost with the power, never
  // the file.
  execute("PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL");
  Statement version(*this, "PRAGMA user_version");
  version.step();
  if (version.number(0) > kSchemaVersion) {
    throw Error(Code::refused, fmt::format("written by a newer version ({})", version.number(0)),
                file.string(), "use that version, or another file");
  }
  execute(kSchema);
  execute(fmt::format("PRAGMA user_version = {}", kSchemaVersion).c_str());
}

Store::Contents Store::load() {
  Contents contents;
  Statement rows(*this,
                 "SELECT name, kind, text, type, array, element, stride, version FROM names ORDER BY name");
  while (rows.step()) contents.rows.push_back(rows.row());
  Statement version(*this, "SELECT coalesce(max(version), 0) FROM log");
  version.step();
  contents.version = version.number(0);
  return contents;
}

void Store::commit(int64_t version, std::span<const NameRow> rows) {
  execute("BEGIN IMMEDIATE");
  try {
    Statement now(*this, "REPLACE INTO names VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8)");
    Statement log(*this, "INSERT INTO log VALUES (?8, ?1, ?2, ?3, ?4, ?5, ?6, ?7)");
    for (NameRow row : rows) {
      row.version = version;
      now.put(row).run_again();
      log.put(row).run_again();
    }
    execute("COMMIT");
  } catch (const Error&) {
    sqlite3_exec(database_.get(), "ROLLBACK", nullptr, nullptr, nullptr);
    throw;
  }
}

std::vector<NameRow> Store::log() {
  std::vector<NameRow> rows;
  Statement all(
      *this,
      "SELECT name, kind, text, type, array, element, stride, version FROM log ORDER BY version, name");
  while (all.step()) rows.push_back(all.row());
  return rows;
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
