// Scenes of more than one experiment.
#pragma once

#include <string>

namespace animado::experiments {

// Falls 2 m under `world: gravity`, which it needs, with restitution 0.8.
inline std::string bouncing_ball(const std::string& end, const std::string& step) {
  return R"(
object floor
  shape plane(normal = (0, 1, 0), offset = 0)
  motion static
  restitution 1
object ball
  shape sphere(radius = 0.25)
  mass 1
  restitution 0.8
  position (0, 2.25, 0)
time
  end )" +
         end + "\n  step " + step + "\n";
}

// μ = 4π² and a half axis of 1 m: closes after 1 s. Eccentricity 0.3 from the perihelion.
inline constexpr auto kOrbit = R"(
object planet
  shape sphere(radius = 0.01)
  mass 1
  position (0.7, 0, 0)
  velocity (0, 2*pi*sqrt(1.3/0.7), 0)
  force -4*pi^2*planet.mass*position/norm(position)^3
time
  end 1
  step 1/16
)";

}  // namespace animado::experiments
