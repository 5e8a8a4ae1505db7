#include "controle/workspace.hpp"

namespace animado::controle {

Lanes Workspace::make(const std::string& name, std::vector<int64_t> shape) {
  const std::string full_name = run_ + "/" + name;
  double* const values = arrays_.create(full_name, shape).values().data();
  return {rpc::Array::named(full_name, std::move(shape)), values};
}

}  // namespace animado::controle
