// What a body can be and do, in each component. A scene that starts beyond is refused, a motion that goes
// there has diverged.
#pragma once

namespace animado::controle {

inline constexpr double kUniverse_m = 1e27;  // what can be seen of it is as wide
inline constexpr double kSpeedOfLight_m_s = 299792458;
inline constexpr double kFastestTurn_rad_s = 3e23;  // the rim of a proton, 1e-15 m, has the speed of light

}  // namespace animado::controle
