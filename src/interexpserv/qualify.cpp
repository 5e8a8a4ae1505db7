#include "interexpserv/qualify.hpp"

#include "base/fold.hpp"
#include "interexpserv/lexer.hpp"

namespace animado::interexpserv {
namespace {

// Whether a name, or the vector whose component it is, lies in `home`.
bool lies_in(const Scope& scope, std::string_view home, const std::string& name) {
  const std::string full = std::string(home) + "." + name;
  if (scope.find(full)) return true;
  const size_t dot = full.rfind('.');
  return dot > home.size() && scope.find(full.substr(0, dot));
}

}  // namespace

std::string qualified(std::string_view text, const Scope& scope, std::string_view home) {
  std::string folded = fold(text);  // a character for each code point, so that columns are places in it
  std::string result;
  size_t copied = 0;
  for (const Token& token : tokenize({text, {}})) {
    if (token.kind != Token::Kind::name || !lies_in(scope, home, token.text)) continue;
    result += folded.substr(copied, token.column - copied) + std::string(home) + ".";
    copied = token.column;
  }
  return result + folded.substr(copied);
}

}  // namespace animado::interexpserv
