// The light of all pictures: a wide lamp to the viewer's left and above, and a bright sky that is darker
// below. Nothing glitters; forms and the places where things touch are what one sees.
#pragma once

#include "visao/camera.hpp"
#include "visao/color.hpp"
#include "visao/samples.hpp"

namespace animado::visao {

class Light {
 public:
  explicit Light(const Camera& camera);

  // Towards the lamp's points, one a point of the sequence; unit.
  const Vec3f& towards_lamp(uint32_t sample) const { return lamp_[sample]; }

  // A direction of the half space over a normal, the more often the nearer to it: as a matt surface collects
  // light.
  Vec3f towards_sky(const Vec3f& normal, uint32_t sample) const;

 private:
  std::array<Vec3f, kPoints> lamp_, sky_;  // the sky's over the normal (0, 0, 1)
};

inline const Vec3f kLampLight{0.78f, 0.75f, 0.70f};  // on a surface that faces it
Vec3f sky_light(const Vec3f& direction);             // from there, when nothing is in between
inline constexpr float kReflected = 0.2f;            // of the sky's light, from what is in between

inline const Vec3f kBackground{0.90f, 0.90f, 0.89f};  // where nothing is

// What a smooth skin adds to the lamp's light, for an eye in the direction `towards_eye`; all unit.
float gloss(const Vec3f& normal, const Vec3f& towards_lamp, const Vec3f& towards_eye);

}  // namespace animado::visao
