#include "tests/fuzz/mesh_fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  hallux::tests::feed_reader(bytes, size, hallux::simulator::MeshFormat::Obj);
  return 0;
}
