// Any bytes as a message: an envelope, and whatever its body holds.
#include <cassert>
#include <cstdint>

#include "rpc/wire.hpp"

using namespace animado;

namespace {

void read(std::string_view message) {
  rpc::Envelope envelope;
  rpc::read_envelope(message, envelope);
  for (const std::string_view part : {envelope.body, envelope.error}) {
    rpc::Decoder decoder(part, rpc::Numbers::finite);
    while (!decoder.at_end()) decoder.skip();
  }
  if (!envelope.error.empty()) rpc::read_error(envelope.error);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string_view message(reinterpret_cast<const char*>(data), size);
  rpc::id_in(message);
  try {
    read(message);
  } catch (const Error& error) {
    assert(error.code() != Code::internal);
  }
  return 0;
}
