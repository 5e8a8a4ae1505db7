// Any bytes as a scene: it is read, or refused with a message.
#include <cassert>
#include <cstdint>

#include "base/error.hpp"
#include "controle/scene/scene.hpp"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  for (const char* names_a_file : {"script", "roteiro", "hull", "casco", "table"}) {
    if (text.find(names_a_file) != text.npos) return 0;
  }
  try {
    animado::controle::parse_scene(text, "fuzz.animado");
  } catch (const animado::Error& error) {
    assert(error.code() != animado::Code::internal && !error.message().empty());
  }
  return 0;
}
