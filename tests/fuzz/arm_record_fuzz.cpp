/// Feeds any bytes to the reader of an open arm's record: it must throw ScenarioError or give a
/// geometry in which every place is a number.
#include <cstdlib>

#include "scenarios/scenario_error.h"
#include "simulator/base/vector.h"
#include "tests/fuzz/text_fuzz.h"
#include "ui/jobs/devices/arm_record.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace hallux;
  try {
    const simulator::ArmGeometry geometry =
        ui::parse_arm_record(tests::text_of(bytes, size), "fuzz");
    const RigidTransform grip = simulator::grip_pose(geometry, {100, -200, 300, 0, 50, -50});
    if (!is_finite(grip.translation_mm)) std::abort();
  } catch (const scenarios::ScenarioError&) {
  }
  return 0;
}
