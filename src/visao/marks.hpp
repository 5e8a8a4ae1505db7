// Rings around the points where bodies met. They lie over the picture: a point of contact is nearly always
// hidden between two bodies.
#pragma once

#include <span>
#include <vector>

#include "controle/results/recorded_run.hpp"
#include "visao/camera.hpp"
#include "visao/picture.hpp"

namespace animado::visao {

// The points of the impacts after one time and up to another, the strongest where there are many: a heap that
// settles would be all rings.
std::vector<Vec3> impact_points(const controle::RecordedRun& run, double after_s, double until_s);

void mark(Picture& picture, const Camera& camera, std::span<const Vec3> points_m);

}  // namespace animado::visao
