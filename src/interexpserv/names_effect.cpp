// How a change takes effect: what is named gets its new text, what looked it up is compiled again, and all of
// it is true at once or not at all.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "interexpserv/names_lookup.hpp"

namespace animado::interexpserv {
namespace {

bool says_the_same(const Revision& a, const Revision& b) {
  const bool typed = a.kind == Revision::Kind::binding;  // the type of a definition follows from its text
  return a.kind == b.kind && a.text == b.text && a.binding == b.binding && (!typed || a.type == b.type);
}

void refuse_other_type(const std::string& name, Type before, Type now) {
  if (before == now) return;
  throw Error(Code::type,
              fmt::format("`{}` is a {}, this would make it a {}", name, name_of(before), name_of(now)), name,
              "remove it first if it shall be something else");
}

void remember(std::vector<Revision>& past, Revision revision) {
  past.push_back(std::move(revision));
  if (past.size() == kRevisionsKept) past.erase(past.begin());
}

}  // namespace

// Puts back what was saved, the last first, unless it is told that all went well.
class Names::Undo {
 public:
  explicit Undo(Names& names) : names_(names) {}
  ~Undo() {
    for (auto step = steps_.rbegin(); step != steps_.rend(); ++step) take_back(*step);
  }
  Undo(const Undo&) = delete;
  Undo& operator=(const Undo&) = delete;

  // Lets the name stand for `now`.
  void revise(const std::string& name, Revision now) {
    const auto [at, is_new] = names_.entries_.try_emplace(name);
    Entry& entry = at->second;
    if (is_new) entry.place = names_.changed_.insert(names_.changed_.end(), &at->first);
    step(name, is_new ? Step::add : Step::revise).revision = std::exchange(entry.now, std::move(now));
  }
  void give_meaning(const std::string& name, Entry& entry, Meaning meaning) {
    step(name, Step::mean).meaning = entry.meaning;
    names_.give_meaning(name, entry, std::move(meaning));
  }
  // What stood there before becomes history.
  void keep() {
    for (Step& step : steps_) {
      if (step.kind == Step::revise)
        remember(names_.entries_.find(step.name)->second.past, std::move(step.revision));
    }
    steps_.clear();
  }

 private:
  struct Step {
    std::string name;
    enum Kind { add, revise, mean } kind = add;
    Revision revision;
    Meaning meaning;
  };
  Step& step(const std::string& name, Step::Kind kind) {
    Step& step = steps_.emplace_back();
    step.name = name;
    step.kind = kind;
    return step;
  }
  void take_back(Step& step) {
    const auto at = names_.entries_.find(step.name);
    if (step.kind == Step::mean) names_.give_meaning(step.name, at->second, std::move(step.meaning));
    if (step.kind == Step::revise) at->second.now = std::move(step.revision);
    if (step.kind != Step::add) return;
    names_.changed_.erase(at->second.place);
    names_.entries_.erase(at);
  }

  Names& names_;
  std::vector<Step> steps_;
};

Names::Meaning Names::compiled(const std::string& name, const Revision& revision) const {
  Meaning meaning{.version = revision.version, .type = revision.type};
  if (revision.kind != Revision::Kind::definition) return meaning;
  const Lookup scope(*this);
  const std::string home = home_of(name);
  Program program = home.empty() ? compile(revision.text, scope, name)
                                 : compile(revision.text, HomeScope(scope, home), name);
  meaning.type = program.type();
  meaning.looked_up = scope.looked_up();
  if (program.is_constant()) {
    meaning.constant = program.constant();
  } else {
    meaning.program = std::make_shared<const Program>(std::move(program));
  }
  return meaning;
}

void Names::give_meaning(const std::string& name, Entry& entry, Meaning meaning) {
  if (entry.meaning.looked_up != meaning.looked_up) {
    for (const std::string& used : entry.meaning.looked_up) {
      const auto users = users_.find(used);
      users->second.erase(name);
      if (users->second.empty()) users_.erase(users);
    }
    for (const std::string& used : meaning.looked_up) users_[used].insert(name);
  }
  entry.meaning = std::move(meaning);
}

// What is looked up while a definition is compiled includes what its own names look up: one step reaches all.
std::set<std::string> Names::affected_by(const Edits& edits) const {
  std::set<std::string> affected;
  for (const auto& [name, revision] : edits) {
    affected.insert(name);
    if (const auto users = users_.find(name); users != users_.end())
      affected.insert(users->second.begin(), users->second.end());
  }
  return affected;
}

// Compiles the name again: it is named in the request, or something that it uses is.
NameRow Names::renew(const std::string& name, std::optional<Type> type, Undo& undo) {
  Entry& entry = entries_.find(name)->second;
  Meaning meaning = compiled(name, entry.now);
  if (entry.now.kind == Revision::Kind::definition && type) refuse_other_type(name, *type, meaning.type);
  entry.now.type = meaning.type;  // which only changes where the whole revision is taken back
  meaning.version = version_ + 1;
  undo.give_meaning(name, entry, std::move(meaning));
  return {entry.now.kind, name, entry.now.text, entry.now.type, entry.now.binding, version_ + 1};
}

std::vector<NameRow> Names::take_effect(Edits edits, const Terms& terms) {
  refuse_unexpected(terms.expected);
  std::erase_if(edits, [&](const auto& edit) {
    const auto known = entries_.find(edit.first);
    return known != entries_.end() && says_the_same(known->second.now, edit.second);
  });
  if (edits.empty()) return {};
  const std::set<std::string> affected = affected_by(edits);
  std::map<std::string, Type> types;  // which they keep
  for (const std::string& name : affected) {
    if (const Entry* known = find(name)) types.emplace(name, known->now.type);
  }
  Undo undo(*this);
  for (auto& [name, revision] : edits) {
    revision.version = version_ + 1;
    revision.time_us = terms.time_us;
    revision.who = terms.who;
    undo.revise(name, std::move(revision));
  }
  std::vector<NameRow> rows;
  for (const std::string& name : affected) {
    const auto type = types.find(name);
    rows.push_back(renew(name, type == types.end() ? std::nullopt : std::optional(type->second), undo));
  }
  if (commit_) {
    std::vector<NamedRevision> revisions;
    for (const auto& [name, revision] : edits) revisions.push_back({name, entries_.find(name)->second.now});
    commit_(revisions);
  }
  ++version_;
  undo.keep();
  for (const NameRow& row : rows)
    changed_.splice(changed_.end(), changed_, entries_.find(row.name)->second.place);
  return rows;
}

// --- another life

void Names::load(std::vector<NamedRevision> revisions) {
  for (auto& [name, revision] : revisions) {
    version_ = std::max(version_, revision.version);
    const auto [at, is_new] = entries_.try_emplace(std::move(name));
    if (!is_new) remember(at->second.past, std::move(at->second.now));
    at->second.now = std::move(revision);
  }
  std::vector<std::pair<int64_t, const std::string*>> order;
  for (auto& [name, entry] : entries_) {
    Meaning meaning = compiled(name, entry.now);
    for (const std::string& used : meaning.looked_up) {
      const auto found = entries_.find(used);
      if (found != entries_.end()) meaning.version = std::max(meaning.version, found->second.now.version);
    }
    order.emplace_back(meaning.version, &name);
    give_meaning(name, entry, std::move(meaning));
  }
  std::ranges::stable_sort(order, {}, [](const auto& place) { return place.first; });
  for (const auto& [version, name] : order)
    entries_.find(*name)->second.place = changed_.insert(changed_.end(), name);
}

}  // namespace animado::interexpserv
