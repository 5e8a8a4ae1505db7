// An expression refused: the text is shown with a caret under the place.
#pragma once

#include <string>
#include <string_view>

#include "base/error.hpp"

namespace animado::interexpserv {

class ExpressionError : public Error {
 public:
  // column: 0-based code point of `text`. The message becomes three lines: what is wrong, the text, the
  // caret. Without a remedy it names the page of the language.
  ExpressionError(Code code, std::string_view what_is_wrong, std::string_view text, size_t column,
                  std::string_view where, std::string remedy);

  // The same failure for whoever used the name `definition`, in column `column` of another text: the message
  // still shows the text that is at fault.
  ExpressionError within(std::string_view definition, size_t column, std::string_view where) const;

  size_t column() const { return column_; }
  const std::string& what_is_wrong() const { return what_is_wrong_; }  // the first line alone

 private:
  ExpressionError(Code code, const std::string& message, std::string_view where, std::string remedy,
                  size_t column, std::string_view what_is_wrong);

  size_t column_;
  std::string what_is_wrong_;
};

// A text to be read and where it stands (file:line, a name): both appear in errors.
struct Source {
  std::string_view text;
  std::string_view where;

  [[noreturn]] void refuse(Code code, size_t column, std::string_view what_is_wrong,
                           std::string remedy = {}) const {
    throw ExpressionError(code, what_is_wrong, text, column, where, std::move(remedy));
  }
};

}  // namespace animado::interexpserv
