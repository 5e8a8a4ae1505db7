#include "rpc/encoder.hpp"

#include <bit>
#include <msgpack.hpp>

namespace animado::rpc {
namespace {

static_assert(std::endian::native == std::endian::little, "arrays travel as they lie in memory");

struct Sink {
  std::string& out;
  void write(const char* bytes, size_t count) { out.append(bytes, count); }
};

template <class F>
void packed(std::string& out, F write) {
  Sink sink{out};
  msgpack::packer<Sink> packer(sink);
  write(packer);
}

}  // namespace

void Encoder::long_integer(int64_t value) {
  packed(out_, [&](auto& p) { p.pack_int64(value); });
}

void Encoder::number(double value) {
  // msgpack-cxx would write 2.0 as the integer 2, and −0.0 as 0: the sign would be lost on the way.
  const uint64_t bits = std::bit_cast<uint64_t>(value);
  char bytes[9] = {'\xcb'};
  for (int i = 1; i <= 8; ++i) bytes[i] = static_cast<char>(bits >> (64 - 8 * i));
  out_.append(bytes, sizeof bytes);
}

void Encoder::long_text_head(size_t bytes) {
  packed(out_, [&](auto& p) { p.pack_str(static_cast<uint32_t>(bytes)); });
}

void Encoder::long_list(size_t count) {
  packed(out_, [&](auto& p) { p.pack_array(static_cast<uint32_t>(count)); });
}

void Encoder::long_map(size_t count) {
  packed(out_, [&](auto& p) { p.pack_map(static_cast<uint32_t>(count)); });
}

void Encoder::numbers(std::span<const double> values) {
  packed(out_, [&](auto& p) {
    const auto bytes = std::as_bytes(values);
    p.pack_bin(static_cast<uint32_t>(bytes.size()));
    p.pack_bin_body(reinterpret_cast<const char*>(bytes.data()), static_cast<uint32_t>(bytes.size()));
  });
}

}  // namespace animado::rpc
