// Who may watch a run: whoever knows 128 random bits.
#pragma once

#include <string>
#include <string_view>

namespace animado::live {

std::string random_token();  // 32 hexadecimal digits

// In a time that does not depend on where they differ.
bool same_token(std::string_view a, std::string_view b);

}  // namespace animado::live
