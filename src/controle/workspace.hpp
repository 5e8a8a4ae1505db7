// The shared arrays of a run: made once, named in messages from then on.
#pragma once

#include <string>
#include <vector>

#include "rpc/message.hpp"
#include "rpc/shared_array.hpp"

namespace animado::controle {

// A shared array as controle uses it: how messages name it, and its numbers.
struct Lanes {
  rpc::Array array;
  double* values = nullptr;
};

class Workspace {
 public:
  // `run` makes the names unique among the runs that one interexpserv serves.
  Workspace(rpc::SharedArrays& arrays, std::string run) : arrays_(arrays), run_(std::move(run)) {}

  Lanes make(const std::string& name, std::vector<int64_t> shape);

 private:
  rpc::SharedArrays& arrays_;
  std::string run_;
};

}  // namespace animado::controle
