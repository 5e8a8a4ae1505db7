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

void Encoder::nil() {
  packed(out_, [](auto& p) { p.pack_nil(); });
}

void Encoder::boolean(bool value) {
  packed(out_, [&](auto& p) { value ? p.pack_true() : p.pack_false(); });
}

void Encoder::integer(int64_t value) {
  packed(out_, [&](auto& p) { p.pack_int64(value); });
}

void Encoder::number(double value) {
  // msgpack-cxx would write 2.0 as the integer 2, and −0.0 as 0: the sign would be lost on the way.
  const uint64_t bits = std::bit_cast<uint64_t>(value);
  char bytes[9] = {'\xcb'};
  for (int i = 1; i <= 8; ++i) bytes[i] = static_cast<char>(bits >> (64 - 8 * i));
  out_.append(bytes, sizeof bytes);
}

void Encoder::text(std::string_view value) {
  packed(out_, [&](auto& p) {
    p.pack_str(static_cast<uint32_t>(value.size()));
    p.pack_str_body(value.data(), static_cast<uint32_t>(value.size()));
  });
}

void Encoder::list(size_t count) {
  packed(out_, [&](auto& p) { p.pack_array(static_cast<uint32_t>(count)); });
}

void Encoder::map(size_t count) {
  packed(out_, [&](auto& p) { p.pack_map(static_cast<uint32_t>(count)); });
}

void Encoder::numbers(std::span<const double> values) {
  packed(out_, [&](auto& p) {
    const auto bytes = std::as_bytes(values);
    p.pack_bin(static_cast<uint32_t>(bytes.size()));
    p.pack_bin_body(reinterpret_cast<const char*>(bytes.data()), static_cast<uint32_t>(bytes.size()));
  });
}

void Encoder::raw(std::string_view packed_value) {
  out_.append(packed_value);
}

}  // namespace animado::rpc
