// The registry as a scope for the compiler, which remembers what was asked of it.
#pragma once

#include <optional>

#include "interexpserv/names.hpp"

namespace animado::interexpserv {

// The namespace that a name lies in: ball of ball.mass.
inline std::string home_of(std::string_view name) {
  const size_t dot = name.rfind('.');
  return std::string(dot == std::string_view::npos ? "" : name.substr(0, dot));
}

class Names::Lookup : public Scope {
 public:
  explicit Lookup(const Names& names) : names_(names) {}

  std::optional<Symbol> find(std::string_view name) const override {
    looked_up_.emplace(name);
    last_ = name;
    const Entry* entry = names_.find(name);
    if (!entry) return name == "t" ? std::optional<Symbol>(Input{"t", Type::scalar}) : std::nullopt;
    const Revision& now = entry->now;
    if (now.kind == Revision::Kind::binding) return Input{last_, now.type};
    return Definition{last_, now.text, home_of(name)};
  }

  // Those near the last one that was asked for: it is the one that is suggested for.
  std::vector<std::string> known_names() const override { return names_.names_near(last_); }

  std::vector<std::string> looked_up() const { return {looked_up_.begin(), looked_up_.end()}; }

 private:
  const Names& names_;
  mutable std::set<std::string, std::less<>> looked_up_;
  mutable std::string last_;
};

}  // namespace animado::interexpserv
