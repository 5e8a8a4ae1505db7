// How a message is described, once. A message is a struct
//
//   struct Solve {
//     static constexpr std::string_view name = "solve";
//     static constexpr std::string_view doc = "Solves A x = b for a batch of systems of one size.";
//     struct Request {
//       Array matrices;
//       double threshold = 0;
//       template <class Self, class F> static void fields(Self& s, F&& field) {
//         field("matrices", s.matrices, "A: shape (count, n, n)");
//         field("threshold", s.threshold, "T, relative size under which a pivot is refused", kDefault);
//       }
//     };
//     struct Reply { … };
//   };
//
// and a module lists its messages in a std::tuple named Messages. Encoding, decoding, the names in the logs,
// `animado call` and the pages of docs/protocol.md all walk `fields`, so there is nothing else to keep in
// step.
//
// A field is a bool, an int64_t, a double, a std::string, an enum with names (below), an Array, a struct with
// fields, or a std::vector or std::optional of these. Without kDefault a field must be there (an optional may
// be missing); with it, a missing field keeps its initializer. Unknown fields are refused.
//
// An enum says its wire names by   constexpr auto names(const Pivoting*) { return std::array{"partial"sv,
// "complete"sv}; }
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace animado::rpc {

struct DefaultTag {};
inline constexpr DefaultTag kDefault{};

// A message without fields.
struct Nothing {
  template <class Self, class F>
  static void fields(Self&, F&&) {}
};

// Numbers in row-major order. A small array travels inline: {shape, data: bin of little-endian float64}. A
// large or long-lived one is shared and only named: {shape, shared: name, offset: elements}; interexpserv
// owns it and hands out its descriptor.
struct Array {
  std::vector<int64_t> shape;
  std::vector<double> values;  // inline; empty when shared
  std::string shared;          // name of the shared array; empty when inline
  int64_t offset = 0;          // first element in the shared array

  static Array inlined(std::vector<int64_t> shape, std::vector<double> values) {
    return {std::move(shape), std::move(values), {}, 0};
  }
  static Array named(std::string name, std::vector<int64_t> shape, int64_t offset = 0) {
    return {std::move(shape), {}, std::move(name), offset};
  }
  bool is_shared() const { return !shared.empty(); }
  int64_t count() const {  // number of elements that the shape asks for
    int64_t n = 1;
    for (int64_t extent : shape) n *= extent;
    return n;
  }
};

}  // namespace animado::rpc
