#include "colisao/server.hpp"
#include "rpc/daemon.hpp"

int main(int argc, char** argv) {
  return animado::rpc::run_daemon(argc, argv,
                                  {.name = "colisao",
                                   .manual = "Finds collisions of rigid bodies and answers them: contacts, "
                                             "times of impact, impulses, continuous contact and "
                                             "elastic forces. It knows shapes, poses, velocities and masses.",
                                   .example = "animado call colisao prepare '{\"bodies\": [{\"name\": "
                                              "\"ball\", \"shape\": \"sphere\", \"size_m\": [1], "
                                              "\"motion\": \"static\"}]}'"},
                                  animado::colisao::fill_table);
}
