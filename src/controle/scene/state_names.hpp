// The names that every object opens in expressions (design, section 7): ball.position, ball.orientation.qw,
// ball.mass …
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "interexpserv/value.hpp"

namespace animado::controle {

enum class Member {
  time,  // t, of no body
  position,
  qw,
  qx,
  qy,
  qz,
  velocity,
  angular_velocity,
  mass,
  force,        // the sum of its force and local force lines, world axes
  local_force,  // of its local force lines, body axes
};

struct Reading {
  Member member = Member::time;
  int body = -1;
  bool operator==(const Reading&) const = default;
};

interexpserv::Type type_of(Member member);

class StateNames {
 public:
  explicit StateNames(const std::vector<std::string>& folded_object_names);

  std::optional<Reading> find(std::string_view folded_name) const;  // "t" too
  std::vector<std::string> known_names() const;

 private:
  std::map<std::string, int, std::less<>> bodies_;
};

}  // namespace animado::controle
