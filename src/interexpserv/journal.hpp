// What was committed and is not in the SQLite file yet: a file that only grows, until it is emptied. A write
// of some hundred bytes takes a tenth of the time of SQLite's smallest transaction.
//
// A frame is a transaction: bytes of the payload (uint32), their checksum (uint32), the payload. A frame that
// a killed process left unfinished does not count.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "interexpserv/revision.hpp"

namespace animado::interexpserv {

class Journal {
 public:
  // Opens or makes the file. Throws conflict when another process writes to it, unavailable when it cannot be
  // opened.
  explicit Journal(const std::filesystem::path& file);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  std::vector<NamedRevision> read() const;  // in order
  // When it throws (unavailable), nothing was appended.
  void append(std::span<const NamedRevision> transaction);
  void clear();

 private:
  [[noreturn]] void fail(std::string_view doing) const;

  std::filesystem::path file_;
  int fd_;
  int64_t size_ = 0;   // bytes
  std::string frame_;  // kept for its memory
};

}  // namespace animado::interexpserv
