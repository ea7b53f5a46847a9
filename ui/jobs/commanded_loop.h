/// A loop that somebody at the window commands and follows; whoever derives runs it beside the
/// window.
///
///     window  --commands------------>  loop
///             <--newest view, feed---
#pragma once

#include <optional>

#include "simulator/loop/attempt_watch.h"
#include "ui/jobs/attempt_controls.h"

namespace hallux::ui {

class CommandedLoop : public CommandControls {
 public:
  /// Device newtons per simulated newton, as the loop makes them; nothing where the device pushes
  /// nobody back.
  const std::optional<double>& force_scale() const noexcept { return force_scale_; }
  /// The newest view of the loop.
  /// thread  window
  const simulator::LoopView& view() noexcept { return watch_.view.read(); }
  /// For the one thread that follows the bone.
  simulator::AttemptWatch& watch() noexcept { return watch_; }

 protected:
  explicit CommandedLoop(std::optional<double> force_scale) : force_scale_(force_scale) {}

  /// A person gives a command a second; the loop takes a thousand lines in that time.
  void say(const simulator::Command& command) final {
    static_cast<void>(watch_.commands.push(command));
  }

 private:
  std::optional<double> force_scale_;
  simulator::AttemptWatch watch_;
};

}  // namespace hallux::ui
