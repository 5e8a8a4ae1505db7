// A file that is known to be on the disk when it is closed: a full disk or a lost directory is an error,
// never a short file.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace animado::controle {

class OutputFile {
 public:
  // Creates or empties the file. Throws Error(unavailable) when it cannot; so do the other functions.
  explicit OutputFile(std::filesystem::path path);
  ~OutputFile();  // a file that was not closed keeps what was flushed
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::string_view bytes);  // buffered
  void flush();  // hands the buffer to the system: other processes see it, a crash of this one keeps it
  void close();  // flush, fsync, close

 private:
  [[noreturn]] void fail(std::string_view action) const;

  std::filesystem::path path_;
  std::string buffer_;
  int descriptor_ = -1;
};

// The whole text, or what was there before. Throws Error(unavailable).
void write_whole(const std::filesystem::path& path, std::string_view text);

}  // namespace animado::controle
