/// What one step gives out, and who writes it.
/// Inside this corner only.
#pragma once

#include <cstdint>

#include "simulator/base/check.h"
#include "simulator/base/fixed_list.h"
#include "simulator/contact/feed.h"
#include "simulator/jobs/geometry_job.h"
#include "simulator/record/record.h"
#include "simulator/step/followed_record.h"
#include "simulator/step/tool_effects.h"

namespace hallux::simulator {

inline constexpr std::size_t events_per_step = 24;

/// What is below `requests` is for displays and devices and is not recorded.
struct StepOutput {
  ToolSample sample;
  /// Before the sample, in order.
  FixedList<CutEvent, events_per_step> events;
  /// To be run on the state after this step.
  FixedList<JobRequest, 4> requests;
  /// Results that the step needs no more, but for the bodies of pieces that were taken out.
  FixedList<const JobResult*, commands_per_tick> given_back;
  /// In the hand: its place on the tray.
  std::int32_t tool = 0;
  Engagement engaged;
  BladeFlex flex;
  /// Of all bone now.
  double hottest_celsius = body_celsius;
  /// On the hand about the tool's origin, world frame, for a device that can turn.
  Vec3 torque_in_world_newton_mm{0.0, 0.0, 0.0};
};

/// Of a positive value, in an event.
inline std::int64_t thousandths(double value) noexcept {
  return static_cast<std::int64_t>(value * 1000.0 + 0.5);
}

/// Writes one step's output; what it says, the followed record follows.
class StepWriter {
 public:
  /// Borrows all three for the step.
  StepWriter(std::int64_t tick, FollowedRecord& record, StepOutput& output,
             std::int32_t& next_job) noexcept
      : tick_(tick), record_(record), output_(output), next_job_(next_job) {}

  std::int64_t tick() const noexcept { return tick_; }
  const FollowedRecord& record() const noexcept { return record_; }
  StepOutput& output() noexcept { return output_; }

  void say(CutEventKind kind, std::int32_t subject = -1, std::int64_t value = 0,
           const QuantisedPose& pose = {}) noexcept {
    const CutEvent event{tick_, kind, subject, value, pose};
    CHECK(record_.apply(event));
    output_.events.push(event);
  }
  bool may_ask() const noexcept { return !output_.requests.is_full(); }
  /// needs   may_ask()
  void ask(JobKind kind, std::int32_t subject) noexcept {
    output_.requests.push({next_job_++, kind, subject, tick_});
  }
  /// The sample of this step; the kerfs that rose.
  std::span<const RisenKerf> put(const ToolSample& sample) noexcept {
    output_.sample = sample;
    return record_.apply(sample);
  }

 private:
  std::int64_t tick_;
  FollowedRecord& record_;
  StepOutput& output_;
  std::int32_t& next_job_;
};

}  // namespace hallux::simulator
