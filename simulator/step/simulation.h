/// The heart: one step of an attempt. No clock, thread, file, window, random source or allocation.
///
/// The loop calls it 1000 times a second; tests and replay call the same function. Everything it
/// may depend on is in the line of the input tape, and in results of jobs that are themselves
/// functions of earlier lines.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "simulator/base/fixed_list.h"
#include "simulator/contact/tissue.h"
#include "simulator/contact/tool_motion.h"
#include "simulator/jobs/geometry_job.h"
#include "simulator/record/record.h"
#include "simulator/step/attempt_clock.h"
#include "simulator/step/forceps.h"
#include "simulator/step/guide_of_step.h"
#include "simulator/step/hinge_requests.h"
#include "simulator/step/piece_book.h"
#include "simulator/step/piece_requests.h"
#include "simulator/step/recorded_tool.h"
#include "simulator/step/standing_fragments.h"
#include "simulator/step/tool_effects.h"
#include "simulator/tool/saw.h"

namespace hallux::simulator {

struct StepInput {
  const TapeLine& line;
  /// For each command ApplyJob of the line its result, borrowed until it is given back; null for
  /// other commands.
  std::array<JobResult*, commands_per_tick> job_results{};
};

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
  Engagement engaged;
  BladeFlex flex;
  /// Of all bone now.
  double hottest_celsius = body_celsius;
  /// On the hand about the tool's origin, world frame, for a device that can turn.
  Vec3 torque_in_world_newton_mm{0.0, 0.0, 0.0};
};

/// The matter of an attempt: the bone, the tool, and the rules between them. Who attempts, and how
/// time goes on, is the loop's. An attempt and its replay have the same.
struct SimulationSetup {
  /// Borrowed for as long as the setup lives.
  const Bone& bone;
  Saw saw = {};
  ContactSettings contact = {};
  /// That the operation leaves and closes.
  PlannedBridges bridges = {};
  /// At most danger_zone_limit; the rest is not watched.
  std::vector<DangerCapsule> danger_zones = {};
};

/// The state of one attempt.
class Simulation {
 public:
  /// Takes all its memory here. Borrows `tissue`, of the setup's bone, for its lifetime.
  Simulation(const TissueMap& tissue, const SimulationSetup& setup);
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  const KerfSet& kerfs() const noexcept { return kerfs_; }
  /// The fragment in the forceps; -1: none.
  std::int32_t gripped() const noexcept { return forceps_.fragment(); }
  const ToolEffects& effects() const noexcept { return effects_; }
  bool is_over() const noexcept { return clock_.is_over(); }
  /// Started, and neither the operator nor the loop has paused it.
  bool is_running() const noexcept { return clock_.is_running(); }

  /// One step.
  /// needs   line.tick follows the last line; every ApplyJob has its result
  /// thread  haptic; allocates and frees nothing
  StepOutput step(const StepInput& input) noexcept;

 private:
  void apply_commands(const StepInput& input, StepOutput& output) noexcept;
  void apply(const Command& command, StepOutput& output) noexcept;
  void note_clock(ClockChange change, std::int32_t holder, StepOutput& output) const noexcept;
  void finish_step(std::int32_t step, StepOutput& output) noexcept;
  void reopen_step(std::int32_t step, StepOutput& output) noexcept;
  void end(CutEventKind how, StepOutput& output) noexcept;
  void apply_job(JobResult& result, StepOutput& output) noexcept;
  void apply_pieces(JobResult& result, StepOutput& output) noexcept;
  void apply_hinge(JobResult& result, StepOutput& output) noexcept;
  void apply_grip(JobResult& result, StepOutput& output) noexcept;
  void watch_faults(std::uint32_t faults, StepOutput& output) noexcept;
  void announce_pieces(StepOutput& output) noexcept;
  void carry_out_waiting(StepOutput& output) noexcept;
  void pick_up(std::int32_t piece, StepOutput& output) noexcept;
  void want_grip(std::int32_t piece, StepOutput& output) noexcept;
  void ask_for_grip(StepOutput& output) noexcept;
  void refuse_grip(GripRefusal why, StepOutput& output) noexcept;
  void let_go(StepOutput& output) noexcept;
  void take_up_saw(const TapeLine& line) noexcept;
  void place_tool(const TapeLine& line) noexcept;
  void move(const TapeLine& line, StepOutput& output) noexcept;
  void lead_piece(const TapeLine& line, StepOutput& output) noexcept;
  void stand_still(StepOutput& output) noexcept;
  void freeze(StepOutput& output) noexcept;
  std::int32_t freeze_in(std::int32_t fragment, const RigidTransform& fragment_from_tool,
                         StepOutput& output) noexcept;
  void follow_cut(StepOutput& output) noexcept;
  void report(const ToolOutcome& outcome, StepOutput& output) const noexcept;
  void apply_to_effects(StepOutput& output) noexcept;
  void ask(JobKind kind, std::int32_t subject, StepOutput& output) noexcept;
  void say(const CutEvent& event, StepOutput& output) noexcept;
  void note(StepOutput& output, CutEventKind kind, std::int32_t subject = -1,
            std::int64_t value = 0) const noexcept;
  void note_piece(StepOutput& output, CutEventKind kind, const FoundPiece& piece) const noexcept;
  RigidTransform bone_from_handle(const TapeLine& line) const noexcept {
    return bone_from_world_ * transform_from(line.device.world_from_handle);
  }
  /// The kerf that holds the blade, or -1.
  std::int32_t kerf_of_tool() const noexcept {
    return tool_.stage == ToolStage::InKerf ? tool_.kerf : -1;
  }
  const Wound& wound() const noexcept { return fragments_.wound(); }
  RecordedTick at_end() const noexcept { return {tick_, world_from_bone_}; }
  /// The fragment stands as it is now.
  void stand(std::int32_t fragment) noexcept {
    fragments_.stand(fragment, pieces_.removed(fragment));
  }

  RigidTransform world_from_bone_, bone_from_world_;
  Saw saw_;
  ContactSettings settings_;
  KerfSet kerfs_;
  ToolEffects effects_;
  ToolState tool_;
  StandingFragments fragments_;
  AttemptClock clock_;
  GuideOfStep guide_;
  PieceRequests piece_requests_;
  PieceBook pieces_;
  /// Whose pieces of a fragment are in the book; null before the first.
  std::array<const JobResult*, static_cast<std::size_t>(fragment_limit)> pieces_results_{};
  HingeRequests hinge_;
  Forceps forceps_;
  /// To be given back when the forceps let go; null where there is none.
  const JobResult* gripped_result_ = nullptr;
  RigidTransform bone_from_handle_;
  /// The forceps were put down where the blade would stand in bone: it is taken up again beside it.
  bool is_hand_empty_ = false;
  /// No kerf was left for a fragment that the blade's cut reached.
  bool is_cut_refused_ = false;
  std::int32_t next_job_ = 0;
  std::int64_t tick_ = 0;
  /// Bits of DeviceFault, of the line before.
  std::uint32_t faults_ = 0;
};

}  // namespace hallux::simulator
