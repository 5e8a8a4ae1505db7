// How different two pictures look: the distance in CIE L*a*b* of the two, each blurred over 5 x 5 pixels
// first, so that an edge that moved by a part of a pixel, as another processor's roundings move it, is no
// difference. An eye sees about 2.3 side by side (Mahy et al. 1994).
#pragma once

#include "visao/picture.hpp"

namespace animado::visao {

struct Difference {
  double mean;   // over the picture: its light, its floors
  double worst;  // of all places: a small body that is missing is lost in a mean
};

Difference difference(const Picture& a, const Picture& b);  // infinite when their sizes differ

}  // namespace animado::visao
