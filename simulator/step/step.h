/// The heart: one step of an operation. No clock, thread, file, window, random source or allocation.
///
/// The loop calls it 1000 times a second; tests and replay call the same function. Everything it may depend on is in
/// the line of the input tape, and in results of jobs that are themselves functions of earlier lines.
#pragma once

#include <array>
#include <cstdint>

#include "simulator/base/check.h"
#include "simulator/contact/tissue.h"
#include "simulator/contact/tool_motion.h"
#include "simulator/jobs/geometry_job.h"
#include "simulator/record/record.h"
#include "simulator/step/wound.h"

namespace hallux::simulator {

/// A short list with room inside itself.
template <typename Value, std::size_t Capacity>
class FixedList {
 public:
  bool is_full() const noexcept { return count_ == Capacity; }
  std::size_t size() const noexcept { return count_; }
  void push(const Value& value) noexcept {
    CHECK(count_ < Capacity);
    values_[count_++] = value;
  }
  const Value* begin() const noexcept { return values_.data(); }
  const Value* end() const noexcept { return values_.data() + count_; }

 private:
  std::array<Value, Capacity> values_{};
  std::size_t count_ = 0;
};

struct StepInput {
  const TapeLine& line;
  /// For each command ApplyJob of the line its result, borrowed until the attempt ends; null for other commands.
  std::array<const JobResult*, commands_per_tick> job_results{};
};

inline constexpr std::size_t events_per_step = 16;

struct StepOutput {
  ToolSample sample;
  FixedList<CutEvent, events_per_step> events;  ///< before the sample, in order
  FixedList<JobRequest, 2> requests;            ///< to be run on the state after this step
  Engagement engaged;                           ///< for displays; not recorded
  BladeFlex flex;                               ///< likewise
  double hottest_celsius = body_celsius;        ///< of all bone now; likewise
  /// On the hand about the tool's origin, world frame, for a device that can turn; not recorded.
  Vec3 torque_in_world_newton_mm{0.0, 0.0, 0.0};
};

inline constexpr std::size_t removed_piece_limit = 8;

class Operation {
 public:
  /// Takes all its memory here. Borrows `tissue` for its lifetime.
  Operation(const TissueMap& tissue, const RigidTransform& world_from_bone, const BladeSize& blade,
            const ContactSettings& settings, const WoundSettings& wound = {});

  const KerfSet& kerfs() const noexcept { return kerfs_; }
  const Wound& wound() const noexcept { return wound_; }
  bool is_over() const noexcept { return is_over_; }
  /// Started, and neither the operator nor the loop has paused it.
  bool is_running() const noexcept {
    return is_started_ && !is_over_ && !is_paused_ && !is_in_gap_;
  }

  /// One step.
  /// needs   line.tick follows the last line; every ApplyJob has its result
  /// thread  haptic; allocates nothing
  StepOutput step(const StepInput& input) noexcept;

 private:
  void apply_commands(const StepInput& input, StepOutput& output) noexcept;
  void apply(const Command& command, const JobResult* result, StepOutput& output) noexcept;
  void apply_job(const JobResult& result, StepOutput& output) noexcept;
  void pause(bool is_now_paused, const Command& command, StepOutput& output) noexcept;
  void carry_out_waiting(StepOutput& output) noexcept;
  void pick_up(std::int32_t piece, StepOutput& output) noexcept;
  void place(const TapeLine& line) noexcept;
  void move(const TapeLine& line, StepOutput& output) noexcept;
  void freeze(StepOutput& output) noexcept;
  void report(const ToolOutcome& outcome, StepOutput& output) noexcept;
  void watch_growth(const FieldWindow& opened, std::int32_t kerf_before,
                    bool broke_through) noexcept;
  void ask_for_pieces(StepOutput& output) noexcept;
  void ask_for_hinge(StepOutput& output) noexcept;
  void apply_pieces(const JobResult& result, StepOutput& output) noexcept;
  void apply_hinge(const ClosedHinge& hinge, StepOutput& output) noexcept;
  void announce_pieces(StepOutput& output) noexcept;
  void follow_wound(StepOutput& output) noexcept;
  void note(StepOutput& output, CutEventKind kind, std::int32_t subject = -1,
            std::int64_t value = 0) const noexcept;
  /// The plane that leads the hand now, or null.
  const GuidePlane* guide() const noexcept;
  /// The kerf that holds the blade, or -1.
  std::int32_t kerf_of_tool() const noexcept {
    return tool_.stage == ToolStage::InKerf ? tool_.kerf : -1;
  }
  StandingBone standing() const noexcept {
    return {tissue_, kerfs_, {removed_pieces_.data(), removed_count_}};
  }

  const TissueMap& tissue_;
  RigidTransform world_from_bone_, bone_from_world_;
  ContactSettings settings_;
  KerfSet kerfs_;
  Wound wound_;
  ToolState tool_;
  std::array<bool, static_cast<std::size_t>(kerf_limit)> is_completed_{};  ///< per kerf
  std::array<const Bvh*, removed_piece_limit> removed_pieces_{};
  std::size_t removed_count_ = 0;
  const JobResult* pieces_ = nullptr;
  std::size_t announced_ = 0;
  std::int32_t next_job_ = 0;
  std::int64_t tick_ = 0;
  std::uint32_t faults_ = 0;
  std::int32_t freed_last_ = 0;     ///< the piece announced last; 0: none was
  std::int32_t last_opened_ = -1;   ///< the kerf that opened last
  bool has_opened_ = false;         ///< since the pieces were asked for
  bool wants_pieces_ = false;       ///< the blade left a kerf or the bone behind it
  bool is_pieces_waiting_ = false;  ///< asked for, not applied yet
  std::int32_t wanted_piece_ = 0;   ///< to be picked up once the pieces are known; 0: none
  bool wants_hinge_ = false;        ///< likewise
  bool is_hinge_waiting_ = false;
  bool is_hinge_closed_ = false;
  bool is_started_ = false;
  bool is_placed_ = false;  ///< the tool has been put where the hand is
  bool is_paused_ = false;  ///< by the operator
  bool is_in_gap_ = false;  ///< by the loop
  bool is_pause_noted_ = false;
  bool is_over_ = false;
  std::int64_t step_at_hand_ = 0;  ///< the one after that declared done last
  bool has_own_kerf_ = false;      ///< begun in that step: the guide has done its work
};

}  // namespace hallux::simulator
