/// The heart: one step of an attempt. No clock, thread, file, window, random source or allocation.
///
/// The loop calls it 1000 times a second; tests and replay call the same function. Everything it
/// may depend on is in the line of the input tape, and in results of jobs that are themselves
/// functions of earlier lines.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "simulator/record/refusals.h"
#include "simulator/step/attempt_clock.h"
#include "simulator/step/boring.h"
#include "simulator/step/carried_implants.h"
#include "simulator/step/forceps.h"
#include "simulator/step/guide_of_step.h"
#include "simulator/step/hinge_requests.h"
#include "simulator/step/piece_book.h"
#include "simulator/step/piece_requests.h"
#include "simulator/step/sawing.h"
#include "simulator/step/standing_fragments.h"
#include "simulator/step/step_output.h"
#include "simulator/step/tool_in_hand.h"

namespace hallux::simulator {

struct StepInput {
  const TapeLine& line;
  /// For each command ApplyJob of the line its result, borrowed until it is given back; null for
  /// other commands.
  std::array<JobResult*, commands_per_tick> job_results{};
};

/// The matter of an attempt: the bone, the tools, and the rules between them. Who attempts, and how
/// time goes on, is the loop's. An attempt and its replay have the same.
struct SimulationSetup {
  /// Borrowed for as long as the setup lives. Danger zones are said in its frame.
  const Bone& bone;
  Tray tray = {};
  ContactSettings contact = {};
  /// That the operation leaves and closes.
  PlannedBridges bridges = {};
  /// At most danger_zone_limit; the rest is not watched.
  std::vector<DangerCapsule> danger_zones = {};
  /// Beside the first, with it at most bone_limit; borrowed likewise.
  std::vector<const Bone*> further_bones = {};

  /// All of them, the first first.
  FixedList<const Bone*, static_cast<std::size_t>(bone_limit)> bones() const noexcept;
};

/// The state of one attempt.
class Simulation {
 public:
  /// Takes all its memory here.
  /// tissues  of the setup's bones, borrowed for its lifetime
  Simulation(std::span<const TissueMap* const> tissues, const SimulationSetup& setup);
  /// Of one bone.
  Simulation(const TissueMap& tissue, const SimulationSetup& setup)
      : Simulation(std::array{&tissue}, setup) {}
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  const KerfSet& kerfs() const noexcept { return record_.kerfs(); }
  const BoreSet& bores() const noexcept { return record_.bores(); }
  const ImplantSet& implants() const noexcept { return record_.implants(); }
  /// Its place on the tray.
  std::int32_t tool_in_hand() const noexcept { return hand_.place(); }
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
  void apply_commands(const StepInput& input, StepWriter& out) noexcept;
  void apply(const Command& command, const TapeLine& line, StepWriter& out) noexcept;
  void note_clock(ClockChange change, std::int32_t holder, StepWriter& out) const noexcept;
  void finish_step(std::int32_t step, StepWriter& out) noexcept;
  void reopen_step(std::int32_t step, StepWriter& out) noexcept;
  void end(CutEventKind how, StepWriter& out) noexcept;
  void apply_job(JobResult& result, StepWriter& out) noexcept;
  void apply_pieces(JobResult& result, StepWriter& out) noexcept;
  void apply_hinge(JobResult& result, StepWriter& out) noexcept;
  void apply_grip(JobResult& result, StepWriter& out) noexcept;
  std::int32_t part_gripped(const GrippedPiece& found, const KnownPiece& known,
                            StepWriter& out) noexcept;
  void watch_faults(std::uint32_t faults, StepWriter& out) noexcept;
  void announce_pieces(StepWriter& out) noexcept;
  void carry_out_waiting(StepWriter& out) noexcept;
  void pick_up(std::int32_t piece, StepWriter& out) noexcept;
  void want_grip(std::int32_t piece, StepWriter& out) noexcept;
  void ask_for_grip(StepWriter& out) noexcept;
  void refuse_grip(GripRefusal why, StepWriter& out) noexcept;
  QuantisedPose pose_of_gripped() const noexcept;
  void let_go(StepWriter& out) noexcept;
  void choose_tool(std::int32_t place, StepWriter& out) noexcept;
  void leave_implant(StepWriter& out) noexcept;
  void take_implant(std::int32_t implant, const TapeLine& line, StepWriter& out) noexcept;
  void place_tool() noexcept;
  void move(const TapeLine& line, StepWriter& out) noexcept;
  void saw(const Saw& saw, const TapeLine& line, StepWriter& out) noexcept;
  void lead_piece(const TapeLine& line, StepWriter& out) noexcept;
  void stand_still(StepWriter& out) noexcept;
  void apply_to_effects(StepWriter& out) noexcept;
  ToolHand hand_of(const TapeLine& line) const noexcept;
  ToolSite site() const noexcept {
    return {wound(), settings_, world_from_bone_, metal_.capsules()};
  }
  const Wound& wound() const noexcept { return fragments_.wound(); }
  const FragmentPoses& poses() const noexcept { return record_.fragments(); }
  /// The fragment stands as it is now.
  void stand(std::int32_t fragment) noexcept {
    fragments_.stand(fragment, pieces_.removed(fragment));
  }

  RigidTransform world_from_bone_, bone_from_world_;
  ContactSettings settings_;
  FollowedRecord record_;
  ToolEffects effects_;
  ToolInHand hand_;
  StandingFragments fragments_;
  StandingMetal metal_;
  CarriedImplants carried_;
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
  /// Of the line at hand.
  RigidTransform bone_from_handle_;
  std::int32_t next_job_ = 0;
  /// Bits of DeviceFault, of the line before.
  std::uint32_t faults_ = 0;
};

}  // namespace hallux::simulator
