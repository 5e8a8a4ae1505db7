#include "controle/results/table_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "base/error.hpp"
#include "controle/scene/text_file.hpp"

namespace animado::controle {
namespace {

std::string_view take_until(std::string_view& text, char end) {
  const size_t at = std::min(text.find(end), text.size());
  const std::string_view taken = text.substr(0, at);
  text.remove_prefix(std::min(at + 1, text.size()));
  return taken;
}

}  // namespace

TableReader::TableReader(std::filesystem::path file, std::string_view header)
    : file_(std::move(file)), text_(read_text(file_.string())), rest_(text_) {
  if (take_until(rest_, '\n') != header) refuse("another header");
}

TableReader::TableReader(std::string rows, std::filesystem::path file)
    : file_(std::move(file)), text_(std::move(rows)), rest_(text_) {}

bool TableReader::next_row() {
  if (rest_.empty()) return false;
  row_ = take_until(rest_, '\n');
  ++line_;
  return true;
}

std::string_view TableReader::cell() {
  if (row_.empty()) refuse("a row that ends too early");
  return take_until(row_, ',');
}

double TableReader::number() {
  const std::string_view text = cell();
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
    refuse(fmt::format("'{}' where a number is expected", text));
  return value;
}

void TableReader::numbers(std::span<double> out) {
  for (double& value : out) value = number();
}

void TableReader::refuse(const std::string& found) const {
  throw Error(Code::syntax, found, fmt::format("{}:{}", file_.string(), line_),
              "simulate the scene again: animado run SCENE");
}

}  // namespace animado::controle
