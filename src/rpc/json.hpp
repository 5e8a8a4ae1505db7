// MessagePack as JSON text and back, for people: `animado call`, examples in the documentation.
#pragma once

#include <string>
#include <string_view>

namespace animado::rpc {

// Bytes are arrays of float64 on this wire: they become lists of numbers. NaN and infinity become null.
std::string json_of(std::string_view packed);

// Throws Code::syntax for text that is not JSON.
std::string packed_of(std::string_view json);

}  // namespace animado::rpc
