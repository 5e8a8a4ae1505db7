// The common region of two features that face each other: where it has its corners, and how far apart the
// surfaces are there.
#pragma once

#include <boost/container/small_vector.hpp>

#include "colisao/feature.hpp"

namespace animado::colisao {

struct Corner {
  Vec3 point_m;  // midway between the surfaces
  double gap_m;  // from b's surface to a's along the normal
  int code;      // tells the corners apart: the same for the same corners of the features
};
using Corners = boost::container::small_vector<Corner, 16>;

// Both features in the same axes, nearly perpendicular to the unit normal (from b to a), at least one of them
// not a point. Seen along the normal: the corners of the region that two faces share, the two ends of what a
// line shares with a face or with a line along it, the point where two lines cross, the point itself. Empty
// when the features miss each other. tolerance_m: corners nearer than this are one; tolerance_rad: lines at a
// smaller angle run along each other.
Corners overlap(const Feature& a, const Feature& b, const Vec3& normal, double tolerance_m,
                double tolerance_rad);

}  // namespace animado::colisao
