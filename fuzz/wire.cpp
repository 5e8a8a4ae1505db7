// Any bytes as a message: it is found whole and read, or refused; and what was read comes back from what is
// written of it.
#include <cassert>
#include <cstdint>

#include "rpc/codec.hpp"
#include "rpc/wire.hpp"

using namespace animado;

namespace {

// A field of every kind that a message may have.
struct OneOfEach {
  bool flag = false;
  int64_t count = 0;
  double number = 0;
  std::string text;
  rpc::Array array;
  std::vector<rpc::Array> arrays;
  std::optional<double> limit;
  template <class Self, class F>
  static void fields(Self& s, F&& field) {
    field("flag", s.flag, "", rpc::kDefault);
    field("count", s.count, "", rpc::kDefault);
    field("number", s.number, "", rpc::kDefault);
    field("text", s.text, "", rpc::kDefault);
    field("array", s.array, "", rpc::kDefault);
    field("arrays", s.arrays, "", rpc::kDefault);
    field("limit", s.limit, "");
  }
};

OneOfEach unpacked(std::string_view packed) {
  OneOfEach value;
  rpc::Decoder in(packed, rpc::Numbers::finite);
  rpc::unpack(rpc::type_of<OneOfEach>(), in, &value, "fuzz");
  return value;
}

std::string packed(const OneOfEach& value) {
  std::string bytes;
  rpc::Encoder out(bytes);
  rpc::pack(rpc::type_of<OneOfEach>(), &value, out);
  return bytes;
}

void read(std::string_view message) {
  rpc::Envelope envelope;
  rpc::read_envelope(message, envelope);
  if (!envelope.error.empty()) rpc::read_error(envelope.error);
  const std::string written = packed(unpacked(envelope.body));
  assert(packed(unpacked(written)) == written);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  rpc::id_in(bytes);
  try {
    rpc::Scanner scanner;
    if (scanner.scan(bytes.begin(), bytes.end())) read(bytes.substr(0, scanner.size()));
  } catch (const Error& error) {
    assert(error.code() != Code::internal);
  }
  return 0;
}
