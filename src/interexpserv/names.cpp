// What may be asked of the registry. How a change takes effect is in names_effect.cpp, values are in
// names_value.cpp.
#include "interexpserv/names.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/fold.hpp"
#include "base/nearest_name.hpp"
#include "interexpserv/parser.hpp"

namespace animado::interexpserv {
namespace {

// Names that a suggestion is chosen from: to compare a word with a million of them would hold up everybody.
constexpr ptrdiff_t kSuggested = 2000;

bool is_identifier(std::string_view word) {
  if (word.empty() || (word[0] >= '0' && word[0] <= '9')) return false;
  return std::all_of(word.begin(), word.end(),
                     [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; });
}

// The folded name. `may_be_t`: time can be bound, though nobody may define it.
std::string checked(const std::string& written, bool may_be_t = false) {
  const std::string name = fold(written);
  if (may_be_t && name == "t") return name;
  for (size_t begin = 0; begin <= name.size();) {
    const size_t end = std::min(name.find('.', begin), name.size());
    const std::string_view word = std::string_view(name).substr(begin, end - begin);
    if (!is_identifier(word)) {
      throw Error(Code::bad_params, fmt::format("`{}` is no name", written), "name",
                  "write identifiers joined by dots: spring.k");
    }
    if (is_reserved(word)) {
      throw Error(Code::bad_params, fmt::format("`{}` is a word of the language", word), written,
                  "choose another name");
    }
    begin = end + 1;
  }
  return name;
}

// "f(x)" defined as "x^2" is f defined as "(x) = x^2".
NamedText as_stored(const NamedText& definition) {
  const size_t open = definition.name.find('(');
  if (open == std::string::npos) return definition;
  const size_t end = open == 0 ? std::string::npos : definition.name.find_last_not_of(' ', open - 1);
  return {definition.name.substr(0, end == std::string::npos ? 0 : end + 1),
          definition.name.substr(open) + " = " + definition.text};
}

[[noreturn]] void refuse_needed(const ExpressionError& error) {
  throw Error(Code::conflict, fmt::format("{} needs what is to be removed", error.where()), error.where(),
              "redefine it first, or remove it in the same request");
}

}  // namespace

bool is_within(std::string_view name, std::string_view prefix) {
  if (prefix.ends_with('.')) prefix.remove_suffix(1);
  if (prefix.empty() || name == prefix) return true;
  return name.size() > prefix.size() && name.starts_with(prefix) && name[prefix.size()] == '.';
}

std::string folded_prefix(std::string_view written) {
  std::string prefix = fold(written);
  if (prefix.ends_with('*')) prefix.pop_back();
  const bool whole = prefix.size() == written.size() || prefix.empty() || prefix.ends_with('.');
  if (prefix.find('*') != std::string::npos || !whole) {
    throw Error(Code::bad_params, fmt::format("`{}` is no namespace", written), "prefix",
                "write ball, ball. or ball.* for all within ball; a star stands for all names");
  }
  if (prefix.ends_with('.')) prefix.pop_back();
  return prefix;
}

// --- requests

void Names::add_definitions(std::span<const NamedText> definitions, Edits& edits) const {
  for (const NamedText& definition : definitions) {
    const auto [written, text] = as_stored(definition);
    const std::string name = checked(written);
    const Entry* known = find(name);
    if (known && known->now.kind == Revision::Kind::binding) {
      throw Error(Code::conflict,
                  fmt::format("`{}` is live: its value is what a running program publishes", name), name,
                  "define what it follows from, as a force, or wait for the end of the run");
    }
    if (!edits.try_emplace(name, Revision{.text = text}).second) {
      throw Error(Code::bad_params, fmt::format("`{}` is defined twice in one request", name), name,
                  "define it once");
    }
  }
}

std::vector<NameRow> Names::define(std::span<const NamedText> definitions, const Terms& terms) {
  Edits edits;
  add_definitions(definitions, edits);
  return take_effect(std::move(edits), terms);
}

std::vector<NameRow> Names::bind(std::span<const NamedBinding> bindings, const Terms& terms) {
  Edits edits;
  for (const auto& [written, type, binding] : bindings) {
    const std::string name = checked(written, true);
    const Entry* known = find(name);
    if (known && known->now.kind == Revision::Kind::definition) {
      throw Error(Code::conflict, fmt::format("`{}` is defined as `{}`", name, known->now.text), name,
                  "remove it first");
    }
    edits[name] = {.kind = Revision::Kind::binding, .type = type, .binding = binding};
  }
  return take_effect(std::move(edits), terms);
}

std::vector<NameRow> Names::remove(std::span<const std::string> names, const Terms& terms) {
  Edits edits;
  for (const std::string& written : names) {
    const std::string name = fold(written);
    if (!entries_.contains(name)) known(name);  // says what is near
    edits[name] = {.kind = Revision::Kind::removed};
  }
  try {
    return take_effect(std::move(edits), terms);
  } catch (const ExpressionError& error) {
    refuse_needed(error);
  }
}

std::vector<NameRow> Names::replace(std::span<const NamedText> definitions, std::string_view prefix,
                                    const Terms& terms) {
  Edits edits;
  add_definitions(definitions, edits);
  for (const auto& [name, revision] : edits) {
    if (is_within(name, prefix)) continue;
    throw Error(Code::bad_params, fmt::format("`{}` does not lie within `{}`", name, prefix), name,
                "restore with the prefix of the snapshot");
  }
  for_each_within(prefix, [&](const std::string& name, const Entry& entry) {
    if (entry.now.kind != Revision::Kind::definition) return;
    edits.try_emplace(name, Revision{.kind = Revision::Kind::removed});
  });
  try {
    return take_effect(std::move(edits), terms);
  } catch (const ExpressionError& error) {
    if (is_within(error.where(), prefix)) throw;
    refuse_needed(error);
  }
}

void Names::refuse_unexpected(std::span<const ExpectedVersion> expected) const {
  for (const auto& [written, version] : expected) {
    const std::string name = fold(written);
    const int64_t found = version_of(name);
    if (found == version) continue;
    const auto entry = entries_.find(name);
    const std::string maker = entry == entries_.end() || entry->second.now.who.empty()
                                  ? ""
                                  : fmt::format(", last changed by {}", entry->second.now.who);
    throw Error(Code::conflict,
                found == 0 ? fmt::format("`{}` is not there{}; version {} was expected", name, maker, version)
                           : fmt::format("`{}` has version {}{}; {} was expected", name, found, maker,
                                         version == 0 ? "that it is not there" : std::to_string(version)),
                name, "get it, and decide again");
  }
}

// --- questions

const Names::Entry* Names::find(std::string_view name) const {
  const auto found = entries_.find(name);
  if (found == entries_.end() || found->second.now.kind == Revision::Kind::removed) return nullptr;
  return &found->second;
}

int64_t Names::version_of(std::string_view name) const {
  const Entry* entry = find(name);
  return entry ? entry->meaning.version : 0;
}

std::vector<std::string> Names::names_near(std::string_view name) const {
  std::vector<std::string> names;
  const auto add = [&](const auto& entry) {
    if (entry.second.now.kind != Revision::Kind::removed) names.push_back(entry.first);
  };
  auto from = entries_.lower_bound(name), to = from;
  for (ptrdiff_t i = 0; i < kSuggested && from != entries_.begin(); ++i) --from;
  for (ptrdiff_t i = 0; i < kSuggested && to != entries_.end(); ++i) ++to;
  std::for_each(from, to, add);
  return names;
}

const Names::Entry& Names::known(std::string_view written) const {
  const std::string name = fold(written);
  if (const Entry* entry = find(name)) return *entry;
  const std::string near = nearest_name(name, names_near(name));
  throw Error(
      Code::unknown_name, fmt::format("unknown name `{}`", written), std::string(written),
      near.empty() ? "animado get shows the names that are known" : fmt::format("did you mean `{}`?", near));
}

namespace {

NameRow row_of(const std::string& name, const Revision& now, int64_t version) {
  return {now.kind, name, now.text, now.type, now.binding, version};
}

}  // namespace

NameRow Names::row(std::string_view name) const {
  const Entry& entry = known(name);
  return row_of(fold(name), entry.now, entry.meaning.version);
}

// What lies in a namespace stands together: `.` comes before all that a name is written with.
template <class F>
void Names::for_each_within(std::string_view prefix, F&& visit) const {
  for (auto at = entries_.lower_bound(prefix); at != entries_.end() && is_within(at->first, prefix); ++at)
    visit(at->first, at->second);
}

std::vector<NameRow> Names::rows(std::string_view prefix) const {
  std::vector<NameRow> rows;
  for_each_within(folded_prefix(prefix), [&](const std::string& name, const Entry& entry) {
    if (entry.now.kind != Revision::Kind::removed)
      rows.push_back(row_of(name, entry.now, entry.meaning.version));
  });
  return rows;
}

std::vector<NamedText> Names::definitions(std::string_view prefix) const {
  std::vector<NamedText> all;
  for_each_within(folded_prefix(prefix), [&](const std::string& name, const Entry& entry) {
    if (entry.now.kind == Revision::Kind::definition) all.push_back({name, entry.now.text});
  });
  return all;
}

std::vector<NameRow> Names::changes(int64_t since_version) const {
  // A version that is not reached yet: the registry was restarted without a store.
  const int64_t since = since_version > version_ ? -1 : since_version;
  std::vector<NameRow> rows;
  for (auto name = changed_.rbegin(); name != changed_.rend(); ++name) {
    const Entry& entry = entries_.find(**name)->second;
    if (entry.meaning.version <= since) break;
    if (entry.now.kind != Revision::Kind::binding)
      rows.push_back(row_of(**name, entry.now, entry.meaning.version));
  }
  std::ranges::sort(rows, {}, [](const NameRow& row) { return std::tie(row.version, row.name); });
  return rows;
}

std::vector<Revision> Names::history(std::string_view name) const {
  const auto found = entries_.find(fold(name));
  const Entry& entry = found == entries_.end() ? known(name) : found->second;
  std::vector<Revision> revisions = entry.past;
  revisions.push_back(entry.now);
  return revisions;
}

}  // namespace animado::interexpserv
