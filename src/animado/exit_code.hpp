// The exit codes of the command line: part of the interface, see docs/architecture.md.
#pragma once

#include "base/error.hpp"

namespace animado {

enum ExitCode : int {
  kDone = 0,
  kUsage = 2,     // the command line makes no sense, or a service refused what it was asked
  kRefused = 3,   // the scene cannot be read, or is physical nonsense
  kDiverged = 4,  // the motion left the finite
  kLost = 5,      // a service cannot be reached, or was lost and could not be brought back
  kInterrupted = 130,
};

ExitCode exit_code_of_run(Code code);   // of an error that ended a run
ExitCode exit_code_of_call(Code code);  // of an error of any other command

}  // namespace animado
