// Whole lines from a descriptor that does not block.
#pragma once

#include <unistd.h>

#include <cerrno>
#include <string>

namespace animado::rpc {

class LineReader {
 public:
  explicit LineReader(int descriptor) : descriptor_(descriptor) {}

  // Calls `take` with each whole line that has come. False at the end of the stream.
  template <class Take>
  bool read_lines(Take&& take) {
    char buffer[4096];
    ssize_t count;
    while ((count = read(descriptor_, buffer, sizeof buffer)) > 0) {
      pending_.append(buffer, static_cast<size_t>(count));
      size_t begin = 0;
      for (size_t end; (end = pending_.find('\n', begin)) != std::string::npos; begin = end + 1) {
        take(pending_.substr(begin, end - begin));
      }
      pending_.erase(0, begin);
    }
    return count < 0 && (errno == EAGAIN || errno == EINTR);
  }

 private:
  int descriptor_;
  std::string pending_;
};

}  // namespace animado::rpc
