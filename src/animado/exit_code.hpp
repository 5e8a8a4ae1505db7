// The exit codes of the command line: part of the interface, see docs/results.md.
#pragma once

#include "base/error.hpp"
#include "console/output.hpp"

namespace animado {

enum ExitCode : int {
  kDone = 0,
  kDiffers = 1,         // done, but a replay that is not the same as what it replays
  kUsage = 2,           // the command line makes no sense, or a service refused what it was asked
  kRefused = 3,         // the scene cannot be read, or is physical nonsense
  kDiverged = 4,        // the motion left the finite
  kLost = kOutputLost,  // a service is out of reach, or died for good; or what was written did not arrive
  kInterrupted = 130,
};

ExitCode exit_code_of_run(Code code);   // of an error that ended a run
ExitCode exit_code_of_call(Code code);  // of an error of any other command

}  // namespace animado
