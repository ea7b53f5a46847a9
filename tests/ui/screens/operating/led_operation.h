/// An operation without a window, a loop or a clock: an attempt that notes what it is told, and a
/// device likewise.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "simulator/device/steered_device.h"
#include "ui/screens/operating/operating_session.h"

namespace hallux::ui {

/// Notes its commands as words; its disk and its end are the test's to say.
class NotedAttempt final : public AttemptControls {
 public:
  void pause() override { told.emplace_back("pause"); }
  void resume() override { told.emplace_back("resume"); }
  void declare_done(std::int32_t step) override { told.push_back("done " + std::to_string(step)); }
  void reopen(std::int32_t step) override { told.push_back("reopen " + std::to_string(step)); }
  void pick_up(std::int32_t piece) override { told.push_back("pick up " + std::to_string(piece)); }
  void close_hinge(std::int32_t hinge) override {
    told.push_back("close hinge " + std::to_string(hinge));
  }
  void choose_tool(std::int32_t place) override { told.push_back("take " + std::to_string(place)); }
  void grip(std::int32_t piece) override { told.push_back("grip " + std::to_string(piece)); }
  void impact() override { told.emplace_back("impact"); }
  void release() override { told.emplace_back("release"); }
  void leave_implant() override { told.emplace_back("leave"); }
  void take_implant(std::int32_t implant) override {
    told.push_back("take hold " + std::to_string(implant));
  }
  void finish() override { told.emplace_back("finish"); }
  void abandon() override { told.emplace_back("abandon"); }
  bool is_storage_full() const noexcept override { return is_full; }
  const LiveEnd* end() const noexcept override { return ended ? &*ended : nullptr; }

  std::vector<std::string> told;
  bool is_full = false;
  std::optional<LiveEnd> ended;
};

/// Keeps where it was led last.
class NotedDevice final : public simulator::SteeredDevice {
 public:
  void aim(const Aim& aim) noexcept override {
    place_mm = aim.world_from_target.translation_mm;
    switches = aim.switches;
    unyielding = aim.unyielding_in_world;
    aimed = aim;
    ++aims;
  }
  Led led() const noexcept override { return leads; }
  void hand_over(const RigidTransform& world_from_start) override {
    leads = Led::Pose;
    place_mm = world_from_start.translation_mm;
  }
  simulator::DeviceDescription description() const override { return {"Noted", "mouse"}; }
  bool exchange(const Vec3&, std::int64_t, simulator::RawDeviceState&) noexcept override {
    return true;
  }

  Vec3 place_mm{0.0, 0.0, 0.0};
  Vec3 unyielding{0.0, 0.0, 0.0};
  std::uint32_t switches = 0;
  Aim aimed;
  /// What the window leads of it.
  Led leads = Led::Pose;
  int aims = 0;
};

/// The site lies at the origin, the saw begins 30 mm above it.
inline constexpr Vec3 start_mm{0.0, 30.0, 0.0};

/// A session that operates with them, one step of each kind.
struct LedOperation {
  explicit LedOperation(database::AttemptKind kind = database::AttemptKind::Practice);

  /// A frame in which somebody leads the saw that far across their view.
  void lead(const Vec2& across_mm, double now_s);
  /// Turns the saw on and tells the device.
  void saw(double now_s);
  /// Where the session stands when a finished record is closed.
  void end_with(const LiveEnd& end) { attempt.ended = end; }

  NotedAttempt attempt;
  NotedDevice device;
  OperatingSession session;
};

simulator::CutEvent event_of(simulator::CutEventKind kind, std::int32_t subject = 0);

}  // namespace hallux::ui
