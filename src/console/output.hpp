// What a program prints on stdout is what it was asked for: its work is done when that has arrived.
#pragma once

#include <functional>

namespace animado {

inline constexpr int kOutputLost = 5;  // exit code

// The exit code of a program: that of its work, or kOutputLost, and an error on stderr, where the work was
// done but what it printed did not arrive, as on a full disk.
int with_output(const std::function<int()>& work);

}  // namespace animado
