/// The order within a step is the record's: commands and results of jobs, faults, pieces that are
/// announced, then the tool, its sample, what the sample opened, and last the effects, which have
/// the events' room that is left. Small machines beside this file keep clock, pieces, hinge and
/// guide; what stands here passes things between them. Work without a bound is asked for and comes
/// back as a command some ticks later: a replay applies it at the same tick.
#include "simulator/step/simulation.h"

#include <utility>

#include "simulator/base/units.h"
#include "simulator/contact/blade_probe.h"

namespace hallux::simulator {

namespace {

/// Pieces, and sections that were taken, announced in one step; more wait for the next.
constexpr std::size_t pieces_per_step = 2, sections_per_step = 2;
/// Of the kerfs' memory: the shipped operations open 230 to 800 tiles. Whoever opens more has it
/// touched ahead of the blade, a little in each step.
constexpr std::size_t tiles_ready_at_start = 2048, tiles_kept_ready = 512;
constexpr std::size_t tiles_touched_per_step = 2;

/// Events of one line; heat and danger zones take the room that is left. Each command has at most
/// two, but for that which ends the attempt (a scratch and a piece let go as well).
constexpr std::size_t events_of_commands = 2 * commands_per_tick + 1;
/// A contact or a saw started in bone with its kick, or such a kick with the plane frozen; and the
/// plane that a cut has in a further fragment.
constexpr std::size_t events_of_motion = 3;
constexpr std::size_t events_of_fault = 1, events_of_piece_taken = 1, events_of_grip = 1;
static_assert(events_of_commands + events_of_fault + sections_per_step + pieces_per_step +
                  events_of_piece_taken + events_of_grip + events_of_motion <=
              events_per_step);

std::int64_t thousandths(double value) noexcept {
  return static_cast<std::int64_t>(value * 1000.0 + 0.5);
}
}  // namespace

Simulation::Simulation(const TissueMap& tissue, const SimulationSetup& setup)
    : world_from_bone_(setup.bone.world_from_bone),
      bone_from_world_(inverse(setup.bone.world_from_bone)),
      saw_(setup.saw),
      settings_(setup.contact),
      kerfs_(setup.saw.blade, setup.bone.world_from_bone),
      effects_(setup.bone.world_from_bone,
               {setup.saw, setup.contact.guide.guidance != Guidance::None}, setup.danger_zones),
      fragments_(tissue, setup.bone, kerfs_) {
  kerfs_.make_tiles_ready(tiles_ready_at_start, tiles_ready_at_start);
}

StepOutput Simulation::step(const StepInput& input) noexcept {
  StepOutput output;
  kerfs_.make_tiles_ready(tiles_kept_ready, tiles_touched_per_step);
  tick_ = input.line.tick + input.line.ticks - 1;
  bone_from_handle_ = bone_from_handle(input.line);
  apply_commands(input, output);
  watch_faults(input.line.device.faults, output);
  place_tool(input.line);
  announce_pieces(output);
  carry_out_waiting(output);
  take_up_saw(input.line);
  if (!is_running() || faults_ != 0 || is_hand_empty_) {
    stand_still(output);
  } else if (forceps_.is_holding()) {
    lead_piece(input.line, output);
  } else {
    move(input.line, output);
  }
  mark(output.sample, ToolStatus::Running, is_running());
  mark(output.sample, ToolStatus::Faulted, faults_ != 0);
  apply_to_effects(output);
  return output;
}

void Simulation::note(StepOutput& output, CutEventKind kind, std::int32_t subject,
                      std::int64_t value) const noexcept {
  CutEvent event{tick_, kind, subject, value, {}};
  const bool is_about_cutting = kind == CutEventKind::Scratch || kind == CutEventKind::Contact ||
                                kind == CutEventKind::PlaneFrozen ||
                                kind == CutEventKind::Breakthrough || kind == CutEventKind::Kick;
  if (is_about_cutting) event.pose = quantise(tool_.bone_from_tool);
  output.events.push(event);
}

void Simulation::note_piece(StepOutput& output, CutEventKind kind,
                            const FoundPiece& piece) const noexcept {
  output.events.push({tick_, kind, piece.id, thousandths(piece.volume_mm3),
                      quantise({Quat{1.0, 0.0, 0.0, 0.0}, piece.inside_mm})});
}

/// Says what the kerfs and the fragments follow, here as with all who follow the record.
void Simulation::say(const CutEvent& event, StepOutput& output) noexcept {
  CHECK(kerfs_.apply(event));
  output.events.push(event);
}

void Simulation::ask(JobKind kind, std::int32_t subject, StepOutput& output) noexcept {
  output.requests.push({next_job_++, kind, subject, tick_});
}

void Simulation::apply_commands(const StepInput& input, StepOutput& output) noexcept {
  for (std::size_t i = 0; i < input.line.command_count && i < commands_per_tick; ++i) {
    const Command& command = input.line.commands[i];
    if (command.kind == CommandKind::ApplyJob) {
      JobResult* const result = input.job_results[i];
      CHECK(result != nullptr && result->request.id == command.argument);
      apply_job(*result, output);
    } else if (!is_over()) {
      apply(command, output);
    }
  }
}

void Simulation::apply(const Command& command, StepOutput& output) noexcept {
  switch (command.kind) {
    case CommandKind::Start:
      if (clock_.start()) note(output, CutEventKind::Started);
      break;
    case CommandKind::Pause:
      note_clock(clock_.pause(command.argument), command.argument, output);
      break;
    case CommandKind::Resume:
      note_clock(clock_.resume(command.argument), command.argument, output);
      break;
    case CommandKind::StepDone:
      finish_step(command.argument, output);
      break;
    case CommandKind::ReopenStep:
      reopen_step(command.argument, output);
      break;
    case CommandKind::PickUp:
      pick_up(command.argument, output);
      break;
    case CommandKind::CloseHinge:
      hinge_.want(command.argument);
      break;
    case CommandKind::Finish:
      end(CutEventKind::Finished, output);
      break;
    case CommandKind::Abandon:
      end(CutEventKind::Abandoned, output);
      break;
    case CommandKind::Grip:
      want_grip(command.argument, output);
      break;
    case CommandKind::Release:
      let_go(output);
      break;
    case CommandKind::Impact:
      if (forceps_.is_holding()) forceps_.drive();
      break;
    case CommandKind::ApplyJob:
      break;
  }
}

void Simulation::note_clock(ClockChange change, std::int32_t holder,
                            StepOutput& output) const noexcept {
  if (change == ClockChange::Paused) note(output, CutEventKind::Paused, holder);
  if (change == ClockChange::Resumed) note(output, CutEventKind::Resumed, holder);
}

void Simulation::finish_step(std::int32_t step, StepOutput& output) noexcept {
  note(output, CutEventKind::StepDone, step);
  guide_.finish_step(step);
  tool_.guided_s = 0.0;
}

void Simulation::reopen_step(std::int32_t step, StepOutput& output) noexcept {
  note(output, CutEventKind::StepReopened, step);
  guide_.reopen_step(step);
  tool_.guided_s = 0.0;
}

void Simulation::end(CutEventKind how, StepOutput& output) noexcept {
  let_go(output);
  clock_.end();
  if (tool_.stage == ToolStage::Touching && tool_.scratch_mm > 0.0) {
    note(output, CutEventKind::Scratch, -1, um_from_mm(tool_.scratch_mm));
  }
  note(output, how);
}

void Simulation::apply_job(JobResult& result, StepOutput& output) noexcept {
  switch (result.request.kind) {
    case JobKind::Section:
      note(output, CutEventKind::SectionKnown, result.request.subject,
           thousandths(result.section_mm2));
      output.given_back.push(&result);
      break;
    case JobKind::Pieces:
      apply_pieces(result, output);
      break;
    case JobKind::Hinge:
      apply_hinge(result, output);
      break;
    case JobKind::Grip:
      apply_grip(result, output);
      break;
  }
}

void Simulation::apply_pieces(JobResult& result, StepOutput& output) noexcept {
  piece_requests_.apply();
  pieces_.learn(result.pieces, result.fragment);
  const JobResult*& known = pieces_results_[static_cast<std::size_t>(result.fragment)];
  if (known != nullptr) output.given_back.push(known);
  known = &result;
  for (const std::int32_t kerf : result.completed) pieces_.cover_section(kerf);
}

/// A hinge that closes leaves two fragments with surfaces of their own. Its result is kept: the
/// surfaces are borrowed from it.
void Simulation::apply_hinge(JobResult& result, StepOutput& output) noexcept {
  const ClosedHinge& hinge = result.hinge;
  const std::int32_t number = hinge_.asked();
  const bool has_closed = hinge.outcome == HingeOutcome::Closed && !kerfs_.fragments().is_full();
  hinge_.apply(has_closed);
  if (!has_closed) {
    note(output, CutEventKind::HingeRefused, static_cast<std::int32_t>(hinge.outcome),
         um_from_mm(hinge.thickness_mm));
    output.given_back.push(&result);
    return;
  }
  const DividedFragment& divided = result.divided;
  say({tick_, CutEventKind::FragmentParted, divided.moved_piece, divided.fragment, {}}, output);
  say({tick_, CutEventKind::HingeClosed, number, micro_from_unit(hinge.angle_rad),
       quantise(hinge.bone_from_moved)},
      output);
  const std::int32_t moved = kerfs_.fragments().count() - 1;
  pieces_.forget_removed(divided.fragment);
  pieces_.part_new(divided.moved_piece, divided.moved_mm3, divided.inside_moved_mm);
  fragments_.cut_from(divided.fragment, *divided.fixed_surface);
  fragments_.cut_from(moved, *divided.moved_surface);
  fragments_.hang(moved, {hinge.joint.point_mm, hinge.joint.axis, hinge.bridge_radius_mm});
  stand(divided.fragment);
  stand(moved);
  leave_kerf(tool_);
}

/// A piece that is gripped for the first time becomes a fragment. The job's result is kept: the
/// surfaces of both are borrowed from it.
void Simulation::apply_grip(JobResult& result, StepOutput& output) noexcept {
  const GrippedPiece& found = result.gripped;
  const std::int32_t piece = result.request.subject;
  const KnownPiece known = pieces_.find(piece);
  if (is_over() || found.surface == nullptr || known.piece == nullptr) {
    output.given_back.push(&result);
    refuse_grip(GripRefusal::NoSuchPiece, output);
    return;
  }
  std::int32_t fragment = known.fragment;
  leave_kerf(tool_);
  if (!known.is_own) {
    CHECK(pieces_.part(piece));
    say({tick_, CutEventKind::FragmentParted, piece, fragment, {}}, output);
    for (const MetFragment& met : found.met) {
      if (met.fragment == fragment) fragments_.cut_from(fragment, *met.surface);
    }
    pieces_.forget_removed(fragment);
    stand(fragment);
    fragment = kerfs_.fragments().count() - 1;
    fragments_.cut_from(fragment, *found.surface);
    stand(fragment);
  }
  say({tick_, CutEventKind::Gripped, fragment, 0,
       quantise(kerfs_.fragments()[fragment].bone_from_fragment)},
      output);
  forceps_.hold(fragment, found, wound(), fragments_.joint_of(fragment), bone_from_handle_);
  if (known.is_own) gripped_result_ = &result;
}

void Simulation::watch_faults(std::uint32_t faults, StepOutput& output) noexcept {
  if (faults == faults_) return;
  faults_ = faults;
  if (faults_ != 0) note(output, CutEventKind::Fault, -1, faults_);
}

void Simulation::announce_pieces(StepOutput& output) noexcept {
  for (std::size_t said = 0; said < sections_per_step; ++said) {
    const std::int32_t kerf = pieces_.announce_next_section();
    if (kerf < 0) break;
    note(output, CutEventKind::SectionCovered, kerf);
  }
  for (std::size_t said = 0; said < pieces_per_step; ++said) {
    const FoundPiece* const piece = pieces_.announce_next();
    if (piece == nullptr) return;
    note_piece(output, CutEventKind::PieceFreed, *piece);
  }
}

/// Wishes from while the pieces are worked out: which piece is meant is known only now, and one
/// that was not known then could be the wedge itself.
void Simulation::carry_out_waiting(StepOutput& output) noexcept {
  if (piece_requests_.is_waiting() || is_over()) return;
  if (pieces_.is_all_announced()) pick_up(pieces_.take_wanted(), output);
  if (piece_requests_.is_wanted() || output.requests.is_full()) return;
  if (hinge_.is_wanted() && hinge_.ask(piece_requests_.has_opened())) {
    ask(JobKind::Hinge, hinge_.asked(), output);
  }
  const bool wants_grip = forceps_.phase() == Forceps::Phase::Wanted;
  if (wants_grip && pieces_.is_all_announced() && !hinge_.is_asked()) ask_for_grip(output);
}

void Simulation::pick_up(std::int32_t piece, StepOutput& output) noexcept {
  if (piece_requests_.is_waiting()) {
    pieces_.want(piece);
    return;
  }
  const KnownPiece known = pieces_.find(piece);
  if (known.fragment >= 0 && known.fragment == forceps_.fragment()) return;
  const FoundPiece* const taken = pieces_.take_out(piece);
  if (taken == nullptr) return;
  note_piece(output, CutEventKind::PieceRemoved, *taken);
  if (known.is_own) {
    fragments_.take_out(known.fragment);
  } else {
    stand(known.fragment);
  }
}

void Simulation::want_grip(std::int32_t piece, StepOutput& output) noexcept {
  if (forceps_.is_empty()) {
    forceps_.want(piece);
  } else {
    note(output, CutEventKind::GripRefused, static_cast<std::int32_t>(GripRefusal::HandsFull),
         piece);
  }
}

void Simulation::refuse_grip(GripRefusal why, StepOutput& output) noexcept {
  forceps_.let_go();
  note(output, CutEventKind::GripRefused, static_cast<std::int32_t>(why), forceps_.wanted());
}

void Simulation::ask_for_grip(StepOutput& output) noexcept {
  const KnownPiece known = pieces_.find(forceps_.wanted());
  if (known.piece == nullptr) return refuse_grip(GripRefusal::NoSuchPiece, output);
  if (known.is_own && known.fragment < kerfs_.fragments().bone_count())
    return refuse_grip(GripRefusal::BoneItself, output);
  if (tool_.stage != ToolStage::Free || blade_is_in_bone(tool_.bone_from_tool, wound()))
    return refuse_grip(GripRefusal::ToolInBone, output);
  if (!known.is_own && kerfs_.fragments().is_full())
    return refuse_grip(GripRefusal::TooMany, output);
  forceps_.ask();
  ask(JobKind::Grip, known.piece->id, output);
}

/// The piece lies where it was led to, rounded as it is recorded. The saw is taken up again.
void Simulation::let_go(StepOutput& output) noexcept {
  if (forceps_.phase() == Forceps::Phase::Wanted) forceps_.let_go();
  if (!forceps_.is_holding()) return;
  const std::int32_t fragment = forceps_.fragment();
  say({tick_, CutEventKind::Released, fragment, 0, quantise(forceps_.wound_from_piece())}, output);
  forceps_.let_go();
  stand(fragment);
  is_hand_empty_ = true;
  if (const JobResult* const kept = std::exchange(gripped_result_, nullptr)) {
    output.given_back.push(kept);
  }
}

/// Once started the tool is where the hand is; a fault in that tick does not say where that is, so
/// it waits.
void Simulation::place_tool(const TapeLine& line) noexcept {
  if (!clock_.awaits_tool() || faults_ != 0) return;
  tool_.bone_from_tool = bone_from_handle(line);
  clock_.note_tool_placed();
}

/// While it is worked out how a bone moves, nothing of it is sawn.
void Simulation::move(const TapeLine& line, StepOutput& output) noexcept {
  const bool is_bone_held = !hinge_.is_asked() && forceps_.phase() != Forceps::Phase::Asked;
  const ToolInput input{saw_, bone_from_handle(line),
                        has(line.device.switches, Switch::SawRuns) && is_bone_held,
                        static_cast<double>(line.ticks) * step_s, guide_.plane(settings_.guide)};
  const std::int32_t kerf_before = kerf_of_tool();
  const ToolOutcome outcome = move_tool(tool_, input, wound(), settings_);
  report(outcome, output);
  if (outcome.wants_freeze) freeze(output);
  if (input.saw_runs && kerf_before >= 0 && kerf_before == kerf_of_tool()) follow_cut(output);

  output.sample = sample_of(at_end(), tool_, input, outcome, kerf_of_tool());
  mark(output.sample, ToolStatus::Irrigated, has(line.device.switches, Switch::Irrigates));
  output.engaged = outcome.engaged;
  output.torque_in_world_newton_mm =
      transform_direction(world_from_bone_, outcome.torque_in_bone_newton_mm);
  // What is recorded is what cuts: the field follows the rounded pose. The tool itself goes on
  // unrounded, else a feed below half a micrometre a tick would stand still.
  const bool has_opened = !kerfs_.apply(output.sample).empty();
  piece_requests_.watch({kerf_before, kerf_of_tool(), has_opened, outcome.broke_through});
  if (!output.requests.is_full() && piece_requests_.ask()) {
    ask(JobKind::Pieces, piece_requests_.last_opened(), output);
  }
}

/// While a piece is held, the tool of the record is the piece.
void Simulation::lead_piece(const TapeLine& line, StepOutput& output) noexcept {
  const GrippedOutcome outcome =
      forceps_.lead(bone_from_handle(line), static_cast<double>(line.ticks) * step_s, settings_);
  output.sample = sample_of(at_end(), forceps_.wound_from_piece(), outcome);
  output.torque_in_world_newton_mm =
      transform_direction(world_from_bone_, outcome.pull.torque_newton_mm);
  kerfs_.apply(output.sample);
}

/// The forceps were put down: the saw comes back into the hand where its blade is clear of bone.
void Simulation::take_up_saw(const TapeLine& line) noexcept {
  if (!is_hand_empty_ || faults_ != 0) return;
  tool_ = {};
  tool_.bone_from_tool = bone_from_handle(line);
  is_hand_empty_ = blade_is_in_bone(tool_.bone_from_tool, wound());
}

/// Paused, in a gap, faulted, before the start or after the end.
void Simulation::stand_still(StepOutput& output) noexcept {
  tool_.guided_s = 0.0;  // the hand goes on meanwhile: it is led anew, softly
  output.sample.tick = tick_;
  const RigidTransform& held =
      forceps_.is_holding() ? forceps_.wound_from_piece() : tool_.bone_from_tool;
  output.sample.world_from_tool = quantise(world_from_bone_ * held);
  // A sample in no kerf ends a sweep, here as for those who follow the record.
  kerfs_.apply(output.sample);
}

void Simulation::report(const ToolOutcome& outcome, StepOutput& output) const noexcept {
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

/// A touch is deep enough: the blade goes on in a kerf that is already there, or in a new one in
/// its own plane, in the fragment in which most of its teeth stand.
void Simulation::freeze(StepOutput& output) noexcept {
  std::int32_t kerf = find_kerf_to_join(tool_.bone_from_tool, wound(), settings_);
  if (kerf < 0) {
    const std::int32_t fragment = fragment_at_teeth(tool_.bone_from_tool, wound(), tool_.teeth);
    const RigidTransform fragment_from_tool =
        wound().fragment(fragment)->fragment_from(tool_.bone_from_tool);
    kerf = freeze_in(fragment, fragment_from_tool, output);
    if (kerf < 0) {
      note(output, CutEventKind::KerfRefused);
      tool_.is_refused = true;
      return;
    }
    guide_.note_own_kerf(wound().plane(kerf).bone_from_kerf);
  }
  is_cut_refused_ = false;
  enter_kerf(tool_, kerf);
}

/// -1 where there is no kerf left.
std::int32_t Simulation::freeze_in(std::int32_t fragment, const RigidTransform& fragment_from_tool,
                                   StepOutput& output) noexcept {
  const std::int32_t kerf = kerfs_.count();
  if (kerf == kerf_limit) return -1;
  say({tick_, CutEventKind::PlaneFrozen, kerf, fragment, quantise(fragment_from_tool)}, output);
  ask(JobKind::Section, kerf, output);
  return kerf;
}

/// Teeth of a blade in its kerf that stand in another fragment cut there too, in the same plane.
void Simulation::follow_cut(StepOutput& output) noexcept {
  if (kerfs_.fragments().count() == 1 || is_cut_refused_ || output.requests.is_full()) return;
  const KerfNumbers cut = kerfs_.one_cut_with(tool_.kerf);
  const auto is_uncut = [&](std::int32_t fragment) {
    for (const std::int32_t kerf : cut) {
      if (kerfs_.fragment_of(kerf) == fragment) return false;
    }
    return true;
  };
  const std::int32_t fragment =
      fragment_at_teeth(tool_.bone_from_tool, wound(), tool_.teeth, is_uncut);
  if (fragment < 0) return;
  const KerfPlane plane = wound().plane(tool_.kerf);
  const RigidTransform fragment_from_kerf =
      wound().fragment(fragment)->fragment_from(plane.bone_from_kerf);
  if (freeze_in(fragment, fragment_from_kerf, output) >= 0) return;
  note(output, CutEventKind::KerfRefused);
  is_cut_refused_ = true;
}

/// Events for which this step has no room wait for the next.
void Simulation::apply_to_effects(StepOutput& output) noexcept {
  effects_.apply(output.sample, wound());
  CutEvent event;
  while (!output.events.is_full() && effects_.take_event(kerfs_, event)) output.events.push(event);
  output.flex = effects_.flex();
  output.hottest_celsius = effects_.heat().hottest_now_celsius();
}

}  // namespace hallux::simulator
