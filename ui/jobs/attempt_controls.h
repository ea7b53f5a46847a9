/// The commands of somebody who operates, and the end of their attempt.
///
/// An interface, so that what leads an attempt is tested without loop, recorder and clock.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "database/recording/recorder.h"
#include "simulator/loop/attempt_loop.h"

namespace hallux::ui {

/// What stopped recording or loop, as far as people can do something about it.
enum class LiveFailure { None, DiskFull, MemoryFull, Other };

/// How it ended.
struct LiveEnd {
  simulator::AttemptEnd end = simulator::AttemptEnd::Cancelled;
  /// Finished and whole: it can be scored.
  bool is_sealed = false;
  LiveFailure failure = LiveFailure::None;
  /// Of the failure, as the one who noticed it said it.
  std::string reason = {};
  /// The file that was recorded into.
  std::filesystem::path file = {};
  simulator::LoopStatistics loop = {};
  database::RecorderStatistics recorder = {};
};

/// thread  window, all of it
class AttemptControls {
 public:
  AttemptControls() = default;
  AttemptControls(const AttemptControls&) = delete;
  AttemptControls& operator=(const AttemptControls&) = delete;
  virtual ~AttemptControls() = default;

  virtual void pause() = 0;
  virtual void resume() = 0;
  virtual void declare_done(std::int32_t step) = 0;
  /// A step that was declared done is at hand again.
  virtual void reopen(std::int32_t step) = 0;
  /// A free piece is taken out of the wound, by its number.
  virtual void pick_up(std::int32_t piece) = 0;
  /// By its number in the operation.
  virtual void close_hinge(std::int32_t hinge) = 0;
  /// Another tool comes into the hand, by its place on the tray.
  virtual void choose_tool(std::int32_t place) = 0;
  /// The forceps take hold of a piece, drive home what they hold, let it go.
  virtual void grip(std::int32_t piece) = 0;
  virtual void impact() = 0;
  virtual void release() = 0;
  /// The driver lets go of what stands in bone, or takes hold of what it left.
  virtual void leave_implant() = 0;
  virtual void take_implant(std::int32_t implant) = 0;
  virtual void finish() = 0;
  /// Kept as interrupted, never scored.
  virtual void abandon() = 0;

  /// The recorder waits for room on the disk, while operating or while sealing.
  virtual bool is_storage_full() const noexcept = 0;
  /// Nothing while it runs or is being sealed.
  virtual const LiveEnd* end() const noexcept = 0;
};

/// Those of whoever is told by the loop's commands; how they get there, and abandoning, is left.
class CommandControls : public AttemptControls {
 public:
  void pause() override { say({simulator::CommandKind::Pause, simulator::paused_by_operator, 0}); }
  void resume() override {
    say({simulator::CommandKind::Resume, simulator::paused_by_operator, 0});
  }
  void declare_done(std::int32_t step) override {
    say({simulator::CommandKind::StepDone, step, 0});
  }
  void reopen(std::int32_t step) override { say({simulator::CommandKind::ReopenStep, step, 0}); }
  void pick_up(std::int32_t piece) override { say({simulator::CommandKind::PickUp, piece, 0}); }
  void close_hinge(std::int32_t hinge) override {
    say({simulator::CommandKind::CloseHinge, hinge, 0});
  }
  void choose_tool(std::int32_t place) override {
    say({simulator::CommandKind::ChooseTool, place, 0});
  }
  void grip(std::int32_t piece) override { say({simulator::CommandKind::Grip, piece, 0}); }
  void impact() override { say({simulator::CommandKind::Impact, 0, 0}); }
  void release() override { say({simulator::CommandKind::Release, 0, 0}); }
  void leave_implant() override { say({simulator::CommandKind::LeaveImplant, 0, 0}); }
  void take_implant(std::int32_t implant) override {
    say({simulator::CommandKind::TakeImplant, implant, 0});
  }
  void finish() override { say({simulator::CommandKind::Finish, 0, 0}); }

 protected:
  virtual void say(const simulator::Command& command) = 0;
};

}  // namespace hallux::ui
