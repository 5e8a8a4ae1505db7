// Where two polyhedra meet: the paper's test (section 3.4.1).
//
// Every edge of one is tested against every face of the other, both ways, bounding boxes first, and each
// meeting gives a collision point. The paper leaves out: an edge in a face, a point in a face, vertices that
// meet, objects that coincide. Here they are meetings too, each told by its kind, and so are edges that cross
// or overlap, and a solid inside the other.
#pragma once

#include <vector>

#include "colisao/polyhedron.hpp"

namespace animado::colisao {

enum class Meeting {
  edge_face,      // an edge runs through the inside of a face
  vertex_face,    // a vertex lies in a face
  edge_edge,      // two edges cross in a point
  edge_overlap,   // two edges share a piece: its two ends
  vertex_edge,    // a vertex lies on an edge
  vertex_vertex,  // two vertices coincide
  inside,         // no surface meets, but one solid holds the other: one of its vertices
};

struct Crossing {
  Meeting kind;
  Vec3 point_m;  // world
};

// All meetings, each once, in an order that depends only on the input. Distances under tolerance_m count as
// zero. Empty when and only when the solids do not touch.
std::vector<Crossing> crossings(const Polyhedron& a, const Pose& pose_a, const Polyhedron& b,
                                const Pose& pose_b, double tolerance_m = 1e-9);

}  // namespace animado::colisao
