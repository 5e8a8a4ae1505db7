#include "report/log_line.hpp"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <vector>

namespace animado::report {
namespace {

using Words = std::vector<std::string_view>;

constexpr size_t kTime = 0, kMethod = 4;  // `time level module trace method`

Words words_of(std::string_view line) {
  Words words;
  while (!line.empty()) {
    const size_t end = std::min(line.find(' '), line.size());
    if (end > 0) words.push_back(line.substr(0, end));
    line.remove_prefix(std::min(end + 1, line.size()));
  }
  return words;
}

template <class Number>
std::optional<Number> number_of(std::string_view word) {
  Number number{};
  const char* end = word.data() + word.size();
  const auto [stop, status] = std::from_chars(word.data(), end, number);
  return status == std::errc() && stop == end ? std::optional(number) : std::nullopt;
}

}  // namespace

std::optional<SentCall> sent_call(std::string_view line) {
  const Words words = words_of(line);
  const size_t n = words.size();
  if (n < 6 || words[n - 1] != "µs" || words[n - 5] != "to" || !words[n - 4].ends_with(':')) return {};
  const auto took_us = number_of<double>(words[n - 2]);
  if (!took_us) return {};
  const std::string_view to = words[n - 4].substr(0, words[n - 4].size() - 1);
  return SentCall{std::string(words[kTime]), *took_us, std::string(to), std::string(words[n - 3])};
}

std::optional<StepEnd> step_end(std::string_view line) {
  if (!line.ends_with(" s")) return {};
  const Words words = words_of(line);
  const size_t n = words.size();
  if (n < 7 || words[n - 3] != "at" || words[n - 4] != "ends" || words[n - 6] != "step") return {};
  const auto step = number_of<int64_t>(words[n - 5]);
  const auto time_s = number_of<double>(words[n - 2]);
  if (!step || !time_s) return {};
  return StepEnd{*step, *time_s};
}

std::optional<ServedCall> served_call(std::string_view line) {
  const Words words = words_of(line);
  const auto unit = std::ranges::find(words, "µs");
  if (unit == words.end() || unit - words.begin() <= static_cast<ptrdiff_t>(kMethod) + 1) return {};
  const auto took_us = number_of<double>(*std::prev(unit));
  if (!took_us) return {};
  return ServedCall{std::string(words[kTime]), *took_us, std::string(words[kMethod])};
}

std::string_view time_of(std::string_view line) {
  return line.substr(0, line.find(' '));
}

double microseconds(std::string_view time) {
  constexpr std::string_view kShape = "2026-11-21T23:00:00.123456Z";
  if (time.size() != kShape.size()) return 0;
  const auto part = [&](size_t at, size_t size) {
    return number_of<double>(time.substr(at, size)).value_or(0);
  };
  return ((part(11, 2) * 60 + part(14, 2)) * 60 + part(17, 9)) * 1e6;
}

}  // namespace animado::report
