#include "animado/exit_code.hpp"

namespace animado {

ExitCode exit_code_of(Code code) {
  switch (code) {
    case Code::refused:
      return kRefused;
    case Code::diverged:
      return kDiverged;
    case Code::unavailable:
    case Code::protocol:
    case Code::internal:
      return kLost;
    default:
      return kUsage;
  }
}

}  // namespace animado
