#include "egesp/server.hpp"
#include "rpc/daemon.hpp"

int main(int argc, char** argv) {
  return animado::rpc::run_daemon(
      argc, argv,
      {.name = "egesp",
       .manual = "Solves linear systems by Gauss–Jordan elimination with partial or complete pivoting; "
                 "inverts, finds "
                 "determinants and ranks. It knows no physics.",
       .example = "animado call egesp determinant '{\"matrices\": [[1, 2], [3, 4]]}'"},
      animado::egesp::fill_table);
}
