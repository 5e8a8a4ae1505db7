// The part of a solid's surface that faces a direction.
#pragma once

#include <boost/container/small_vector.hpp>

#include "base/spatial.hpp"

namespace animado::colisao {

// Points of a contact region. Few as a rule, so they live without an allocation.
using Points = boost::container::small_vector<Vec3, 16>;

// A convex piece of the true surface, nearly perpendicular to the direction it was asked for, in the frame of
// the solid.
//   one point: a vertex, an apex, or where a curved surface is touched;
//   two: an edge, or a straight line of a cylinder, a capsule or a cone;
//   more: a face, counter-clockwise seen from outside; of a disc (a cap or a base), eight points of its rim.
struct Feature {
  Points points_m;
  Vec3 normal = Vec3::Zero();  // of a face or a disc: outward, unit; else zero
  bool sharp = true;           // a vertex or an edge; false where the surface is smooth
  bool disc = false;
  Vec3 centre_m = Vec3::Zero();  // of the disc
  double radius_m = 0;           // of the disc
  int id = 0;                    // the same feature has the same number, whatever the direction

  bool is_face() const { return points_m.size() > 2; }
};

}  // namespace animado::colisao
