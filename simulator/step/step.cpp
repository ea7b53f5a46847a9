#include "simulator/step/step.h"

#include <algorithm>
#include <utility>

#include "simulator/base/units.h"

namespace hallux::simulator {

namespace {

/// Pieces announced in one step; more wait for the next.
constexpr std::size_t pieces_per_step = 2;

/// What one line may have to tell; heat and danger zones take the room that is left. Each command one event, but for that which
/// brings the pieces (each kerf covered) and that which ends the attempt (a scratch as well).
constexpr std::size_t events_of_commands =
    (commands_per_tick - 1) + static_cast<std::size_t>(kerf_limit) + 1;
/// A contact or a saw started in bone with its kick, or such a kick with the plane frozen.
constexpr std::size_t events_of_motion = 2;
constexpr std::size_t events_of_fault = 1, events_of_piece_taken = 1;
static_assert(events_of_commands + events_of_fault + pieces_per_step + events_of_piece_taken +
                  events_of_motion <=
              events_per_step);

std::uint32_t bit(ToolStatus status) noexcept { return static_cast<std::uint32_t>(status); }

std::int64_t thousandths(double value) noexcept {
  return static_cast<std::int64_t>(value * 1000.0 + 0.5);
}

SawInHand saw_of(const ContactSettings& settings) noexcept {
  return {settings.cycles_per_minute, settings.sharpness,
          settings.guide.guidance != Guidance::None};
}

}  // namespace

Operation::Operation(const TissueMap& tissue, const RigidTransform& world_from_bone,
                     const BladeSize& blade, const ContactSettings& settings,
                     const WoundSettings& wound)
    : tissue_(tissue),
      world_from_bone_(world_from_bone),
      bone_from_world_(inverse(world_from_bone)),
      settings_(settings),
      kerfs_(blade, world_from_bone),
      wound_(world_from_bone, blade, saw_of(settings), wound) {}

StepOutput Operation::step(const StepInput& input) noexcept {
  StepOutput output;
  tick_ = input.line.tick + input.line.ticks - 1;
  output.sample.tick = tick_;
  apply_commands(input, output);
  if (input.line.device.faults != faults_) {
    faults_ = input.line.device.faults;
    if (faults_ != 0) note(output, CutEventKind::Fault, -1, faults_);
  }
  place(input.line);
  announce_pieces(output);
  carry_out_waiting(output);
  if (is_running() && faults_ == 0) {
    move(input.line, output);
    ask_for_pieces(output);
  } else {
    tool_.guided_s = 0.0;  // the hand went on meanwhile: it is led anew, softly
    output.sample.world_from_tool = quantise(world_from_bone_ * tool_.bone_from_tool);
    // A sample in no kerf ends a sweep, here as for those who follow the record.
    kerfs_.follow(output.sample);
  }
  if (is_running()) output.sample.status |= bit(ToolStatus::Running);
  if (faults_ != 0) output.sample.status |= bit(ToolStatus::Faulted);
  follow_wound(output);
  return output;
}

void Operation::note(StepOutput& output, CutEventKind kind, std::int32_t subject,
                     std::int64_t value) const noexcept {
  CutEvent event{tick_, kind, subject, value, {}};
  const bool is_about_cutting = kind == CutEventKind::Scratch || kind == CutEventKind::Contact ||
                                kind == CutEventKind::PlaneFrozen ||
                                kind == CutEventKind::Breakthrough || kind == CutEventKind::Kick;
  if (is_about_cutting) event.pose = quantise(tool_.bone_from_tool);
  output.events.push(event);
}

void Operation::apply_commands(const StepInput& input, StepOutput& output) noexcept {
  for (std::size_t i = 0; i < input.line.command_count && i < commands_per_tick; ++i) {
    apply(input.line.commands[i], input.job_results[i], output);
  }
}

void Operation::apply(const Command& command, const JobResult* result,
                      StepOutput& output) noexcept {
  if (command.kind == CommandKind::ApplyJob) {
    CHECK(result != nullptr && result->request.id == command.argument);
    apply_job(*result, output);
    return;
  }
  if (is_over_) return;
  switch (command.kind) {
    case CommandKind::Start:
      if (!is_started_) note(output, CutEventKind::Started);
      is_started_ = true;
      break;
    case CommandKind::Pause:
      pause(true, command, output);
      break;
    case CommandKind::Resume:
      pause(false, command, output);
      break;
    case CommandKind::StepDone:
      note(output, CutEventKind::StepDone, command.argument);
      step_at_hand_ = std::int64_t{command.argument} + 1;
      has_own_kerf_ = false;
      tool_.guided_s = 0.0;
      break;
    case CommandKind::PickUp:
      pick_up(command.argument, output);
      break;
    case CommandKind::CloseHinge:
      wants_hinge_ = true;
      break;
    case CommandKind::Finish:
    case CommandKind::Abandon:
      is_over_ = true;
      if (tool_.stage == ToolStage::Touching && tool_.scratch_mm > 0.0) {
        note(output, CutEventKind::Scratch, -1, um_from_mm(tool_.scratch_mm));
      }
      note(output,
           command.kind == CommandKind::Finish ? CutEventKind::Finished : CutEventKind::Abandoned);
      break;
    case CommandKind::ApplyJob:
      break;
  }
}

/// The operator's pause and the loop's gap are two things: the end of a gap does not end a pause.
void Operation::pause(bool is_now_paused, const Command& command, StepOutput& output) noexcept {
  const bool was_running = is_running();
  (command.argument == paused_by_loop ? is_in_gap_ : is_paused_) = is_now_paused;
  if (was_running && is_now_paused) {
    note(output, CutEventKind::Paused, command.argument);
    is_pause_noted_ = true;
  }
  // A gap that began before the start was no pause of the operation.
  if (!was_running && is_running() && std::exchange(is_pause_noted_, false)) {
    note(output, CutEventKind::Resumed, command.argument);
  }
}

void Operation::apply_job(const JobResult& result, StepOutput& output) noexcept {
  switch (result.request.kind) {
    case JobKind::Contact:
      note(output, CutEventKind::SectionKnown, result.request.kerf,
           thousandths(result.section_mm2));
      break;
    case JobKind::Pieces:
      apply_pieces(result, output);
      break;
    case JobKind::Hinge:
      apply_hinge(result.hinge, output);
      break;
  }
}

void Operation::apply_pieces(const JobResult& result, StepOutput& output) noexcept {
  is_pieces_waiting_ = false;
  pieces_ = &result;
  announced_ = 0;
  for (const std::int32_t kerf : result.completed) {
    bool& is_completed = is_completed_[static_cast<std::size_t>(kerf)];
    if (!is_completed) note(output, CutEventKind::SectionCovered, kerf);
    is_completed = true;
  }
}

void Operation::apply_hinge(const ClosedHinge& hinge, StepOutput& output) noexcept {
  is_hinge_waiting_ = false;
  if (hinge.outcome != HingeOutcome::Closed) {
    note(output, CutEventKind::HingeRefused, static_cast<std::int32_t>(hinge.outcome),
         um_from_mm(hinge.thickness_mm));
    return;
  }
  is_hinge_closed_ = true;
  CutEvent event{tick_, CutEventKind::HingeClosed, -1, micro_from_unit(hinge.angle_rad),
                 quantise(hinge.bone_from_moved)};
  output.events.push(event);
}

void Operation::announce_pieces(StepOutput& output) noexcept {
  if (pieces_ == nullptr) return;
  for (std::size_t said = 0; announced_ < pieces_->pieces.size() && said < pieces_per_step;
       ++announced_) {
    const PieceBody& piece = pieces_->pieces[announced_];
    if (!piece.is_new) continue;
    note(output, CutEventKind::PieceFreed, piece.id, thousandths(piece.volume_mm3));
    freed_last_ = piece.id;
    ++said;
  }
}

/// Follows what is recorded; events for which this step has no room wait for the next.
void Operation::follow_wound(StepOutput& output) noexcept {
  wound_.follow(output.sample, standing());
  CutEvent event;
  while (!output.events.is_full() && wound_.take_event(kerfs_, event)) output.events.push(event);
  output.flex = wound_.flex();
  output.hottest_celsius = wound_.heat().hottest_now_celsius();
}

/// What was asked for while the pieces are worked out waits for them: which one is meant is known only then, and one that
/// is not known yet could be the wedge itself.
void Operation::carry_out_waiting(StepOutput& output) noexcept {
  if (is_pieces_waiting_ || is_over_) return;
  const bool is_all_announced = pieces_ == nullptr || announced_ == pieces_->pieces.size();
  if (wanted_piece_ != 0 && is_all_announced) pick_up(std::exchange(wanted_piece_, 0), output);
  if (!wants_hinge_ || wants_pieces_ || output.requests.is_full()) return;
  wants_hinge_ = false;
  ask_for_hinge(output);
}

void Operation::pick_up(std::int32_t piece, StepOutput& output) noexcept {
  if (is_pieces_waiting_) {
    wanted_piece_ = piece;
    return;
  }
  if (piece == piece_freed_last) piece = freed_last_;
  if (pieces_ == nullptr || piece <= 0 || removed_count_ == removed_piece_limit) return;
  for (const PieceBody& body : pieces_->pieces) {
    if (body.id != piece) continue;
    const Bvh* const bvh = body.bvh.get();
    const auto end = removed_pieces_.begin() + static_cast<std::ptrdiff_t>(removed_count_);
    if (std::find(removed_pieces_.begin(), end, bvh) != end) return;
    removed_pieces_[removed_count_++] = bvh;
    note(output, CutEventKind::PieceRemoved, piece);
    return;
  }
}

/// Once started the tool is where the hand is; a fault in that tick does not say where that is, so it waits.
void Operation::place(const TapeLine& line) noexcept {
  if (!is_started_ || is_placed_ || faults_ != 0) return;
  tool_.bone_from_tool = bone_from_world_ * transform_from(line.device.world_from_handle);
  is_placed_ = true;
}

void Operation::move(const TapeLine& line, StepOutput& output) noexcept {
  // A bone whose hinge is closed is not sawn again: its halves no longer lie where its kerfs were opened.
  const ToolInput input{bone_from_world_ * transform_from(line.device.world_from_handle),
                        has(line.device.switches, Switch::SawRuns) && !is_hinge_closed_,
                        static_cast<double>(line.ticks) * step_s, guide()};
  const std::int32_t kerf_before = kerf_of_tool();
  const ToolOutcome outcome = move_tool(tool_, input, standing(), settings_);
  report(outcome, output);
  if (outcome.wants_freeze) freeze(output);

  ToolSample& sample = output.sample;
  sample.world_from_tool = quantise(world_from_bone_ * tool_.bone_from_tool);
  const Vec3 force_newton = transform_direction(world_from_bone_, outcome.force_in_bone_newton);
  sample.force_mn = {millinewton_from_newton(force_newton.x),
                     millinewton_from_newton(force_newton.y),
                     millinewton_from_newton(force_newton.z)};
  sample.kerf = kerf_of_tool();
  if (input.saw_runs) sample.status |= bit(ToolStatus::SawOn);
  if (has(line.device.switches, Switch::Irrigates)) sample.status |= bit(ToolStatus::Irrigated);
  if (tool_.stage == ToolStage::InKerf) sample.status |= bit(ToolStatus::InKerf);
  if (outcome.engaged.width_mm() > 0.0) sample.status |= bit(ToolStatus::InContact);
  if (outcome.advance_mm > 0.0) sample.status |= bit(ToolStatus::Cutting);
  if (outcome.is_force_limited) sample.status |= bit(ToolStatus::ForceLimited);
  output.engaged = outcome.engaged;
  output.torque_in_world_newton_mm =
      transform_direction(world_from_bone_, outcome.torque_in_bone_newton_mm);
  // What is recorded is what cuts: the field follows the rounded pose. The tool itself goes on unrounded, else a feed
  // below half a micrometre a tick would stand still.
  watch_growth(kerfs_.follow(sample), kerf_before, outcome.broke_through);
}

const GuidePlane* Operation::guide() const noexcept {
  const GuidePlan& plan = settings_.guide;
  if (plan.guidance == Guidance::None || has_own_kerf_ || step_at_hand_ < 0) return nullptr;
  const auto step = static_cast<std::size_t>(step_at_hand_);
  if (step >= plan.of_step.size() || !plan.of_step[step]) return nullptr;
  return &*plan.of_step[step];
}

void Operation::report(const ToolOutcome& outcome, StepOutput& output) noexcept {
  if (outcome.began_contact) note(output, CutEventKind::Contact, tool_.kerf);
  if (outcome.kicked != KickCause::None) {
    note(output, CutEventKind::Kick, static_cast<std::int32_t>(outcome.kicked),
         thousandths(kick_impulse_newton_s));
  }
  if (outcome.scratch_mm > 0.0) {
    note(output, CutEventKind::Scratch, -1, um_from_mm(outcome.scratch_mm));
  }
  if (outcome.broke_through) note(output, CutEventKind::Breakthrough, tool_.kerf);
}

/// A touch is deep enough: the blade goes on in a kerf that is already there, or in a new one in its own plane.
void Operation::freeze(StepOutput& output) noexcept {
  std::int32_t kerf = find_kerf_to_join(tool_.bone_from_tool, standing(), settings_);
  if (kerf < 0) {
    kerf = kerfs_.freeze(quantise(tool_.bone_from_tool));
    if (kerf < 0) {
      note(output, CutEventKind::KerfRefused);
      tool_.is_refused = true;
      return;
    }
    note(output, CutEventKind::PlaneFrozen, kerf);
    has_own_kerf_ = true;
    output.requests.push({next_job_++, JobKind::Contact, kerf, tick_});
  }
  enter_kerf(tool_, kerf);
}

/// The pieces are asked for when the blade has left a kerf in which it cut, and when it has left the bone behind it.
void Operation::watch_growth(const FieldWindow& opened, std::int32_t kerf_before,
                             bool broke_through) noexcept {
  if (!opened.is_empty()) {
    has_opened_ = true;
    last_opened_ = kerf_of_tool();
  }
  const bool has_left = kerf_before >= 0 && kerf_of_tool() != kerf_before;
  if (has_opened_ && (has_left || broke_through)) wants_pieces_ = true;
}

void Operation::ask_for_pieces(StepOutput& output) noexcept {
  if (!wants_pieces_ || is_pieces_waiting_ || output.requests.is_full()) return;
  output.requests.push({next_job_++, JobKind::Pieces, last_opened_, tick_});
  wants_pieces_ = has_opened_ = false;
  is_pieces_waiting_ = true;
}

/// Not while the blade stands in a kerf that it opened since the pieces were last asked for.
void Operation::ask_for_hinge(StepOutput& output) noexcept {
  if (has_opened_ || is_hinge_waiting_ || is_hinge_closed_) return;
  output.requests.push({next_job_++, JobKind::Hinge, -1, tick_});
  is_hinge_waiting_ = true;
}

}  // namespace hallux::simulator
