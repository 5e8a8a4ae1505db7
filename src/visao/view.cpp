#include "visao/view.hpp"

#include <array>
#include <cmath>
#include <sstream>
#include <utility>

#include "base/error.hpp"

namespace animado::visao {

namespace {

constexpr std::array<std::pair<std::string_view, std::array<double, 3>>, 3> kStraight = {
    {{"front", {0, 0, 1}}, {"side", {1, 0, 0}}, {"top", {0, 1, 0}}}};

bool is_in_front_of(const StagedPlane& plane, const Vec3& towards_eye) {
  return plane.normal.cast<double>().dot(towards_eye) > 0;
}

// A little above, a little aside: all three dimensions show, and what goes along x stays nearly in the
// picture's plane.
Vec3 three_quarter(const Stage& stage) {
  constexpr double kAside = 0.4, kAbove = 0.4;
  const Vec3 first(kAside, kAbove, 1);
  for (const Vec3& candidate :
       {first, Vec3(-kAside, kAbove, 1), Vec3(kAside, kAbove, -1), Vec3(-kAside, kAbove, -1)}) {
    const auto hides = [&](const StagedPlane& plane) { return !is_in_front_of(plane, candidate); };
    if (std::ranges::none_of(stage.planes, hides)) return candidate.normalized();
  }
  return first.normalized();
}

}  // namespace

Vec3 point_of(const std::string& text, const std::string& option) {
  std::istringstream in(text);
  Vec3 point;
  char open = 0, first = 0, second = 0, close = 0, more = 0;
  in >> open >> point.x() >> first >> point.y() >> second >> point.z() >> close;
  if (!in || open != '(' || first != ',' || second != ',' || close != ')' || in >> more ||
      !point.allFinite()) {
    throw Error(
        Code::bad_params, fmt::format("`{}` is not a point", text), option,
        "write it as \"(x, y, z)\", in metres" +
            std::string(option == "--camera" ? ", or name a view: front, side, top, three-quarter" : ""));
  }
  return point;
}

void set_camera(View& view, const std::string& text) {
  if (text == "three-quarter") return;
  for (const auto& [name, towards_eye] : kStraight) {
    if (text == name) {
      view.towards_eye = Vec3(towards_eye.data());
      return;
    }
  }
  view.eye_m = point_of(text, "--camera");
}

Vec3 direction_of(const View& view, const Stage& stage) {
  if (view.eye_m) return (*view.eye_m - view.look_at_m.value_or(stage.origin_m)).normalized();
  return view.towards_eye.value_or(three_quarter(stage));
}

Camera camera_of(const View& view, const Stage& stage, double aspect) {
  const Vec3 target_m = view.look_at_m.value_or(stage.origin_m);
  if (view.eye_m) {
    if ((*view.eye_m - target_m).norm() < 1e-9) {
      throw Error(Code::bad_params, "the camera stands where it looks", "--camera",
                  "move it, or look elsewhere (--look-at)");
    }
    return camera_at(*view.eye_m, target_m, aspect);
  }
  const Vec3 towards_eye = direction_of(view, stage);
  const Camera fitted = fitted_camera(stage.motion, towards_eye, aspect);
  if (!view.look_at_m) return fitted;
  const double distance_m = (fitted.eye_m - stage.origin_m).norm();
  return camera_at(target_m + distance_m * towards_eye, target_m, aspect);
}

}  // namespace animado::visao
