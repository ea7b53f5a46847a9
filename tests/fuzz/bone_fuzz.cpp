/// Feeds any bytes to decode_patient, as they are and as each of two bones of a patient: it must
/// throw MeshError, or give the bones of exactly these bytes.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "simulator/base/check.h"
#include "simulator/mesh/bones.h"
#include "simulator/mesh/mesh_error.h"

namespace {

using Bytes = std::span<const std::byte>;

void decode(Bytes input) {
  try {
    const auto back = hallux::simulator::encode_patient(hallux::simulator::decode_patient(input));
    CHECK(std::equal(back.begin(), back.end(), input.begin(), input.end()));
  } catch (const hallux::simulator::MeshError&) {
  }
}

/// As bone_bytes.cpp lays a patient of two bones.
std::vector<std::byte> twice(Bytes bone) {
  std::vector<std::byte> made;
  const auto add_whole = [&](std::uint64_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) made.push_back(static_cast<std::byte>(value >> (8 * i)));
  };
  for (const char letter : std::string_view("HALLUXP1"))
    made.push_back(static_cast<std::byte>(letter));
  add_whole(2, 4);
  for (int i = 0; i < 2; ++i) {
    add_whole(bone.size(), 8);
    made.insert(made.end(), bone.begin(), bone.end());
  }
  return made;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const auto input = std::as_bytes(std::span{bytes, size});
  decode(input);
  decode(twice(input));
  return 0;
}
