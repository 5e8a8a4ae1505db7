// The manual page of a service, from the list of its messages: as data for the message `describe`, as
// Markdown for docs/protocol.md.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "rpc/codec.hpp"
#include "rpc/common.hpp"

namespace animado::rpc {

Describe::Message described(const MessageCodec& codec);

// A section of docs/protocol.md: a heading with the service's name, the introduction, a section a message.
std::string manual_page(std::string_view service, std::string_view introduction,
                        std::span<const MessageCodec* const> messages);

// The pages of what every service shares: the wire, arrays, errors, the messages of common.hpp.
std::string common_pages();

}  // namespace animado::rpc
