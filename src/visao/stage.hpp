// What of a run is there to be seen, apart from where it is at a moment: forms, colours, floors, and the room
// that the motion takes. Made once for all pictures of a run.
//
// Pictures are computed in single precision, about an origin amid the motion: far from the world's origin
// they are as sharp as near it.
#pragma once

#include <vector>

#include "controle/results/recorded_run.hpp"
#include "controle/results/tessellate.hpp"
#include "visao/camera.hpp"
#include "visao/color.hpp"

namespace animado::visao {

struct StagedBody {
  size_t index;                      // in the run
  Vec3f color;                       // linear
  double radius_m = 0;               // all of it is that near to its frame's origin
  double sphere_radius_m = 0;        // spheres are exact; others are triangles
  controle::TriangleMesh mesh = {};  // body frame
};

// Solid where normal · x ≤ offset, x from the stage's origin.
struct StagedPlane {
  Vec3f normal;
  float offset_m;
  Vec3f color;
  float grid_m;  // distance of its lines; 0: none
};

struct Stage {
  Vec3 origin_m;    // world
  double radius_m;  // of the ball about the origin that the motion takes
  std::vector<StagedBody> bodies;
  std::vector<StagedPlane> planes;
  std::vector<Ball> motion;  // what a camera is to show: the bodies that move, at all frames; world
};

Stage staged(const controle::RecordedRun& run);

}  // namespace animado::visao
