#include "animado/exit_code.hpp"

namespace animado {

namespace {

bool is_lost(Code code) {
  return code == Code::unavailable || code == Code::protocol || code == Code::internal;
}

}  // namespace

ExitCode exit_code_of_run(Code code) {
  if (code == Code::diverged) return kDiverged;
  return is_lost(code) ? kLost : kRefused;
}

ExitCode exit_code_of_call(Code code) {
  return is_lost(code) ? kLost : kUsage;
}

}  // namespace animado
