// FRED's table: message → algorithm.
#pragma once

#include "rpc/service.hpp"

namespace animado::fred {

void fill_table(rpc::Service& service, rpc::Suite& suite);

}  // namespace animado::fred
