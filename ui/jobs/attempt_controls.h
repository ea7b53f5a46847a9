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
  virtual void pick_up_freed() = 0;
  virtual void close_hinge() = 0;
  virtual void finish() = 0;
  /// Kept as interrupted, never scored.
  virtual void abandon() = 0;

  /// The recorder waits for room on the disk, while operating or while sealing.
  virtual bool is_storage_full() const noexcept = 0;
  /// Nothing while it runs or is being sealed.
  virtual const LiveEnd* end() const noexcept = 0;
};

}  // namespace hallux::ui
