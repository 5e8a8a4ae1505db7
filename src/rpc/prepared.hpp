// Requests about what the server was given before and knows by a handle.
#pragma once

#include "base/error.hpp"

namespace animado::rpc {

// Asks; a server that was restarted and does not know the handle is prepared first, as often as it dies
// between the two. A supervisor gives up before we do: who forgets more often is no server that dies, and its
// error is thrown.
template <class Prepare, class Ask>
auto ask_prepared(Prepare&& prepare, Ask&& ask) {
  constexpr int kMostRestarts = 8;
  for (int restarts = 0;; ++restarts) {
    try {
      return ask();
    } catch (const Error& error) {
      if (error.code() != Code::unknown_handle || restarts == kMostRestarts) throw;
    }
    prepare();
  }
}

}  // namespace animado::rpc
