#include <cstdlib>

#include "tests/ui/jobs/cut_balance.h"

namespace hallux::tests {
namespace {

/// The folder of real bones: ./test --meshes DIR.
std::filesystem::path real_bone(const char* name) {
  const char* folder = std::getenv("HALLUX_MESHES");
  return std::filesystem::path(folder != nullptr ? folder : "HALLUX_MESHES-is-not-set") / name;
}

TEST(RealBoneCut, LeavesClosedPiecesThatAddUp) {
  for (const char* name : {"bp3d_metatarsal1_r.stl", "bp3d_prox_phalanx1_r.stl"}) {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) expect_balance(real_bone(name), seed, 1);
    for (std::uint64_t seed = 21; seed <= 30; ++seed) expect_balance(real_bone(name), seed, 3);
  }
}

TEST(RealBoneCut, RefusesABoneThatIsNotClosed) {
  ui::CutRequest request{real_bone("osim_calcaneus_r_open.stl"), {{}}, testing::TempDir()};
  EXPECT_THROW(ui::cut_mesh(request, {}), simulator::MeshError);
}

}  // namespace
}  // namespace hallux::tests
