// Where sockets are, and that only their owner can reach them: a folder of mode 0700, and on each connection,
// at both ends, a look at the peer's user (SO_PEERCRED).
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <string_view>

#include "rpc/unique_fd.hpp"

namespace animado::rpc {

inline constexpr std::string_view kWellKnown =
    "interexpserv";  // the service at the one address that all know

// $ANIMADO_SOCKET_DIR when set; else $XDG_RUNTIME_DIR/animado/<run>, or animado-<uid>/<run> in the temporary
// folder.
std::filesystem::path socket_directory(std::string_view run = "default");

// Makes the folder, mode 0700, and checks that it is ours alone. Throws Code::refused.
void prepare_directory(const std::filesystem::path& directory);

// interexpserv.sock, or <service>.<pid>.sock.
std::filesystem::path socket_path(const std::filesystem::path& directory, std::string_view service,
                                  pid_t pid);

// A listening socket, not blocking, that appears under its name only when it already listens. Throws
// Code::conflict when a live process listens there; what a dead one left is replaced. Of processes that want
// one address at the same time one has it. Throws Code::refused where the folder does not let us.
UniqueFd listen_at(const std::filesystem::path& socket);

// Removes sockets of the service in the folder that nobody listens on any more, and no others: also while
// processes of its name start. Throws Code::refused where the folder does not let us.
void remove_stale(const std::filesystem::path& directory, std::string_view service);

// A connected socket, not blocking, or an empty descriptor when nobody listens there. Throws Code::refused
// when the peer is another user's process.
UniqueFd connect_to(const std::filesystem::path& socket);

// Whether the process at the other end belongs to our user.
bool peer_is_ours(int fd);

}  // namespace animado::rpc
