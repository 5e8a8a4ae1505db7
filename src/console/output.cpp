#include "console/output.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <system_error>

#include "console/terminal.hpp"

namespace animado {

int with_output(const std::function<int()>& work) {
  try {
    const int code = work();
    const bool failed_before = std::ferror(stdout) != 0;
    if ((!failed_before && std::fflush(stdout) == 0) || code != 0) return code;
    const std::string why = failed_before ? "some of it was lost" : std::strerror(errno);
    print_error({Code::unavailable, "cannot write: " + why, "stdout",
                 "free space on the disk, or write to another one"});
  } catch (const std::system_error& error) {  // of fmt::print, or of the file system
    print_error({Code::unavailable, error.what()});
  }
  return kOutputLost;
}

}  // namespace animado
