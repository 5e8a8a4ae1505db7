// The exit codes of the command line: part of the interface, see docs/architecture.md.
#pragma once

#include "base/error.hpp"

namespace animado {

enum ExitCode : int {
  kDone = 0,
  kUsage = 2,     // the command line makes no sense, or what it asks for is refused
  kRefused = 3,   // the scene cannot be read, or is physical nonsense
  kDiverged = 4,  // the motion left the finite
  kLost = 5,      // a service was lost and could not be brought back
  kInterrupted = 130,
};

ExitCode exit_code_of(Code code);

}  // namespace animado
