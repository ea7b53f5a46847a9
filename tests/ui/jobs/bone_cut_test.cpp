#include <unistd.h>

#include "scenarios/plan.h"
#include "simulator/mesh/write_ply.h"
#include "tests/ui/jobs/cut_balance.h"

namespace hallux::tests {
namespace {

/// The shipped patient at full detail, with its marrow canal as a nested shell.
class GeneratedBone : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const simulator::Bone bone =
        scenarios::make_patient_bones(scenarios::load_shipped_scenario("silver")).front();
    write_ply(solid_of(bone), file());
  }
  static void TearDownTestSuite() { std::filesystem::remove(file()); }
  static std::filesystem::path file() {
    // Each test may be a process of its own.
    return std::filesystem::path(testing::TempDir()) /
           ("hallux_generated_bone_" + std::to_string(getpid()) + ".ply");
  }
};

TEST_F(GeneratedBone, FallsIntoClosedPiecesThatAddUpUnderOnePlane) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) expect_balance(file(), seed, 1);
}

TEST_F(GeneratedBone, FallsIntoClosedPiecesThatAddUpUnderThreeCrossingPlanes) {
  for (std::uint64_t seed = 11; seed <= 13; ++seed) expect_balance(file(), seed, 3);
}

}  // namespace
}  // namespace hallux::tests
