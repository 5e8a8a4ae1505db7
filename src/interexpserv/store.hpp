// The names on disk. What was acknowledged is there after the process was killed at any point; a transaction
// that was not is there whole or not at all. When the power fails, what came since the last checkpoint of the
// SQLite file may be lost, never the file.
//
// A commit is appended to a journal beside the file (FILE.journal), which takes a microsecond; a thousand of
// them become one transaction of SQLite.
//
//   revisions  what names were made to stand for, in order; of each name the last kRevisionsKept at least
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "interexpserv/journal.hpp"

struct sqlite3;

namespace animado::interexpserv {

class Store {
 public:
  // Opens or makes the file, and takes over what a killed process left in the journal. Throws refused when it
  // is no store, or one of another version; unavailable when it cannot be opened; conflict when another
  // process has it.
  explicit Store(const std::filesystem::path& file);
  ~Store();

  std::vector<NamedRevision> load();  // in the order of their versions

  void commit(std::span<const NamedRevision> transaction);  // throws unavailable

 private:
  struct Close {
    void operator()(sqlite3* database) const;
  };
  class Statement;
  void settle();  // what is pending becomes part of the SQLite file
  void insert(std::span<const NamedRevision> revisions);
  void forget_oldest();
  int64_t number(const char* query);
  void execute(const char* sql);
  [[noreturn]] void fail(std::string_view doing) const;

  std::filesystem::path file_;
  std::unique_ptr<sqlite3, Close> database_;
  std::unique_ptr<Statement> insert_;
  std::unique_ptr<Journal> journal_;
  std::vector<NamedRevision> pending_;  // what the journal holds
  int64_t rows_ = 0, rows_after_forgetting_ = 0;
};

}  // namespace animado::interexpserv
