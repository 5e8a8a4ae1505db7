#include "live/growing_file.hpp"

#include <fstream>

namespace animado::live {

std::string GrowingFile::take_lines() {
  std::ifstream file(path_, std::ios::binary | std::ios::ate);
  if (!file) return {};
  const auto size = static_cast<int64_t>(file.tellg());
  if (size <= read_) return {};
  std::string lines(static_cast<size_t>(size - read_), '\0');
  file.seekg(read_);
  file.read(lines.data(), static_cast<std::streamsize>(lines.size()));
  lines.resize(lines.rfind('\n') + 1);  // npos + 1 is 0: not one whole line
  read_ += static_cast<int64_t>(lines.size());
  return lines;
}

}  // namespace animado::live
