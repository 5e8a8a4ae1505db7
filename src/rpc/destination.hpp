// Where a result goes: straight into the shared array that the request names, or into the reply. For results
// that are computed in place; `deliver` (service.hpp) copies one that is already there.
#pragma once

#include <initializer_list>
#include <optional>
#include <span>

#include "rpc/service.hpp"

namespace animado::rpc {

class Destination {
 public:
  // reads: the numbers that the result is computed from. Throws bad_shape when `out` has another shape than
  // the result, bad_params when it overlaps `reads`: a request that overwrites what it reads could not be
  // repeated.
  Destination(Call& call, const std::optional<Array>& out, std::vector<int64_t> shape,
              std::initializer_list<std::span<const double>> reads);

  std::span<double> values() { return shared_ ? pages_ : std::span(array_.values); }
  Array take() && { return std::move(array_); }  // for the reply

 private:
  Array array_;
  std::span<double> pages_;
  bool shared_;
};

}  // namespace animado::rpc
