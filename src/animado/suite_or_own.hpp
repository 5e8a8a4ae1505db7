// For commands that need no run: what they ask is the same in every suite.
#pragma once

#include <memory>

#include "animado/running_suite.hpp"

namespace animado {

// The chosen suite; when none is chosen the one that was started last, and when none runs, the services as
// part of this process. Throws Error(unavailable) when the chosen one does not run.
std::unique_ptr<rpc::Suite> suite_or_own(const SuiteChoice& choice);

}  // namespace animado
