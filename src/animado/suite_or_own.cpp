#include "animado/suite_or_own.hpp"

#include "animado/in_process.hpp"

namespace animado {

std::unique_ptr<rpc::Suite> suite_or_own(const SuiteChoice& choice) {
  if (auto suite = find_suite(choice)) return suite;
  if (!choice.run.empty() || !choice.socket_dir.empty())
    return connect_to_suite(choice);  // says what is missing
  return suite_in_process();
}

}  // namespace animado
