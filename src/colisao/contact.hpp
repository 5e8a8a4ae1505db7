// A contact: where two bodies meet and along which direction they push each other.
#pragma once

#include "base/spatial.hpp"

namespace animado::colisao {

// How the collision plane was found, by the paper's rules (section 3.4.2): a face defines it; two edges that
// cross define it; two vertices have their joining line as its normal. A curved surface counts as a face
// where it is touched.
enum class ContactKind { vertex_face, edge_edge, vertex_vertex };

struct Contact {
  int a = 0, b = 0;             // bodies, a < b; a is the paper's object 1
  Vec3 point_m = Vec3::Zero();  // world, midway between the two surfaces
  Vec3 normal = Vec3::UnitX();  // the paper's k: unit, from b towards a; the impulse on a is along +normal
  double gap_m = 0;             // distance of the surfaces along the normal; negative when they overlap
  ContactKind kind = ContactKind::vertex_face;
  int feature =
      0;  // tells the contacts of a pair apart; the same feature has the same number at the next step
};

}  // namespace animado::colisao
