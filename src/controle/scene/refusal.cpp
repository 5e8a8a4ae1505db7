#include "controle/scene/refusal.hpp"

#include "base/nearest_name.hpp"

namespace animado::controle {

void refuse(std::string_view path, Place place, Code code, std::string message, std::string remedy) {
  throw Error(code, std::move(message), fmt::format("{}:{}:{}", path, place.line, place.column),
              std::move(remedy));
}

std::string suggestion(std::string_view word, std::span<const std::string> known, std::string otherwise) {
  const std::string near = nearest_name(word, known);
  return near.empty() ? otherwise : fmt::format("did you mean `{}`?", near);
}

std::string list_of(std::span<const std::string> words) {
  std::string text;
  for (size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? " or " : ", ";
    text += words[i];
  }
  return text;
}

}  // namespace animado::controle
