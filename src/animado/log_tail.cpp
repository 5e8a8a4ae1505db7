#include "animado/log_tail.hpp"

#include <deque>
#include <fstream>

namespace animado {

std::string last_lines(const std::filesystem::path& file, size_t lines) {
  constexpr std::streamoff kMostBytes = 64 * 1024;  // a line that reaches beyond is cut
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  if (!in) return {};
  in.seekg(std::max<std::streamoff>(0, in.tellg() - kMostBytes));
  std::deque<std::string> kept;
  for (std::string line; std::getline(in, line);) {
    kept.push_back(line);
    if (kept.size() > lines) kept.pop_front();
  }
  std::string text;
  for (const std::string& line : kept) text += "  " + line + "\n";
  return text;
}

}  // namespace animado
