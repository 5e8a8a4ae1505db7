// The four services linked into this process: the same handlers, the same client interface, no sockets.
#pragma once

#include <filesystem>
#include <memory>

#include "rpc/channel.hpp"

namespace animado {

// logs: directory for a log a module; none are written when it is empty.
std::unique_ptr<rpc::Suite> suite_in_process(const std::filesystem::path& logs = {});

}  // namespace animado
