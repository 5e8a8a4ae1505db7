#include "interexpserv/names.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/fold.hpp"
#include "base/nearest_name.hpp"
#include "interexpserv/parser.hpp"

namespace animado::interexpserv {
namespace {

using NameSet = std::set<std::string, std::less<>>;

std::string home_of(std::string_view name) {
  const size_t dot = name.rfind('.');
  return std::string(dot == std::string_view::npos ? "" : name.substr(0, dot));
}

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

bool says_the_same(const NameRow& a, const NameRow& b) {
  const bool typed = a.kind == NameRow::Kind::binding;  // the type of a definition follows from its text
  return a.kind == b.kind && a.text == b.text && a.binding == b.binding && (!typed || a.type == b.type);
}

void refuse_other_type(const NameRow* before, const NameRow& row) {
  if (!before || before->kind == NameRow::Kind::removed || before->type == row.type) return;
  throw Error(Code::type,
              fmt::format("`{}` is a {}, this would make it a {}", row.name, name_of(before->type),
                          name_of(row.type)),
              row.name, "remove it first if it shall be something else");
}

}  // namespace

bool is_within(std::string_view name, std::string_view prefix) {
  if (prefix.ends_with('.')) prefix.remove_suffix(1);
  if (prefix.empty() || name == prefix) return true;
  return name.size() > prefix.size() && name.starts_with(prefix) && name[prefix.size()] == '.';
}

// The names as a scope that remembers what was asked of it.
class Names::Lookup : public Scope {
 public:
  Lookup(const Names& names, NameSet& looked_up) : names_(names), looked_up_(looked_up) {}

  std::optional<Symbol> find(std::string_view name) const override {
    looked_up_.emplace(name);
    const Entry* entry = names_.find(name);
    if (!entry) return name == "t" ? std::optional<Symbol>(Input{"t", Type::scalar}) : std::nullopt;
    if (entry->row.kind == NameRow::Kind::binding) return Input{entry->row.name, entry->row.type};
    return Definition{entry->row.name, entry->row.text, home_of(name)};
  }

  std::vector<std::string> known_names() const override {
    std::vector<std::string> names;
    for (const auto& [name, entry] : names_.entries_) {
      if (entry.row.kind != NameRow::Kind::removed) names.push_back(name);
    }
    return names;
  }

 private:
  const Names& names_;
  NameSet& looked_up_;
};

// Puts back what was saved, unless it is told that all went well.
class Names::Undo {
 public:
  explicit Undo(Entries& entries) : entries_(entries) {}
  ~Undo() {
    if (kept_) return;
    for (auto& [name, entry] : before_) {
      if (entry) {
        entries_[name] = *entry;
      } else {
        entries_.erase(name);
      }
    }
  }
  Undo(const Undo&) = delete;
  Undo& operator=(const Undo&) = delete;

  void save(const std::string& name) {
    const auto found = entries_.find(name);
    before_.try_emplace(name, found == entries_.end() ? std::nullopt : std::optional(found->second));
  }
  const std::optional<Entry>& before(const std::string& name) const { return before_.at(name); }
  void keep() { kept_ = true; }

 private:
  Entries& entries_;
  std::map<std::string, std::optional<Entry>> before_;
  bool kept_ = false;
};

const Names::Entry* Names::find(std::string_view name) const {
  const auto found = entries_.find(name);
  if (found == entries_.end() || found->second.row.kind == NameRow::Kind::removed) return nullptr;
  return &found->second;
}

void Names::compile_entry(Entry& entry) const {
  entry.looked_up.clear();
  const Lookup scope(*this, entry.looked_up);
  const std::string& name = entry.row.name;
  const std::string home = home_of(name);
  const Program program = home.empty() ? compile(entry.row.text, scope, name)
                                       : compile(entry.row.text, HomeScope(scope, home), name);
  entry.row.type = program.type();
  entry.program = std::make_shared<const Program>(program);
}

void Names::restore(std::span<const NameRow> rows, int64_t version) {
  entries_.clear();
  version_ = version;
  for (const NameRow& row : rows) entries_[row.name].row = row;
  for (auto& [name, entry] : entries_) {
    if (entry.row.kind == NameRow::Kind::definition) compile_entry(entry);
  }
}

std::vector<NameRow> Names::define(std::span<const NamedText> definitions) {
  Entries edits;
  for (const NamedText& definition : definitions) {
    const std::string name = checked(definition.name);
    const Entry* known = find(name);
    if (known && known->row.kind == NameRow::Kind::binding) {
      throw Error(Code::conflict,
                  fmt::format("`{}` is live: its value is what a running program publishes", name), name,
                  "define what it follows from, as a force, or wait for the end of the run");
    }
    const NameRow row{NameRow::Kind::definition, name, definition.text, Type::scalar, {}, 0};
    if (!edits.try_emplace(name, Entry{row, nullptr, {}}).second) {
      throw Error(Code::bad_params, fmt::format("`{}` is defined twice in one request", name), name);
    }
  }
  return take_effect(std::move(edits));
}

std::vector<NameRow> Names::bind(std::span<const NamedBinding> bindings) {
  Entries edits;
  for (const auto& [written, type, binding] : bindings) {
    const std::string name = checked(written, true);
    const Entry* known = find(name);
    if (known && known->row.kind == NameRow::Kind::definition) {
      throw Error(Code::conflict, fmt::format("`{}` is defined as `{}`", name, known->row.text), name,
                  "remove it first");
    }
    edits[name].row = {NameRow::Kind::binding, name, {}, type, binding, 0};
  }
  return take_effect(std::move(edits));
}

std::vector<NameRow> Names::remove(std::span<const std::string> names) {
  Entries edits;
  for (const std::string& written : names) {
    const auto known = entries_.find(fold(written));
    const std::string name = known == entries_.end() ? row(written).name : known->first;
    edits[name].row = {NameRow::Kind::removed, name, {}, Type::scalar, {}, 0};
  }
  try {
    return take_effect(std::move(edits));
  } catch (const ExpressionError& error) {
    throw Error(Code::conflict, fmt::format("{} needs what is to be removed", error.where()), error.where(),
                "redefine it first, or remove it in the same request");
  }
}

// Compiles what changed and what looked it up, then lets all of it be true at once.
std::vector<NameRow> Names::take_effect(Entries edits) {
  std::erase_if(edits, [&](const auto& edit) {
    const auto known = entries_.find(edit.first);
    return known != entries_.end() && says_the_same(known->second.row, edit.second.row);
  });
  if (edits.empty()) return {};
  Undo undo(entries_);
  for (const auto& [name, entry] : edits) {
    undo.save(name);
    entries_[name] = entry;
  }
  std::vector<NameRow> rows;
  for (auto& [name, entry] : entries_) {
    const auto is_edited = [&](const std::string& looked_up) { return edits.contains(looked_up); };
    if (!is_edited(name) && std::none_of(entry.looked_up.begin(), entry.looked_up.end(), is_edited)) continue;
    undo.save(name);
    entry.row.version = version_ + 1;
    if (entry.row.kind == NameRow::Kind::definition) {
      compile_entry(entry);
      refuse_other_type(undo.before(name) ? &undo.before(name)->row : nullptr, entry.row);
    }
    rows.push_back(entry.row);
  }
  if (commit_) commit_(version_ + 1, rows);
  ++version_;
  undo.keep();
  return rows;
}

const NameRow& Names::row(std::string_view name) const {
  if (const Entry* entry = find(fold(name))) return entry->row;
  NameSet unused;
  const std::string near = nearest_name(fold(name), Lookup(*this, unused).known_names());
  throw Error(Code::unknown_name, fmt::format("unknown name `{}`", name), std::string(name),
              near.empty() ? "list shows the names that are known" : fmt::format("did you mean `{}`?", near));
}

std::vector<NameRow> Names::rows(std::string_view prefix) const {
  const std::string folded = fold(prefix);
  std::vector<NameRow> rows;
  for (const auto& [name, entry] : entries_) {
    if (entry.row.kind != NameRow::Kind::removed && is_within(name, folded)) rows.push_back(entry.row);
  }
  return rows;
}

std::vector<NameRow> Names::changes(int64_t since_version) const {
  const bool from_another_life = since_version > version_;  // the registry was restarted without a store
  std::vector<NameRow> rows;
  for (const auto& [name, entry] : entries_) {
    const bool live = entry.row.kind == NameRow::Kind::binding;
    if (!live && (from_another_life || entry.row.version > since_version)) rows.push_back(entry.row);
  }
  std::stable_sort(rows.begin(), rows.end(),
                   [](const auto& a, const auto& b) { return a.version < b.version; });
  return rows;
}

Value Names::value(std::string_view name, const Numbers& numbers) const {
  const NameRow& known = row(name);
  if (known.kind == NameRow::Kind::definition) return run(*find(known.name)->program, numbers);
  Value value{known.type, {}};
  read({known.name, known.type}, numbers, value.v.data());
  return value;
}

Value Names::evaluate(std::string_view text, std::string_view home, const Numbers& numbers) const {
  NameSet unused;
  const Lookup scope(*this, unused);
  return run(home.empty() ? compile(text, scope) : compile(text, HomeScope(scope, home)), numbers);
}

Value Names::run(const Program& program, const Numbers& numbers) const {
  std::vector<double> inputs(program.input_count());
  double* next = inputs.data();
  for (const Input& input : program.inputs()) {
    read(input, numbers, next);
    next += width_of(input.type);
  }
  Value value{program.type(), {}};
  program.evaluate(inputs.data(), value.v.data());
  return value;
}

void Names::read(const Input& input, const Numbers& numbers, double* out) const {
  const Entry* entry = find(input.name);
  if (!entry) {  // only t may be used before it is bound
    throw Error(Code::unavailable, "t has no value: no run is going", input.name,
                "start a run, or leave t out");
  }
  const Binding& binding = entry->row.binding;
  const std::span<const double> array = numbers(binding.array);
  for (size_t k = 0; k < width_of(input.type); ++k) {
    const int64_t at = binding.element + static_cast<int64_t>(k) * binding.stride;
    if (at < 0 || at >= static_cast<int64_t>(array.size())) {
      throw Error(Code::bad_shape,
                  fmt::format("`{}` is bound to element {} of {}, which has {}", input.name, at,
                              binding.array, array.size()),
                  input.name, "bind it again");
    }
    out[k] = array[static_cast<size_t>(at)];
  }
}

}  // namespace animado::interexpserv
