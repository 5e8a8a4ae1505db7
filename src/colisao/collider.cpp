#include "colisao/collider.hpp"

#include <algorithm>

namespace animado::colisao {
namespace {

bool allows(const Collider& body, const std::string& group) {
  return body.collides_with.empty() ||
         std::find(body.collides_with.begin(), body.collides_with.end(), group) != body.collides_with.end();
}

}  // namespace

bool may_meet(const Collider& a, const Collider& b) {
  if (a.motion != Motion::dynamic && b.motion != Motion::dynamic) return false;
  return allows(a, b.group) && allows(b, a.group);
}

}  // namespace animado::colisao
