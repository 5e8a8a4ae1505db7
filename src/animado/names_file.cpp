#include "animado/names_file.hpp"

#include "base/error.hpp"

namespace animado {

namespace {

constexpr std::string_view kFurther = "    ";  // opens a further line of an expression
constexpr std::string_view kEquals = " = ";

}  // namespace

std::string names_text(const interexpserv::Snapshot::Reply& snapshot) {
  std::string text = fmt::format("# animado names, version {}\n", snapshot.version);
  for (size_t i = 0; i < snapshot.names.size(); ++i) {
    text += snapshot.names[i];
    text += kEquals;
    for (const char c : snapshot.texts[i]) {
      text += c;
      if (c == '\n') text += kFurther;
    }
    text += '\n';
  }
  return text;
}

interexpserv::Snapshot::Reply names_in(std::string_view text, const std::string& where) {
  interexpserv::Snapshot::Reply snapshot;
  for (int number = 1; !text.empty(); ++number) {
    const size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.starts_with(kFurther) && !snapshot.texts.empty()) {
      snapshot.texts.back() += '\n';
      snapshot.texts.back() += line.substr(kFurther.size());
      continue;
    }
    if (line.empty() || line.starts_with('#')) continue;
    const size_t equals = line.find(kEquals);
    if (equals == std::string_view::npos) {
      throw Error(Code::syntax, "this is no definition", fmt::format("{}:{}", where, number),
                  "write `name = expression`, or # before a comment");
    }
    snapshot.names.emplace_back(line.substr(0, equals));
    snapshot.texts.emplace_back(line.substr(equals + kEquals.size()));
  }
  return snapshot;
}

}  // namespace animado
