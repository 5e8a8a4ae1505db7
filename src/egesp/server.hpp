// EGESP's table: message → algorithm.
#pragma once

#include "rpc/service.hpp"

namespace animado::egesp {

void fill_table(rpc::Service& service, rpc::Suite& suite);

}  // namespace animado::egesp
