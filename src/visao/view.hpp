// What the user says of the camera, and the camera that this makes.
#pragma once

#include <optional>
#include <string>

#include "visao/camera.hpp"
#include "visao/stage.hpp"

namespace animado::visao {

struct View {
  std::optional<Vec3> eye_m;        // the camera stands here …
  std::optional<Vec3> look_at_m;    // … and looks there; at the middle of the motion when it is not said
  std::optional<Vec3> towards_eye;  // a named view: the direction, so far that all is in the picture
};

// "front", "side", "top", "three-quarter", or a point "(x, y, z)". Throws Error(bad_params).
void set_camera(View& view, const std::string& text);
Vec3 point_of(const std::string& text, const std::string& option);

// The direction in which the eye is; three-quarter where nothing else is said, from a corner that no wall
// hides.
Vec3 direction_of(const View& view, const Stage& stage);
Camera camera_of(const View& view, const Stage& stage, double aspect);

}  // namespace animado::visao
