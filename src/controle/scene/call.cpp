//   call     = NAME [ "(" [ argument { "," argument } ] ")" ]
//   argument = [ NAME "=" ] ( '"' characters '"' | expression )
#include "controle/scene/call.hpp"

#include "controle/scene/lines.hpp"
#include "controle/scene/refusal.hpp"

namespace animado::controle {
namespace {

class CallReader {
 public:
  CallReader(const Expression& value, std::string_view path, std::string_view expected)
      : value_(value), path_(path), expected_(expected), line_(value.place.line, value.text) {}

  Call run() {
    const size_t end = line_.end_of_word(0);
    if (end == 0) fail(0, fmt::format("expected {}", expected_));
    Call call{text().substr(0, end), place(0), {}};
    at_ = line_.skip_blanks(end);
    if (at_ < text().size() && text()[at_] == '(') read_arguments(call);
    if (at_ < text().size())
      fail(at_, fmt::format("expected the end of the line, found `{}`", line_.written(at_, text().size())));
    return call;
  }

 private:
  void read_arguments(Call& call) {
    const size_t opened = at_;
    at_ = line_.skip_blanks(at_ + 1);
    if (at_ < text().size() && text()[at_] == ')') {
      ++at_;
      return;
    }
    while (true) {
      call.arguments.push_back(read_argument(opened));
      if (text()[at_++] == ')') return;
    }
  }

  // Leaves at_ at the comma or parenthesis after it.
  Argument read_argument(size_t opened) {
    Argument argument;
    at_ = line_.skip_blanks(at_);
    argument.place = place(at_);
    const size_t word = line_.end_of_word(at_), equals = line_.skip_blanks(word);
    const bool named = word > at_ && equals < text().size() && text()[equals] == '=' &&
                       (equals + 1 == text().size() || text()[equals + 1] != '=');
    if (named) {
      argument.name = text().substr(at_, word - at_);
      at_ = line_.skip_blanks(equals + 1);
    }
    const size_t begin = at_;
    skip_value(opened);
    size_t end = at_;
    while (end > begin && text()[end - 1] == ' ') --end;
    if (begin == end) fail(begin, "an argument is empty");
    argument.value = {line_.written(begin, end), place(begin), value_.owner};
    if (text()[begin] == '"' && text()[end - 1] == '"' && end - begin >= 2)
      argument.text = line_.written(begin + 1, end - 1);
    return argument;
  }

  void skip_value(size_t opened) {
    int depth = 0;
    bool quoted = false;
    for (; at_ < text().size(); ++at_) {
      const char c = text()[at_];
      if (c == '"') quoted = !quoted;
      if (quoted) continue;
      if (depth == 0 && (c == ',' || c == ')')) return;
      depth += c == '(' ? 1 : c == ')' ? -1 : 0;
    }
    fail(opened, quoted ? "a quotation mark is never closed" : "the parenthesis is never closed");
  }

  const std::string& text() const { return line_.folded(); }
  Place place(size_t at) const { return {value_.place.line, value_.place.column + static_cast<int>(at)}; }
  [[noreturn]] void fail(size_t at, std::string message) const {
    refuse(path_, place(at), Code::syntax, std::move(message), fmt::format("write {}", expected_));
  }

  const Expression& value_;
  std::string_view path_, expected_;
  Line line_;
  size_t at_ = 0;
};

}  // namespace

Call parse_call(const Expression& value, std::string_view path, std::string_view expected) {
  return CallReader(value, path, expected).run();
}

}  // namespace animado::controle
