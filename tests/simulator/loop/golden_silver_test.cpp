/// The shipped Silver operation by the scripted expert, seed 1: patient, plan, hand, step and jobs
/// together; and the same on the patient that generator 2 made, which shows that the engine still
/// answers as before.
#include <gtest/gtest.h>
#include <zstd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "scenarios/hands/feeling_hand.h"
#include "scenarios/simulation_setup.h"
#include "simulator/loop/replay.h"
#include "tests/scenarios/format_1/format_1.h"
#include "tests/simulator/loop/golden.h"
#include "tests/simulator/loop/recorded_run.h"

namespace hallux::simulator {
namespace {

/// The expert's first attempt at Silver on one bone.
class SilverRun {
 public:
  explicit SilverRun(const Bone& bone)
      : bone_(bone),
        scenario_(scenarios_test::format_1("silver")),
        plan_(plan_on(scenario_, bone_)),
        simulation_(simulation_setup(scenario_, bone_, plan_, Guidance::None)) {}

  Recording record() const {
    scenarios::FeelingHand hand(scenario_, bone_, plan_, scenarios::hand_skill("expert"), 1);
    const AttemptSetup setup{.simulation = simulation_,
                             .commands = {},
                             .last_tick = scenarios::FeelingHand::last_tick,
                             .attempt_operator = &hand};
    return tests::record(setup, hand).recording;
  }
  ReplayResult replayed(const Recording& recording) const { return replay(recording, simulation_); }

 private:
  const Bone& bone_;
  scenarios::Scenario scenario_;
  scenarios::Plan plan_;
  SimulationSetup simulation_;
};

/// A bone in its bytes, packed by zstd.
Bone read_packed_bone(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  const std::string packed(std::istreambuf_iterator<char>(stream), {});
  constexpr std::size_t most_bytes = 8'000'000;
  std::vector<std::byte> bytes(most_bytes);
  const std::size_t size =
      ZSTD_decompress(bytes.data(), bytes.size(), packed.data(), packed.size());
  if (ZSTD_isError(size) != 0U) throw std::runtime_error(file.string() + " cannot be unpacked");
  bytes.resize(size);
  return decode_bone(bytes);
}

TEST(Golden, TheExpertsFirstSilverGivesTheCommittedHashesAndReplaysIdentical) {
  const Bone bone = scenarios::make_patient_bones(scenarios_test::format_1("silver")).front();
  const SilverRun run(bone);
  const Recording recording = run.record();
  tests::expect_golden(bone, recording, tests::golden_silver_expert_1);
  const ReplayResult result = run.replayed(recording);
  EXPECT_TRUE(result.is_identical) << result.difference;
}

TEST(Golden, TheExpertsFirstSilverOnTheBoneOfGenerator2GivesItsHashesAsBefore) {
  const Bone bone = read_packed_bone(HALLUX_OLD_BONES "/silver_generator_2.bone.zst");
  tests::expect_golden(bone, SilverRun(bone).record(), tests::golden_silver_expert_1_generator_2);
}

}  // namespace
}  // namespace hallux::simulator
