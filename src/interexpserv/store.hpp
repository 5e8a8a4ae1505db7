// The names on disk: an SQLite file with a write-ahead log. A transaction that was acknowledged is there
// after the process was killed at any point; one that was not is there whole or not at all.
//
//   names  the rows as they are now, one a name; removed ones too
//   log    every change ever made, in order: version, name, kind, text
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <vector>

#include "interexpserv/names.hpp"

struct sqlite3;

namespace animado::interexpserv {

class Store {
 public:
  // Opens or makes the file. Throws refused when it is no store, or one of a newer version; unavailable when
  // it cannot be opened.
  explicit Store(const std::filesystem::path& file);

  struct Contents {
    std::vector<NameRow> rows;  // by name
    int64_t version = 0;
  };
  Contents load();

  void commit(int64_t version, std::span<const NameRow> rows);  // one transaction; throws unavailable

  std::vector<NameRow> log();  // in order

 private:
  struct Close {
    void operator()(sqlite3* database) const;
  };
  class Statement;
  void execute(const char* sql);
  [[noreturn]] void fail(std::string_view doing) const;

  std::filesystem::path file_;
  std::unique_ptr<sqlite3, Close> database_;
};

}  // namespace animado::interexpserv
