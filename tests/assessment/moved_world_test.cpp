/// Where the bone lies in the world changes no measurement.
///
/// A half turn about an axis of the world and a shift by whole micrometres take recorded poses and
/// forces to recorded ones to the last digit; any other turn rounds each pose anew, by up to half a
/// micrometre and half a millionth of its quaternion, which is 0.02 mm over the length of a blade.
#include <gtest/gtest.h>

#include <algorithm>

#include "assessment/ledger.h"
#include "tests/assessment/examined_attempt.h"

namespace hallux::assessment {
namespace {

using simulator::QuantisedPose;
using simulator::Recording;
using testing::examined;
using testing::ExaminedAttempt;

constexpr std::array<std::int32_t, 3> shift_um{-123457, 98765, 31};

/// Turned half about x, then shifted.
QuantisedPose moved(const QuantisedPose& pose) {
  const auto [w, x, y, z] = pose.rotation_micro;
  QuantisedPose made{{pose.translation_um[0] + shift_um[0], -pose.translation_um[1] + shift_um[1],
                      -pose.translation_um[2] + shift_um[2]},
                     {-x, w, -z, y}};
  const auto leading = std::find_if(made.rotation_micro.begin(), made.rotation_micro.end(),
                                    [](std::int32_t part) { return part != 0; });
  if (*leading < 0) {
    for (std::int32_t& part : made.rotation_micro) part = -part;
  }
  return made;
}

Recording moved(Recording recording) {
  for (simulator::TapeLine& line : recording.tape)
    line.device.world_from_handle = moved(line.device.world_from_handle);
  for (simulator::ToolSample& sample : recording.samples) {
    sample.world_from_tool = moved(sample.world_from_tool);
    sample.force_mn = {sample.force_mn[0], -sample.force_mn[1], -sample.force_mn[2]};
  }
  return recording;
}

simulator::Bone moved(simulator::Bone bone) {
  const RigidTransform world_from_before{
      Quat(0.0, 1.0, 0.0, 0.0),
      Vec3{mm_from_um(shift_um[0]), mm_from_um(shift_um[1]), mm_from_um(shift_um[2])}};
  bone.world_from_bone = world_from_before * bone.world_from_bone;
  return bone;
}

/// All of it running, with a handle that wanders, a break-through at the end of each stroke.
void tell_all(Recording& recording) {
  recording.events.insert(recording.events.begin(), simulator::CutEvent{});
  std::vector<simulator::ToolSample> samples = recording.samples;
  for (std::size_t index = 0; index < samples.size(); ++index) {
    simulator::ToolSample& sample = samples[index];
    sample.status |= bit(simulator::ToolStatus::Running) | bit(simulator::ToolStatus::InContact);
    simulator::TapeLine line;
    line.tick = sample.tick;
    line.device.world_from_handle = sample.world_from_tool;
    line.device.world_from_handle.translation_um[1] += static_cast<std::int32_t>(index % 700) * 20;
    recording.tape.push_back(line);
    const bool ends = index + 1 == samples.size() || samples[index + 1].tick > sample.tick + 1;
    if (!ends) continue;
    recording.events.push_back(
        {sample.tick - 60, simulator::CutEventKind::Breakthrough, sample.kerf, 0, {}});
  }
  std::stable_sort(recording.events.begin(), recording.events.end(),
                   [](const auto& a, const auto& b) { return a.tick < b.tick; });
  recording.samples = samples;
}

/// A zone that the blade crosses, and a joint beside it.
void add_surroundings(scenarios::Scenario& scenario, const char* around) {
  scenarios::DangerZone zone;
  zone.name = zone.title = "nerve";
  zone.from_in_bone_mm = {-20.0, 1.0, -3.0};
  zone.to_in_bone_mm = {80.0, 1.0, -9.0};
  zone.radius_mm = 1.0;
  scenario.danger_zones = {zone};
  scenarios::JointSurface joint;
  joint.name = joint.title = "joint";
  joint.around = around;
  joint.radius_mm = 100.0;
  joint.facing_in_bone = {1.0, 0.0, 0.0};
  joint.within_rad = 0.1;
  scenario.joint_surfaces = {joint};
}

void expect_same_numbers(const ExaminedAttempt& here, const ExaminedAttempt& there) {
  ASSERT_EQ(here.examination.measurements.size(), there.examination.measurements.size());
  std::size_t measured = 0;
  for (std::size_t index = 0; index < here.examination.measurements.size(); ++index) {
    const Measurement& a = here.examination.measurements[index];
    const Measurement& b = there.examination.measurements[index];
    const std::string name = a.metric + " " + a.cut + a.hinge + a.zone;
    EXPECT_EQ(a.metric, b.metric);
    EXPECT_EQ(a.absence, b.absence) << name;
    EXPECT_NEAR(a.value, b.value, 1.5e-6) << name;
    EXPECT_NEAR(a.done_fraction, b.done_fraction, 1e-9) << name;
    EXPECT_EQ(a.start_us, b.start_us) << name;
    EXPECT_EQ(a.end_us, b.end_us) << name;
    EXPECT_LT(length_of(a.place_in_bone_mm - b.place_in_bone_mm), 1e-6) << name;
    measured += a.is_measured() ? 1U : 0U;
  }
  EXPECT_GT(measured, 20U);
  EXPECT_EQ(here.examination.card.score_milli, there.examination.card.score_milli);
}

TEST(MovedWorld, ChangesNoMeasurementOfTheBlock) {
  scenarios::Scenario scenario = testing::block_scenario();
  add_surroundings(scenario, "axis_proximal");
  const simulator::Bone bone = testing::block_bone();
  Recording recording;
  testing::add_stroke(recording, bone, {.face_z_mm = -8.7, .tilt_rad = 0.03});
  testing::add_stroke(recording, bone, {.face_z_mm = -6.0, .last_y_mm = 2.0});
  tell_all(recording);
  const ExaminedAttempt here = examined(scenario, bone, recording);
  EXPECT_GT(here.value("danger_contacts_count"), 0.0);
  EXPECT_GT(here.value("plunge_mm", "eminence"), 0.0);
  expect_same_numbers(here, examined(scenario, moved(bone), moved(recording)));
}

TEST(MovedWorld, ChangesNoMeasurementOfTheWedge) {
  scenarios::Scenario scenario = testing::akin_with_deeds();
  add_surroundings(scenario, "base_centre");
  const simulator::Bone bone = testing::oval_bone();
  Recording recording = testing::akin_recording(
      {.entry_x_mm = 6.9, .transverse_deg = -2.4, .sagittal1_deg = 3.1, .wedge_deg = 12.3}, bone);
  tell_all(recording);
  recording.events.push_back(
      {recording.samples.back().tick, simulator::CutEventKind::HingeClosed, -1, 0,
       simulator::quantise({rotation_about(Vec3{0.0, 1.0, 0.0}, 0.15), Vec3{0.3, 0.0, 1.0}})});
  const ExaminedAttempt here = examined(scenario, bone, recording);
  EXPECT_GT(here.value("gap_mm", "lateral"), 0.0);
  expect_same_numbers(here, examined(scenario, moved(bone), moved(recording)));
}

}  // namespace
}  // namespace hallux::assessment
