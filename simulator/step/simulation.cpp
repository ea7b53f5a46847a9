/// The order within a step is the record's: commands and results of jobs, faults, pieces that are
/// announced, then the tool, its sample, what the sample opened, and last the effects, which have
/// the events' room that is left. Small machines beside this file keep clock, pieces, hinge and
/// guide; what stands here passes things between them. Work without a bound is asked for and comes
/// back as a command some ticks later: a replay applies it at the same tick.
#include "simulator/step/simulation.h"

#include <utility>

#include "simulator/base/units.h"

namespace hallux::simulator {

namespace {

/// Pieces, and sections that were taken, announced in one step; more wait for the next.
constexpr std::size_t pieces_per_step = 2, sections_per_step = 2;
/// Of the kerfs' memory: the shipped operations open 230 to 800 tiles. Whoever opens more has it
/// touched ahead of the blade, a little in each step.
constexpr std::size_t tiles_ready_at_start = 2048, tiles_kept_ready = 512;
constexpr std::size_t tiles_touched_per_step = 2;

/// Events of one line; heat and danger zones take the room that is left. Each command has one
/// event, but for that which ends the attempt (a scratch as well).
constexpr std::size_t events_of_commands = commands_per_tick + 1;
/// A contact or a saw started in bone with its kick, or such a kick with the plane frozen.
constexpr std::size_t events_of_motion = 2;
constexpr std::size_t events_of_fault = 1, events_of_piece_taken = 1;
static_assert(events_of_commands + events_of_fault + sections_per_step + pieces_per_step +
                  events_of_piece_taken + events_of_motion <=
              events_per_step);

void mark(ToolSample& sample, ToolStatus status, bool is_so) noexcept {
  if (is_so) sample.status |= bit(status);
}

std::int64_t thousandths(double value) noexcept {
  return static_cast<std::int64_t>(value * 1000.0 + 0.5);
}

GuidePlane middle_of(const KerfPlane& kerf) noexcept {
  const Vec3 normal = axis_z(kerf.bone_from_kerf);
  return {normal, glm::dot(normal, kerf.bone_from_kerf.translation_mm)};
}

}  // namespace

Simulation::Simulation(const TissueMap& tissue, const SimulationSetup& setup)
    : tissue_(tissue),
      world_from_bone_(setup.bone.world_from_bone),
      bone_from_world_(inverse(setup.bone.world_from_bone)),
      saw_(setup.saw),
      settings_(setup.contact),
      kerfs_(setup.saw.blade, setup.bone.world_from_bone),
      effects_(setup.bone.world_from_bone,
               {setup.saw, setup.contact.guide.guidance != Guidance::None}, setup.danger_zones) {
  kerfs_.make_tiles_ready(tiles_ready_at_start, tiles_ready_at_start);
}

StepOutput Simulation::step(const StepInput& input) noexcept {
  StepOutput output;
  kerfs_.make_tiles_ready(tiles_kept_ready, tiles_touched_per_step);
  tick_ = input.line.tick + input.line.ticks - 1;
  apply_commands(input, output);
  watch_faults(input.line.device.faults, output);
  place_tool(input.line);
  announce_pieces(output);
  carry_out_waiting(output);
  if (is_running() && faults_ == 0) {
    move(input.line, output);
  } else {
    stand_still(output);
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

void Simulation::ask(JobKind kind, std::int32_t kerf, StepOutput& output) noexcept {
  output.requests.push({next_job_++, kind, kerf, tick_});
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
      hinge_.want();
      break;
    case CommandKind::Finish:
      end(CutEventKind::Finished, output);
      break;
    case CommandKind::Abandon:
      end(CutEventKind::Abandoned, output);
      break;
    case CommandKind::Grip:
    case CommandKind::Release:
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
  clock_.end();
  if (tool_.stage == ToolStage::Touching && tool_.scratch_mm > 0.0) {
    note(output, CutEventKind::Scratch, -1, um_from_mm(tool_.scratch_mm));
  }
  note(output, how);
}

void Simulation::apply_job(JobResult& result, StepOutput& output) noexcept {
  switch (result.request.kind) {
    case JobKind::Section:
      note(output, CutEventKind::SectionKnown, result.request.kerf,
           thousandths(result.section_mm2));
      output.given_back.push(&result);
      break;
    case JobKind::Pieces:
      apply_pieces(result, output);
      break;
    case JobKind::Hinge:
      apply_hinge(result.hinge, output);
      output.given_back.push(&result);
      break;
  }
}

void Simulation::apply_pieces(JobResult& result, StepOutput& output) noexcept {
  piece_requests_.apply();
  pieces_.learn(result.pieces);
  if (const JobResult* const known = std::exchange(pieces_result_, &result)) {
    output.given_back.push(known);
  }
  for (const std::int32_t kerf : result.completed) pieces_.cover_section(kerf);
}

void Simulation::apply_hinge(const ClosedHinge& hinge, StepOutput& output) noexcept {
  const bool has_closed = hinge.outcome == HingeOutcome::Closed;
  hinge_.apply(has_closed);
  if (has_closed) {
    output.events.push({tick_, CutEventKind::HingeClosed, -1, micro_from_unit(hinge.angle_rad),
                        quantise(hinge.bone_from_moved)});
  } else {
    note(output, CutEventKind::HingeRefused, static_cast<std::int32_t>(hinge.outcome),
         um_from_mm(hinge.thickness_mm));
  }
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
  if (!hinge_.is_wanted() || piece_requests_.is_wanted() || output.requests.is_full()) return;
  if (hinge_.ask(piece_requests_.has_opened())) ask(JobKind::Hinge, -1, output);
}

void Simulation::pick_up(std::int32_t piece, StepOutput& output) noexcept {
  if (piece_requests_.is_waiting()) {
    pieces_.want(piece);
    return;
  }
  const FoundPiece* const taken = pieces_.take_out(piece);
  if (taken != nullptr) note_piece(output, CutEventKind::PieceRemoved, *taken);
}

/// Once started the tool is where the hand is; a fault in that tick does not say where that is, so
/// it waits.
void Simulation::place_tool(const TapeLine& line) noexcept {
  if (!clock_.awaits_tool() || faults_ != 0) return;
  tool_.bone_from_tool = bone_from_handle(line);
  clock_.note_tool_placed();
}

void Simulation::move(const TapeLine& line, StepOutput& output) noexcept {
  // A bone whose hinge is closed is not sawn again: its halves no longer lie where its kerfs were
  // opened.
  const ToolInput input{saw_, bone_from_handle(line),
                        has(line.device.switches, Switch::SawRuns) && !hinge_.is_closed(),
                        static_cast<double>(line.ticks) * step_s, guide_.plane(settings_.guide)};
  const std::int32_t kerf_before = kerf_of_tool();
  const ToolOutcome outcome = move_tool(tool_, input, standing(), settings_);
  report(outcome, output);
  if (outcome.wants_freeze) freeze(output);

  output.sample = sample_of(input, outcome);
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

/// Paused, in a gap, faulted, before the start or after the end.
void Simulation::stand_still(StepOutput& output) noexcept {
  tool_.guided_s = 0.0;  // the hand goes on meanwhile: it is led anew, softly
  output.sample.tick = tick_;
  output.sample.world_from_tool = quantise(world_from_bone_ * tool_.bone_from_tool);
  // A sample in no kerf ends a sweep, here as for those who follow the record.
  kerfs_.apply(output.sample);
}

ToolSample Simulation::sample_of(const ToolInput& input,
                                 const ToolOutcome& outcome) const noexcept {
  ToolSample sample;
  sample.tick = tick_;
  sample.world_from_tool = quantise(world_from_bone_ * tool_.bone_from_tool);
  const Vec3 force_newton = transform_direction(world_from_bone_, outcome.force_in_bone_newton);
  sample.force_mn = {millinewton_from_newton(force_newton.x),
                     millinewton_from_newton(force_newton.y),
                     millinewton_from_newton(force_newton.z)};
  sample.kerf = kerf_of_tool();
  mark(sample, ToolStatus::SawOn, input.saw_runs);
  mark(sample, ToolStatus::InKerf, tool_.stage == ToolStage::InKerf);
  mark(sample, ToolStatus::InContact, outcome.engaged.width_mm() > 0.0);
  mark(sample, ToolStatus::Cutting, outcome.advance_mm > 0.0);
  mark(sample, ToolStatus::ForceLimited, outcome.is_force_limited);
  return sample;
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
/// its own plane.
void Simulation::freeze(StepOutput& output) noexcept {
  std::int32_t kerf = find_kerf_to_join(tool_.bone_from_tool, standing(), settings_);
  if (kerf < 0) {
    kerf = kerfs_.freeze(quantise(tool_.bone_from_tool));
    if (kerf < 0) {
      note(output, CutEventKind::KerfRefused);
      tool_.is_refused = true;
      return;
    }
    note(output, CutEventKind::PlaneFrozen, kerf);
    guide_.note_own_kerf(middle_of(kerfs_.plane(kerf)));
    ask(JobKind::Section, kerf, output);
  }
  enter_kerf(tool_, kerf);
}

/// Events for which this step has no room wait for the next.
void Simulation::apply_to_effects(StepOutput& output) noexcept {
  effects_.apply(output.sample, standing());
  CutEvent event;
  while (!output.events.is_full() && effects_.take_event(kerfs_, event)) output.events.push(event);
  output.flex = effects_.flex();
  output.hottest_celsius = effects_.heat().hottest_now_celsius();
}

}  // namespace hallux::simulator
