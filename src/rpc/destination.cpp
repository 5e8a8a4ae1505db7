#include "rpc/destination.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <functional>

#include "base/error.hpp"

namespace animado::rpc {
namespace {

bool overlap(std::span<const double> a, std::span<const double> b) {
  const std::less<const double*> before;
  return before(a.data(), b.data() + b.size()) && before(b.data(), a.data() + a.size());
}

}  // namespace

Destination::Destination(Call& call, const std::optional<Array>& out, std::vector<int64_t> shape,
                         std::initializer_list<std::span<const double>> reads)
    : shared_(out.has_value()) {
  if (!shared_) {
    array_.shape = std::move(shape);
    array_.values.resize(static_cast<size_t>(array_.count()));
    return;
  }
  if (out->shape != shape) {
    throw Error(Code::bad_shape,
                fmt::format("the result has shape ({}), out has ({})", fmt::join(shape, ", "),
                            fmt::join(out->shape, ", ")),
                "out", "create the shared array with the shape of the result");
  }
  pages_ = call.write(*out);
  for (const auto& read : reads) {
    if (overlap(pages_, read)) {
      throw Error(Code::bad_params, "out overlaps an array that the request reads", "out",
                  "write into an array of its own");
    }
  }
  array_ = *out;
}

}  // namespace animado::rpc
