// A picture of the bodies at one moment.
#pragma once

#include <span>

#include "visao/picture.hpp"
#include "visao/stage.hpp"

namespace animado::visao {

enum class Quality { film = 4, still = 16 };  // rays a pixel

// poses: of all bodies of the run. The same bytes for any number of cores.
Picture draw(const Stage& stage, std::span<const Pose> poses, const Camera& camera, Size size,
             Quality quality);

}  // namespace animado::visao
