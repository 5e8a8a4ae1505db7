#include "animado/in_process.hpp"

#include "colisao/server.hpp"
#include "egesp/server.hpp"
#include "fred/server.hpp"
#include "interexpserv/server.hpp"
#include "rpc/local_suite.hpp"

namespace animado {

std::unique_ptr<rpc::Suite> suite_in_process(const std::filesystem::path& logs) {
  auto suite = std::make_unique<rpc::LocalSuite>(rpc::LocalSuite::Options{logs, {}});
  suite->add("interexpserv", interexpserv::fill_table);
  suite->add("egesp", egesp::fill_table);
  suite->add("fred", fred::fill_table);
  suite->add("colisao", colisao::fill_table);
  return suite;
}

}  // namespace animado
