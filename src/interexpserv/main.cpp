#include <CLI/CLI.hpp>

#include "interexpserv/server.hpp"
#include "rpc/daemon.hpp"

int main(int argc, char** argv) {
  std::filesystem::path store;
  return animado::rpc::run_daemon(
      argc, argv,
      {.name = "interexpserv",
       .manual = "Keeps names and the expressions that they stand for, knows which service is where, and "
                 "owns the shared "
                 "arrays. Started first, at the one address that all know.",
       .example = "animado set spring.k '4*pi^2*2'; animado eval 'spring.k/2'",
       .add_options =
           [&](CLI::App& app) {
             app.add_option("--store", store,
                            "SQLite file that keeps the names; in memory only when left out");
           }},
      [&](animado::rpc::Service& service, animado::rpc::Suite&) {
        animado::interexpserv::fill_table_with_store(service, store);
      });
}
