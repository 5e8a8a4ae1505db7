// The parts of egesp's table that stand in files of their own.
#pragma once

#include <memory>

#include "egesp/handles.hpp"
#include "rpc/service.hpp"

namespace animado::egesp {

void add_least_squares(rpc::Service& service);
void add_prepared(rpc::Service& service, const std::shared_ptr<Handles>& handles);
void add_sparse(rpc::Service& service, const std::shared_ptr<Handles>& handles);

}  // namespace animado::egesp
