#include "controle/scene/state_names.hpp"

#include <array>

namespace animado::controle {
namespace {

struct NamedMember {
  std::string_view name;
  Member member;
};
constexpr std::array<NamedMember, 10> kMembers = {{{"position", Member::position},
                                                   {"orientation.qw", Member::qw},
                                                   {"orientation.qx", Member::qx},
                                                   {"orientation.qy", Member::qy},
                                                   {"orientation.qz", Member::qz},
                                                   {"velocity", Member::velocity},
                                                   {"angular_velocity", Member::angular_velocity},
                                                   {"mass", Member::mass},
                                                   {"force", Member::force},
                                                   {"local_force", Member::local_force}}};

}  // namespace

interexpserv::Type type_of(Member member) {
  switch (member) {
    case Member::position:
    case Member::velocity:
    case Member::angular_velocity:
    case Member::force:
    case Member::local_force:
      return interexpserv::Type::vector;
    default:
      return interexpserv::Type::scalar;
  }
}

StateNames::StateNames(const std::vector<std::string>& folded_object_names) {
  for (size_t i = 0; i < folded_object_names.size(); ++i)
    bodies_[folded_object_names[i]] = static_cast<int>(i);
}

std::optional<Reading> StateNames::find(std::string_view folded_name) const {
  if (folded_name == "t") return Reading{Member::time, -1};
  const size_t dot = folded_name.find('.');
  if (dot == std::string_view::npos) return std::nullopt;
  const auto body = bodies_.find(folded_name.substr(0, dot));
  if (body == bodies_.end()) return std::nullopt;
  for (const auto& [name, member] : kMembers) {
    if (name == folded_name.substr(dot + 1)) return Reading{member, body->second};
  }
  return std::nullopt;
}

std::vector<std::string> StateNames::known_names() const {
  std::vector<std::string> names = {"t"};
  for (const auto& [body, index] : bodies_) {
    for (const auto& [name, member] : kMembers) names.push_back(fmt::format("{}.{}", body, name));
  }
  return names;
}

}  // namespace animado::controle
