// COLISÃO as a service: its table of messages.
#pragma once

#include "rpc/service.hpp"

namespace animado::colisao {

// Adds the handlers of protocol.hpp. system15 asks the suite's egesp.
void fill_table(rpc::Service& service, rpc::Suite& suite);

}  // namespace animado::colisao
