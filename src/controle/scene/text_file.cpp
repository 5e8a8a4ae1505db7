#include "controle/scene/text_file.hpp"

#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/error.hpp"

namespace animado::controle {

std::string read_text(const std::string& path) {
  const std::string remedy = "check the name; names in a scene are relative to its folder";
  if (!std::filesystem::exists(path)) throw Error(Code::unavailable, "the file is not there", path, remedy);
  if (std::filesystem::is_directory(path))
    throw Error(Code::unavailable, "this is a folder, not a file", path, remedy);
  std::ifstream file(path, std::ios::binary);
  if (!file) throw Error(Code::unavailable, "the file cannot be read", path, "check its permissions");
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string beside(const std::string& scene, std::string_view file) {
  return (std::filesystem::path(scene).parent_path() / file).string();
}

std::vector<std::string_view> split(std::string_view text, std::string_view separators) {
  std::vector<std::string_view> parts;
  while (true) {
    const size_t begin = text.find_first_not_of(separators);
    if (begin == std::string_view::npos) return parts;
    const size_t end = std::min(text.find_first_of(separators, begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    text.remove_prefix(end);
  }
}

double to_number(std::string_view text, const std::string& where) {
  double value = 0;
  const std::string_view digits = text.starts_with('+') ? text.substr(1) : text;
  const auto [end, status] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (status == std::errc::invalid_argument || end != digits.data() + digits.size()) {
    throw Error(Code::syntax, "expected a number, found `" + std::string(text) + "`", where,
                "numbers are written 1.5 or 2e-3");
  }
  if (status != std::errc() || !std::isfinite(value)) {
    throw Error(Code::not_finite, "`" + std::string(text) + "` is not a finite number", where,
                "write a finite number");
  }
  return value;
}

}  // namespace animado::controle
