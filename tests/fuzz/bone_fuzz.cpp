/// Feeds any bytes to decode_patient: it must throw MeshError, or give the bones of exactly these
/// bytes.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "simulator/base/check.h"
#include "simulator/mesh/bones.h"
#include "simulator/mesh/mesh_error.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const auto input = std::as_bytes(std::span{bytes, size});
  try {
    const auto back = hallux::simulator::encode_patient(hallux::simulator::decode_patient(input));
    CHECK(std::equal(back.begin(), back.end(), input.begin(), input.end()));
  } catch (const hallux::simulator::MeshError&) {
  }
  return 0;
}
