// The table of interexpserv: message → library call.
#pragma once

#include <filesystem>

#include "rpc/service.hpp"

namespace animado::interexpserv {

// Names that live as long as the process.
void fill_table(rpc::Service& service, rpc::Suite& suite);

// Names that are kept in `file` and read from it at the start; an empty path means as above.
void fill_table_with_store(rpc::Service& service, const std::filesystem::path& file);

}  // namespace animado::interexpserv
