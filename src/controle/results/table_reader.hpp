// A table of comma-separated numbers and names, a row at a time, as quick as a recorded run of many bodies
// wants it.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace animado::controle {

class TableReader {
 public:
  // Reads the file whole. Throws Error when it cannot, or when its first line is not `header`.
  TableReader(std::filesystem::path file, std::string_view header);
  // Reads rows that came without the header.
  TableReader(std::string rows, std::filesystem::path file);

  // The next row; false at the end. The cells below are taken from it, from left to right.
  bool next_row();
  std::string_view cell();
  double number();
  void numbers(std::span<double> out);
  // Throws Error with the place of the row.
  [[noreturn]] void refuse(const std::string& found) const;

 private:
  std::filesystem::path file_;
  std::string text_;
  std::string_view rest_, row_;
  size_t line_ = 1;
};

}  // namespace animado::controle
