#include "interexpserv/scope.hpp"

#include "base/fold.hpp"

namespace animado::interexpserv {

MapScope& MapScope::set(std::string_view name, Value value) {
  symbols_[fold(name)] = value;
  return *this;
}

MapScope& MapScope::input(std::string_view name, Type type) {
  symbols_[fold(name)] = Input{fold(name), type};
  return *this;
}

MapScope& MapScope::define(std::string_view name, std::string text, std::string_view home) {
  symbols_[fold(name)] = Definition{fold(name), std::move(text), fold(home)};
  return *this;
}

std::optional<Symbol> MapScope::find(std::string_view name) const {
  const auto found = symbols_.find(name);
  if (found == symbols_.end()) return std::nullopt;
  return found->second;
}

std::vector<std::string> MapScope::known_names() const {
  std::vector<std::string> names;
  for (const auto& [name, symbol] : symbols_) names.push_back(name);
  return names;
}

HomeScope::HomeScope(const Scope& outer, std::string_view home) : outer_(outer), prefix_(fold(home) + ".") {}

std::optional<Symbol> HomeScope::find(std::string_view name) const {
  if (auto own = outer_.find(prefix_ + std::string(name))) return own;
  return outer_.find(name);
}

std::vector<std::string> HomeScope::known_names() const {
  std::vector<std::string> names = outer_.known_names();
  const size_t count = names.size();
  for (size_t i = 0; i < count; ++i) {
    if (names[i].starts_with(prefix_)) names.push_back(names[i].substr(prefix_.size()));
  }
  return names;
}

}  // namespace animado::interexpserv
