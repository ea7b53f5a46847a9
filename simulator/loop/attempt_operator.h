/// An operator that answers to what it sees: after each step it is shown what came out, before the
/// next it says commands.
#pragma once

#include "simulator/step/simulation.h"

namespace hallux::simulator {

class AttemptOperator {
 public:
  virtual ~AttemptOperator() = default;

  /// What the step has made of the line before.
  /// thread  haptic; allocates nothing
  virtual void observe(const StepOutput& output) noexcept = 0;
  /// The next command for the line at hand, asked after the device of that line was read; false:
  /// none.
  virtual bool take_command(Command& command) noexcept = 0;
  /// Of all that it means to do [0, 1].
  virtual double fraction_done() const noexcept = 0;
};

}  // namespace hallux::simulator
