#include "controle/overlap.hpp"

#include "base/error.hpp"
#include "base/state.hpp"
#include "colisao/client.hpp"
#include "controle/preparation.hpp"

namespace animado::controle {
namespace {

constexpr double kOverlap_m = 1e-6;  // touching is fine, and so is what rounding makes of it

std::vector<double> start_state(const Scene& scene) {
  const size_t n = scene.bodies.size();
  std::vector<double> state(kStateRows * n);
  for (size_t i = 0; i < n; ++i) {
    BodyState body;
    body.pose = {scene.bodies[i].position_m, scene.bodies[i].orientation};
    store_body(state.data(), n, i, body);
  }
  return state;
}

}  // namespace

void refuse_overlap(const Scene& scene, rpc::Suite& suite) {
  colisao::Client colisao(suite.channel("colisao"));
  colisao.prepare(colliders(scene));
  colisao::Contacts::Request request;
  request.state =
      rpc::Array::inlined({kStateRows, static_cast<int64_t>(scene.bodies.size())}, start_state(scene));
  request.margin_m = 0;
  for (const colisao::ContactRecord& contact : colisao.contacts(request).contacts) {
    if (contact.gap_m >= -kOverlap_m) continue;
    const Body &a = scene.bodies[static_cast<size_t>(contact.a)],
               &b = scene.bodies[static_cast<size_t>(contact.b)];
    const auto place = b.places.find("position");
    throw Error(Code::refused,
                fmt::format("`{}` and `{}` overlap at the start by {:.6g} m", a.name, b.name, -contact.gap_m),
                scene.where(place == b.places.end() ? Place{1, 1} : place->second),
                fmt::format("Move `{}` by at least that along ({:.6g}, {:.6g}, {:.6g}); touching is fine.",
                            b.name, -contact.normal[0], -contact.normal[1], -contact.normal[2]));
  }
}

}  // namespace animado::controle
