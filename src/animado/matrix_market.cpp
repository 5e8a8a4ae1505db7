#include "animado/matrix_market.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>

#include "base/error.hpp"

namespace animado {
namespace {

constexpr int64_t kLongestSide = 1 << 24;
constexpr int64_t kMostValues = 1 << 26;  // 0.5 GiB

enum class Symmetry { general, symmetric, skew };

bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

class Parser {
 public:
  Parser(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  MarketMatrix parse() {
    read_header();
    if (!next_content()) refuse("the file ends before the size of the matrix", "give rows and columns");
    matrix_.rows = integer("the number of rows", 0, kLongestSide);
    matrix_.columns = integer("the number of columns", 0, kLongestSide);
    if (symmetry_ != Symmetry::general && matrix_.rows != matrix_.columns)
      refuse(fmt::format("a symmetric matrix of {} × {}", matrix_.rows, matrix_.columns),
             "such a matrix is square");
    matrix_.sparse ? read_coordinates() : read_array();
    if (next_content()) refuse("there is more than the size of the matrix says", "correct the size line");
    return std::move(matrix_);
  }

 private:
  [[noreturn]] void refuse(const std::string& what, const std::string& remedy,
                           Code code = Code::syntax) const {
    throw Error(code, what, fmt::format("{}:{}", file_, line_number_), remedy);
  }

  bool next_line() {
    if (text_.empty()) return false;
    const size_t end = std::min(text_.find('\n'), text_.size());
    line_ = text_.substr(0, end);
    text_.remove_prefix(std::min(end + 1, text_.size()));
    ++line_number_;
    return true;
  }

  // The next line that is neither empty nor a comment, after the words of the last one were used up.
  bool next_content() {
    if (line_number_ > 1 && next_word())
      refuse(fmt::format("`{}` is too much on this line", shown(word_)), "remove it");
    while (next_line()) {
      std::string_view rest = line_;
      while (!rest.empty() && is_space(rest.front())) rest.remove_prefix(1);
      if (!rest.empty() && rest.front() != '%') return true;
      line_ = {};
    }
    return false;
  }

  bool next_word() {
    while (!line_.empty() && is_space(line_.front())) line_.remove_prefix(1);
    size_t length = 0;
    while (length < line_.size() && !is_space(line_[length])) ++length;
    word_ = line_.substr(0, length);
    line_.remove_prefix(length);
    return length > 0;
  }

  // A word of the file, fit for a message.
  static std::string shown(std::string_view word) {
    std::string text(word.substr(0, 40));
    for (char& c : text) c = c >= ' ' && c <= '~' ? c : '?';
    return text;
  }

  bool word_is(std::string_view wanted) const {
    return std::ranges::equal(word_, wanted, {},
                              [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  }

  // Which of the words stands next.
  size_t choice(std::string_view what, std::span<const std::string_view> words) {
    next_word();
    for (size_t i = 0; i < words.size(); ++i) {
      if (word_is(words[i])) return i;
    }
    refuse(fmt::format("`{}` as the {}", shown(word_), what),
           fmt::format("{} can be read", fmt::join(words, ", ")));
  }

  void read_header() {
    static constexpr std::string_view kFormats[] = {"coordinate", "array"},
                                      kFields[] = {"real", "integer", "pattern", "double"},
                                      kSymmetries[] = {"general", "symmetric", "skew-symmetric"};
    if (next_line()) next_word();
    line_number_ = 1;
    if (!word_is("%%matrixmarket")) {
      refuse("this is no Matrix Market file",
             "its first line is `%%MatrixMarket matrix coordinate real general` or another of that kind");
    }
    choice("kind of object", std::array{std::string_view("matrix")});
    matrix_.sparse = choice("format", kFormats) == 0;
    pattern_ = choice("kind of numbers", kFields) == 2;
    symmetry_ = static_cast<Symmetry>(choice("symmetry", kSymmetries));
    if (next_word()) refuse(fmt::format("`{}` is too much on this line", shown(word_)), "remove it");
    if (pattern_ && (!matrix_.sparse || symmetry_ == Symmetry::skew))
      refuse("a pattern that is an array or skew-symmetric",
             "a pattern is given by coordinates, general or symmetric");
  }

  int64_t integer(std::string_view what, int64_t least, int64_t most) {
    int64_t value = 0;
    if (!next_word()) refuse(fmt::format("{} is missing", what), "give it on this line");
    const auto [end, problem] = std::from_chars(word_.data(), word_.data() + word_.size(), value);
    if (problem == std::errc::result_out_of_range ||
        (problem == std::errc() && (value < least || value > most)))
      refuse(fmt::format("{} is {}", what, shown(word_)), fmt::format("it can be {} to {}", least, most));
    if (problem != std::errc() || end != word_.data() + word_.size())
      refuse(fmt::format("`{}` is no integer ({})", shown(word_), what), "give an integer");
    return value;
  }

  double number() {
    if (!next_word()) refuse("a value is missing", "give it on this line");
    std::string_view digits = word_;
    if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-') digits.remove_prefix(1);
    double value = 0;
    const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (end != digits.data() + digits.size() || problem == std::errc::invalid_argument)
      refuse(fmt::format("`{}` is no number", shown(word_)), "numbers look like -1.5e-3");
    if (problem == std::errc::result_out_of_range || !std::isfinite(value))
      refuse(fmt::format("`{}` is not a finite double", shown(word_)), "give finite numbers only",
             Code::not_finite);
    return value;
  }

  void add(int64_t row, int64_t column, double value) {
    matrix_.at_row.push_back(static_cast<double>(row));
    matrix_.at_column.push_back(static_cast<double>(column));
    matrix_.values.push_back(value);
  }

  void read_coordinates() {
    const int64_t count = integer("the number of entries", 0, kMostValues);
    // Each entry takes four characters at least: the claim is not believed beyond that.
    const auto likely = std::min(static_cast<size_t>(count), text_.size() / 4 + 1);
    for (auto* list : {&matrix_.at_row, &matrix_.at_column, &matrix_.values}) list->reserve(likely);
    for (int64_t entry = 0; entry < count; ++entry) {
      if (!next_content())
        refuse(fmt::format("the file ends after {} of {} entries", entry, count), "is it cut off?");
      const int64_t row = integer("the row", 1, matrix_.rows) - 1;
      const int64_t column = integer("the column", 1, matrix_.columns) - 1;
      const double value = pattern_ ? 1 : number();
      if (symmetry_ != Symmetry::general && column > row)
        refuse("an entry above the diagonal", "a symmetric file holds the diagonal and what is below it");
      if (symmetry_ == Symmetry::skew && column == row)
        refuse("an entry on the diagonal", "a skew-symmetric matrix has zeros there, and leaves them out");
      add(row, column, value);
      if (symmetry_ != Symmetry::general && row != column)
        add(column, row, symmetry_ == Symmetry::skew ? -value : value);
    }
  }

  // Column by column; of a symmetric one the diagonal (not of a skew one) and what is below it.
  void read_array() {
    const int64_t rows = matrix_.rows, columns = matrix_.columns;
    if (rows * columns > kMostValues || rows * columns > 2 * static_cast<int64_t>(text_.size()) + 2) {
      refuse(
          fmt::format("{} × {} values are more than the file can hold, or than can be read", rows, columns),
          fmt::format("at most {} can be read", kMostValues), Code::limit);
    }
    matrix_.values.assign(static_cast<size_t>(rows * columns), 0.0);
    const auto at = [&](int64_t i, int64_t j) -> double& {
      return matrix_.values[static_cast<size_t>(i * columns + j)];
    };
    for (int64_t j = 0; j < columns; ++j) {
      const int64_t first = symmetry_ == Symmetry::general ? 0 : symmetry_ == Symmetry::symmetric ? j : j + 1;
      for (int64_t i = first; i < rows; ++i) {
        if (!next_content())
          refuse(fmt::format("the file ends before element ({}, {})", i + 1, j + 1), "is it cut off?");
        at(i, j) = number();
        if (symmetry_ != Symmetry::general && i != j)
          at(j, i) = symmetry_ == Symmetry::skew ? -at(i, j) : at(i, j);
      }
    }
  }

  std::string_view text_, line_, word_;
  const std::string& file_;
  size_t line_number_ = 0;
  Symmetry symmetry_ = Symmetry::general;
  bool pattern_ = false;
  MarketMatrix matrix_;
};

}  // namespace

std::vector<double> MarketMatrix::dense() const {
  if (!sparse) return values;
  if (rows * columns > kMostValues) {
    throw Error(Code::limit, fmt::format("{} × {} elements are too many for a dense matrix", rows, columns),
                {}, "solve it as a sparse system");
  }
  std::vector<double> full(static_cast<size_t>(rows * columns));
  for (size_t e = 0; e < values.size(); ++e)
    full[static_cast<size_t>(at_row[e]) * static_cast<size_t>(columns) + static_cast<size_t>(at_column[e])] +=
        values[e];
  return full;
}

MarketMatrix parse_matrix_market(std::string_view text, const std::string& file) {
  return Parser(text, file).parse();
}

MarketMatrix read_matrix_market(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string text(std::istreambuf_iterator<char>(in), {});
  if (!in && text.empty()) {
    throw Error(Code::unknown_name, "the file cannot be read", file.string(),
                "is it there, and may you read it?");
  }
  return parse_matrix_market(text, file.string());
}

std::string matrix_market_text(int64_t rows, int64_t columns, std::span<const double> row_major) {
  std::string text = fmt::format("%%MatrixMarket matrix array real general\n{} {}\n", rows, columns);
  for (int64_t j = 0; j < columns; ++j) {
    for (int64_t i = 0; i < rows; ++i)
      fmt::format_to(std::back_inserter(text), "{}\n", row_major[static_cast<size_t>(i * columns + j)]);
  }
  return text;
}

}  // namespace animado
