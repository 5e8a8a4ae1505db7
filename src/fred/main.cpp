#include "fred/server.hpp"
#include "rpc/daemon.hpp"

int main(int argc, char** argv) {
  return animado::rpc::run_daemon(argc, argv,
                                  {.name = "fred",
                                   .manual = "Integrates ordinary differential equations by Runge–Kutta "
                                             "methods, over arrays stage by stage or over a "
                                             "system of expressions. It knows no physics.",
                                   .example = "animado call fred integrate '{\"equations\": [\"x'\\'' = "
                                              "-x\"], \"from\": [{\"name\": \"x\", \"value\": 1}]}'"},
                                  animado::fred::fill_table);
}
