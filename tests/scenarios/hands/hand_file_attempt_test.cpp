/// A motion from a file that saws a bar in three, moves two parts, and saws on in all of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "scenarios/hands/hand_file.h"
#include "simulator/device/scripted.h"
#include "simulator/loop/replay.h"
#include "tests/simulator/loop/recorded_run.h"
#include "tests/simulator/step/simulation_run.h"
#include "tests/support/worlds.h"

namespace hallux::scenarios {
namespace {

using nlohmann::json;
using simulator::CutEvent;
using simulator::CutEventKind;

/// Writes the file; all strokes come from above, in planes across the bar.
class Writer {
 public:
  void stroke(double x_mm, double y_mm, double depth_s) {
    key(x_mm, 12.0, 0.4, false);
    key(x_mm, 8.0, 0.1, true);
    key(x_mm, y_mm, 0.5, true);
    key(x_mm, y_mm, depth_s, true);
    key(x_mm, 30.0, 0.4, false);
    key(x_mm, 30.0, 0.1, false);
  }
  void grip(double from_x_mm, double by_x_mm) {
    key(from_x_mm, 30.0, 0.4, false);
    const double from_s = time_s_ + 0.1;
    key(from_x_mm, 30.0, 0.2, false);
    key(from_x_mm + by_x_mm, 30.0, 0.5, false);
    key(from_x_mm + by_x_mm, 30.0, 0.2, false);
    file_["grips"].push_back({{"from_s", from_s}, {"to_s", time_s_ - 0.05}, {"piece", piece_++}});
  }
  void choose(const std::string& tool) { next_tool_ = tool; }
  std::string text() {
    file_["commands"] = json::array();
    return file_.dump();
  }

 private:
  void key(double x_mm, double y_mm, double after_s, bool saws) {
    time_s_ += after_s;
    json key{{"time_s", time_s_},
             {"tip_mm", {x_mm, y_mm, 0.0}},
             {"direction", {0.0, -1.0, 0.0}},
             {"normal", {1.0, 0.0, 0.0}},
             {"saw", saws}};
    if (!next_tool_.empty()) key["tool"] = std::exchange(next_tool_, "");
    file_["keys"].push_back(std::move(key));
  }

  json file_;
  double time_s_ = 0.0;
  std::int32_t piece_ = 1;
  std::string next_tool_;
};

TEST(HandFileAttempt, FreezesTwelveKerfsInThreeBodiesWithTwoBlades) {
  simulator::Bone bone = tests::cancellous_bone(tests::solid_block({60.0, 8.0, 8.0}));
  bone.world_from_bone = {};
  const std::vector<LaidOutTool> tools{
      {"wide", simulator::Saw{}},
      {"fine", simulator::Saw{.blade = {.width_mm = 10.0, .kerf_mm = 0.4, .thickness_mm = 0.3}}}};
  Writer writer;
  writer.stroke(-12.0, -14.0, 4.0);
  writer.stroke(12.0, -14.0, 4.0);
  writer.grip(-20.0, -4.0);
  writer.grip(20.0, 4.0);
  writer.choose("fine");
  for (const double x_mm : {-30.0, -26.0, -22.0, -6.0, 0.0, 4.0, 8.0, 22.0, 26.0, 30.0})
    writer.stroke(x_mm, 0.0, 0.8);
  const simulator::HandMotion motion = parse_hand_motion(writer.text(), "twelve.json", tools);

  const std::array<simulator::Tool, 1> further{tools[1].tool};
  const simulator::SimulationSetup simulated{
      bone, simulator::Tray(std::get<simulator::Saw>(tools[0].tool), further)};
  const simulator::AttemptSetup setup{
      .simulation = simulated, .commands = motion.commands, .last_tick = motion.last_tick() + 1};
  simulator::ScriptedDevice device(motion);
  const simulator::Recording recording = tests::record(setup, device).recording;

  std::set<std::int64_t> bodies;
  std::ptrdiff_t frozen = 0;
  for (const CutEvent& event : recording.events) {
    if (event.kind != CutEventKind::PlaneFrozen) continue;
    ++frozen;
    bodies.insert(event.value);
  }
  EXPECT_EQ(frozen, 12);
  EXPECT_EQ(bodies.size(), 3U);
  const auto count = [&](CutEventKind kind) {
    return std::count_if(recording.events.begin(), recording.events.end(),
                         [kind](const CutEvent& event) { return event.kind == kind; });
  };
  EXPECT_EQ(count(CutEventKind::FragmentParted), 2);
  EXPECT_EQ(count(CutEventKind::Released), 2);
  EXPECT_EQ(count(CutEventKind::ToolChosen), 1);
  EXPECT_EQ(count(CutEventKind::KerfRefused), 0);
  EXPECT_TRUE(simulator::replay(recording, simulated).is_identical);
}

}  // namespace
}  // namespace hallux::scenarios
