/// The order within a step is the record's: commands and results of jobs, faults, pieces that are
/// announced, then the tool, its sample, what the sample opened, and last the effects, which have
/// the events' room that is left. Small machines beside this file keep clock, pieces, hinge, guide
/// and the tool in the hand; what stands here passes things between them. Work without a bound is
/// asked for and comes back as a command some ticks later: a replay applies it at the same tick.
#include "simulator/step/simulation.h"

#include <utility>

#include "simulator/base/units.h"
#include "simulator/step/recorded_tool.h"

namespace hallux::simulator {

namespace {

/// Pieces, and sections that were taken, announced in one step; more wait for the next.
constexpr std::size_t pieces_per_step = 2, sections_per_step = 2;
/// That it came free, and of another bone than the first.
constexpr std::size_t events_of_piece = 2;
/// Of the kerfs' memory: the shipped operations open 230 to 800 tiles. Whoever opens more has it
/// touched ahead of the blade, a little in each step.
constexpr std::size_t tiles_ready_at_start = 2048, tiles_kept_ready = 512;
constexpr std::size_t tiles_touched_per_step = 2;

/// Events of one line; heat and danger zones take the room that is left. Each command has at most
/// two, but for that which ends the attempt (a scratch and a piece let go as well).
constexpr std::size_t events_of_commands = 2 * commands_per_tick + 1;
/// Of a saw: metal met, a contact or a start in bone with its kick, or such a kick with the plane
/// frozen, and the plane that a cut has in a further fragment. Of a tool that bores: a point that
/// came through, metal met, a screw seated, a bore entered or begun.
constexpr std::size_t events_of_motion = 4, events_of_implants = 1;
constexpr std::size_t events_of_fault = 1, events_of_piece_taken = 1, events_of_grip = 1;
static_assert(events_of_commands + events_of_fault + sections_per_step +
                  events_of_piece * pieces_per_step + events_of_piece_taken + events_of_grip +
                  events_of_implants + events_of_motion <=
              events_per_step);

FragmentPoses poses_of(const SimulationSetup& setup) noexcept {
  FixedList<RigidTransform, static_cast<std::size_t>(bone_limit)> poses;
  for (const Bone* bone : setup.bones()) poses.push(bone->world_from_bone);
  return FragmentPoses(std::span(poses.begin(), poses.size()));
}

QuantisedPose place_of(const FoundPiece& piece) noexcept {
  return quantise({Quat{1.0, 0.0, 0.0, 0.0}, piece.inside_mm});
}

}  // namespace

FixedList<const Bone*, static_cast<std::size_t>(bone_limit)> SimulationSetup::bones()
    const noexcept {
  FixedList<const Bone*, static_cast<std::size_t>(bone_limit)> all;
  all.push(&bone);
  for (const Bone* further : further_bones) all.push(further);
  return all;
}

Simulation::Simulation(std::span<const TissueMap* const> tissues, const SimulationSetup& setup)
    : world_from_bone_(setup.bone.world_from_bone),
      bone_from_world_(inverse(setup.bone.world_from_bone)),
      settings_(setup.contact),
      record_(setup.tray, poses_of(setup)),
      effects_(setup.bone.world_from_bone,
               {setup.tray.first_saw(), setup.contact.guide.guidance != Guidance::None},
               setup.danger_zones),
      fragments_(tissues, setup.bones(), record_.kerfs()),
      pieces_(poses().bone_count()) {
  record_.make_tiles_ready(tiles_ready_at_start, tiles_ready_at_start);
}

StepOutput Simulation::step(const StepInput& input) noexcept {
  StepOutput output;
  record_.make_tiles_ready(tiles_kept_ready, tiles_touched_per_step);
  StepWriter out(input.line.tick + input.line.ticks - 1, record_, output, next_job_);
  bone_from_handle_ = bone_from_world_ * transform_from(input.line.device.world_from_handle);
  metal_.update(record_.implants(), wound());
  apply_commands(input, out);
  watch_faults(input.line.device.faults, out);
  place_tool();
  announce_pieces(out);
  carry_out_waiting(out);
  carried_.carry_next(wound(), out);
  if (faults_ == 0) hand_.take_up(bone_from_handle_, record_.tray(), wound());
  if (!is_running() || faults_ != 0 || hand_.is_empty()) {
    stand_still(out);
  } else if (forceps_.is_holding()) {
    lead_piece(input.line, out);
  } else {
    move(input.line, out);
  }
  output.tool = hand_.place();
  mark(output.sample, ToolStatus::Running, is_running());
  mark(output.sample, ToolStatus::Faulted, faults_ != 0);
  apply_to_effects(out);
  return output;
}

void Simulation::apply_commands(const StepInput& input, StepWriter& out) noexcept {
  for (std::size_t i = 0; i < input.line.command_count && i < commands_per_tick; ++i) {
    const Command& command = input.line.commands[i];
    if (command.kind == CommandKind::ApplyJob) {
      JobResult* const result = input.job_results[i];
      CHECK(result != nullptr && result->request.id == command.argument);
      apply_job(*result, out);
    } else if (!is_over()) {
      apply(command, input.line, out);
    }
  }
}

void Simulation::apply(const Command& command, const TapeLine& line, StepWriter& out) noexcept {
  switch (command.kind) {
    case CommandKind::Start:
      if (clock_.start()) out.say(CutEventKind::Started);
      break;
    case CommandKind::Pause:
      note_clock(clock_.pause(command.argument), command.argument, out);
      break;
    case CommandKind::Resume:
      note_clock(clock_.resume(command.argument), command.argument, out);
      break;
    case CommandKind::StepDone:
      finish_step(command.argument, out);
      break;
    case CommandKind::ReopenStep:
      reopen_step(command.argument, out);
      break;
    case CommandKind::PickUp:
      pick_up(command.argument, out);
      break;
    case CommandKind::CloseHinge:
      hinge_.want(command.argument);
      break;
    case CommandKind::Finish:
      end(CutEventKind::Finished, out);
      break;
    case CommandKind::Abandon:
      end(CutEventKind::Abandoned, out);
      break;
    case CommandKind::Grip:
      want_grip(command.argument, out);
      break;
    case CommandKind::Release:
      let_go(out);
      break;
    case CommandKind::Impact:
      if (forceps_.is_holding()) forceps_.drive();
      break;
    case CommandKind::ChooseTool:
      choose_tool(command.argument, out);
      break;
    case CommandKind::LeaveImplant:
      leave_implant(out);
      break;
    case CommandKind::TakeImplant:
      take_implant(command.argument, line, out);
      break;
    case CommandKind::ApplyJob:
      break;
  }
}

void Simulation::note_clock(ClockChange change, std::int32_t holder,
                            StepWriter& out) const noexcept {
  if (change == ClockChange::Paused) out.say(CutEventKind::Paused, holder);
  if (change == ClockChange::Resumed) out.say(CutEventKind::Resumed, holder);
}

void Simulation::finish_step(std::int32_t step, StepWriter& out) noexcept {
  out.say(CutEventKind::StepDone, step);
  guide_.finish_step(step);
  hand_.sawing().rest();
}

void Simulation::reopen_step(std::int32_t step, StepWriter& out) noexcept {
  out.say(CutEventKind::StepReopened, step);
  guide_.reopen_step(step);
  hand_.sawing().rest();
}

void Simulation::end(CutEventKind how, StepWriter& out) noexcept {
  let_go(out);
  clock_.end();
  hand_.sawing().end(out);
  out.say(how);
}

void Simulation::apply_job(JobResult& result, StepWriter& out) noexcept {
  switch (result.request.kind) {
    case JobKind::Section:
      out.say(CutEventKind::SectionKnown, result.request.subject, thousandths(result.section_mm2));
      out.output().given_back.push(&result);
      break;
    case JobKind::Pieces:
      apply_pieces(result, out);
      break;
    case JobKind::Hinge:
      apply_hinge(result, out);
      break;
    case JobKind::Grip:
      apply_grip(result, out);
      break;
  }
}

void Simulation::apply_pieces(JobResult& result, StepWriter& out) noexcept {
  piece_requests_.apply();
  pieces_.learn(result.pieces, result.fragment);
  const JobResult*& known = pieces_results_[static_cast<std::size_t>(result.fragment)];
  if (known != nullptr) out.output().given_back.push(known);
  known = &result;
  for (const std::int32_t kerf : result.completed) pieces_.cover_section(kerf);
}

/// A hinge that closes leaves two fragments with surfaces of their own. Its result is kept: the
/// surfaces are borrowed from it.
void Simulation::apply_hinge(JobResult& result, StepWriter& out) noexcept {
  const ClosedHinge& hinge = result.hinge;
  const std::int32_t number = hinge_.asked();
  const bool has_closed = hinge.outcome == HingeOutcome::Closed && !poses().is_full();
  hinge_.apply(has_closed);
  if (!has_closed) {
    out.say(CutEventKind::HingeRefused, static_cast<std::int32_t>(hinge.outcome),
            um_from_mm(hinge.thickness_mm));
    out.output().given_back.push(&result);
    return;
  }
  const DividedFragment& divided = result.divided;
  out.say(CutEventKind::FragmentParted, divided.moved_piece, divided.fragment);
  out.say(CutEventKind::HingeClosed, number, micro_from_unit(hinge.angle_rad),
          quantise(hinge.bone_from_moved));
  const std::int32_t moved = poses().count() - 1;
  carried_.part(divided.fragment, moved, record_.implants());
  pieces_.forget_removed(divided.fragment);
  pieces_.part_new(divided.moved_piece, divided.moved_mm3, divided.inside_moved_mm);
  fragments_.cut_from(divided.fragment, *divided.fixed_surface);
  fragments_.cut_from(moved, *divided.moved_surface);
  fragments_.hang(moved, {hinge.joint.point_mm, hinge.joint.axis, hinge.bridge_radius_mm});
  stand(divided.fragment);
  stand(moved);
  hand_.sawing().leave_kerf();
}

/// A piece that is gripped for the first time becomes a fragment. The job's result is kept: the
/// surfaces of both are borrowed from it.
void Simulation::apply_grip(JobResult& result, StepWriter& out) noexcept {
  const GrippedPiece& found = result.gripped;
  const KnownPiece known = pieces_.find(result.request.subject);
  if (is_over() || found.surface == nullptr || known.piece == nullptr) {
    out.output().given_back.push(&result);
    refuse_grip(GripRefusal::NoSuchPiece, out);
    return;
  }
  hand_.sawing().leave_kerf();
  const std::int32_t fragment = known.is_own ? known.fragment : part_gripped(found, known, out);
  ImplantHold hold = hold_of(fragment, record_.implants(), wound());
  const std::optional<WoundJoint> hinge = fragments_.joint_of(fragment);
  if (hold.is_fixed || (hold.joint && hinge)) {
    if (known.is_own) out.output().given_back.push(&result);
    refuse_grip(GripRefusal::Held, out);
    return;
  }
  out.say(CutEventKind::Gripped, fragment, 0, quantise(poses()[fragment].bone_from_fragment));
  forceps_.hold(fragment, found, wound(), hinge ? hinge : hold.joint, bone_from_handle_);
  if (known.is_own) gripped_result_ = &result;
}

/// The number of the fragment that the piece is from now on.
std::int32_t Simulation::part_gripped(const GrippedPiece& found, const KnownPiece& known,
                                      StepWriter& out) noexcept {
  const std::int32_t parent = known.fragment, piece = known.piece->id;
  CHECK(pieces_.part(piece));
  out.say(CutEventKind::FragmentParted, piece, parent);
  const std::int32_t fragment = poses().count() - 1;
  for (const MetFragment& met : found.met) {
    if (met.fragment == parent) fragments_.cut_from(parent, *met.surface);
  }
  pieces_.forget_removed(parent);
  stand(parent);
  fragments_.cut_from(fragment, *found.surface);
  stand(fragment);
  carried_.part(parent, fragment, record_.implants());
  return fragment;
}

void Simulation::watch_faults(std::uint32_t faults, StepWriter& out) noexcept {
  if (faults == faults_) return;
  faults_ = faults;
  if (faults_ != 0) out.say(CutEventKind::Fault, -1, faults_);
}

void Simulation::announce_pieces(StepWriter& out) noexcept {
  for (std::size_t said = 0; said < sections_per_step; ++said) {
    const std::int32_t kerf = pieces_.announce_next_section();
    if (kerf < 0) break;
    out.say(CutEventKind::SectionCovered, kerf);
  }
  for (std::size_t said = 0; said < pieces_per_step; ++said) {
    const auto [piece, fragment, is_own] = pieces_.announce_next();
    if (piece == nullptr) return;
    if (poses()[fragment].bone != 0) out.say(CutEventKind::PieceOfFragment, piece->id, fragment);
    out.say(CutEventKind::PieceFreed, piece->id, thousandths(piece->volume_mm3), place_of(*piece));
  }
}

/// Wishes from while the pieces are worked out: which piece is meant is known only now, and one
/// that was not known then could be the wedge itself.
void Simulation::carry_out_waiting(StepWriter& out) noexcept {
  if (piece_requests_.is_waiting() || is_over()) return;
  if (pieces_.is_all_announced()) pick_up(pieces_.take_wanted(), out);
  if (piece_requests_.is_wanted() || !out.may_ask()) return;
  if (hinge_.is_wanted() && hinge_.ask(piece_requests_.has_opened())) {
    out.ask(JobKind::Hinge, hinge_.asked());
  }
  const bool wants_grip = forceps_.phase() == Forceps::Phase::Wanted;
  if (wants_grip && pieces_.is_all_announced() && !hinge_.is_asked()) ask_for_grip(out);
}

void Simulation::pick_up(std::int32_t piece, StepWriter& out) noexcept {
  if (piece_requests_.is_waiting()) {
    pieces_.want(piece);
    return;
  }
  const KnownPiece known = pieces_.find(piece);
  if (known.fragment >= 0 && known.fragment == forceps_.fragment()) return;
  const FoundPiece* const taken = pieces_.take_out(piece);
  if (taken == nullptr) return;
  out.say(CutEventKind::PieceRemoved, taken->id, thousandths(taken->volume_mm3), place_of(*taken));
  if (known.is_own) {
    fragments_.take_out(known.fragment);
  } else {
    stand(known.fragment);
  }
}

void Simulation::want_grip(std::int32_t piece, StepWriter& out) noexcept {
  if (forceps_.is_empty()) {
    forceps_.want(piece);
  } else {
    out.say(CutEventKind::GripRefused, static_cast<std::int32_t>(GripRefusal::HandsFull), piece);
  }
}

void Simulation::refuse_grip(GripRefusal why, StepWriter& out) noexcept {
  forceps_.let_go();
  out.say(CutEventKind::GripRefused, static_cast<std::int32_t>(why), forceps_.wanted());
}

void Simulation::ask_for_grip(StepWriter& out) noexcept {
  const KnownPiece known = pieces_.find(forceps_.wanted());
  if (known.piece == nullptr) return refuse_grip(GripRefusal::NoSuchPiece, out);
  if (known.is_own && known.fragment < poses().bone_count())
    return refuse_grip(GripRefusal::BoneItself, out);
  const Tray& tray = record_.tray();
  if (!hand_.is_free(tray) || hand_.is_in_bone(tray, wound()))
    return refuse_grip(GripRefusal::ToolInBone, out);
  if (!known.is_own && poses().is_full()) return refuse_grip(GripRefusal::TooMany, out);
  forceps_.ask();
  out.ask(JobKind::Grip, known.piece->id);
}

/// In the frame of its bone, rounded as it is recorded.
QuantisedPose Simulation::pose_of_gripped() const noexcept {
  const RigidTransform& piece = forceps_.wound_from_piece();
  const std::int32_t bone = poses()[forceps_.fragment()].bone;
  if (bone == 0) return quantise(piece);
  return quantise(poses()[bone].fragment_from_world * world_from_bone_ * piece);
}

/// The piece lies where it was led to. The tool is taken up again.
void Simulation::let_go(StepWriter& out) noexcept {
  if (forceps_.phase() == Forceps::Phase::Wanted) forceps_.let_go();
  if (!forceps_.is_holding()) return;
  const std::int32_t fragment = forceps_.fragment();
  out.say(CutEventKind::Released, fragment, 0, pose_of_gripped());
  forceps_.let_go();
  stand(fragment);
  hand_.put_down();
  if (const JobResult* const kept = std::exchange(gripped_result_, nullptr)) {
    out.output().given_back.push(kept);
  }
}

/// Once started the tool is where the hand is; a fault in that tick does not say where that is, so
/// it waits.
void Simulation::place_tool() noexcept {
  if (!clock_.awaits_tool() || faults_ != 0) return;
  hand_.place_at(bone_from_handle_);
  clock_.note_tool_placed();
}

void Simulation::choose_tool(std::int32_t place, StepWriter& out) noexcept {
  const auto refuse = [&](ToolRefusal why) {
    out.say(CutEventKind::ToolRefused, static_cast<std::int32_t>(why), place);
  };
  if (!record_.tray().has(place)) return refuse(ToolRefusal::NoSuchTool);
  if (!forceps_.is_empty()) return refuse(ToolRefusal::HandsFull);
  if (!hand_.is_free(record_.tray())) return refuse(ToolRefusal::ToolInBone);
  out.say(CutEventKind::ToolChosen, place);
  effects_.hold(record_.tray()[place]);
  hand_.choose(place);
}

void Simulation::leave_implant(StepWriter& out) noexcept {
  const bool is_held = forceps_.is_empty() && !hand_.is_empty();
  if (is_held && record_.tray().saw(hand_.place()) == nullptr) {
    if (hand_.boring().leave_implant(record_.tray()[hand_.place()], site(), out)) hand_.put_down();
    return;
  }
  out.say(CutEventKind::ImplantRefused, static_cast<std::int32_t>(ImplantRefusal::NothingToLeave),
          -1);
}

void Simulation::take_implant(std::int32_t implant, const TapeLine& line,
                              StepWriter& out) noexcept {
  const auto refuse = [&](ImplantRefusal why) {
    out.say(CutEventKind::ImplantRefused, static_cast<std::int32_t>(why), implant);
  };
  const ImplantSet& implants = record_.implants();
  if (!implants.is_there(implant) || wound().fragment(implants[implant].fragment) == nullptr)
    return refuse(ImplantRefusal::NoSuchImplant);
  if (implants[implant].tool != hand_.place()) return refuse(ImplantRefusal::OtherTool);
  if (!forceps_.is_empty() || !hand_.is_free(record_.tray()))
    return refuse(ImplantRefusal::HandsFull);
  hand_.boring().take_implant(implant, hand_of(line), site(), out);
  hand_.hold();
  metal_.update(implants, wound());
}

/// While it is worked out how a bone moves, nothing of it is cut.
ToolHand Simulation::hand_of(const TapeLine& line) const noexcept {
  const bool is_bone_held = !hinge_.is_asked() && forceps_.phase() != Forceps::Phase::Asked;
  return {bone_from_handle_, line.device.switches, static_cast<double>(line.ticks) * step_s,
          is_bone_held, guide_.plane(settings_.guide)};
}

void Simulation::move(const TapeLine& line, StepWriter& out) noexcept {
  const Tool& held = record_.tray()[hand_.place()];
  if (const auto* blade = std::get_if<Saw>(&held)) {
    saw(*blade, line, out);
  } else {
    hand_.boring().move(held, hand_of(line), site(), out);
  }
  if (!out.may_ask()) return;
  const std::int32_t kerf = piece_requests_.ask(record_.kerfs());
  if (kerf >= 0) out.ask(JobKind::Pieces, kerf);
}

void Simulation::saw(const Saw& saw, const TapeLine& line, StepWriter& out) noexcept {
  const SawPassage passage = hand_.sawing().move(saw, hand_of(line), site(), out);
  if (passage.has_begun_kerf)
    guide_.note_own_kerf(wound().plane(passage.blade.kerf_after).bone_from_kerf);
  piece_requests_.watch(passage.blade);
}

/// While a piece is held, the tool of the record is the piece.
void Simulation::lead_piece(const TapeLine& line, StepWriter& out) noexcept {
  const GrippedOutcome outcome =
      forceps_.lead(bone_from_handle_, static_cast<double>(line.ticks) * step_s, settings_);
  out.output().torque_in_world_newton_mm =
      transform_direction(world_from_bone_, outcome.pull.torque_newton_mm);
  out.put(sample_of({out.tick(), world_from_bone_}, forceps_.wound_from_piece(), outcome));
}

/// Paused, in a gap, faulted, before the start or after the end. A sample in no kerf and no bore
/// ends a sweep, here as for those who follow the record.
void Simulation::stand_still(StepWriter& out) noexcept {
  hand_.sawing().rest();  // the hand goes on meanwhile: it is led anew, softly
  ToolSample sample;
  sample.tick = out.tick();
  const RigidTransform& held =
      forceps_.is_holding() ? forceps_.wound_from_piece() : hand_.bone_from_tool(record_.tray());
  sample.world_from_tool = quantise(world_from_bone_ * held);
  out.put(sample);
}

/// Events for which this step has no room wait for the next.
void Simulation::apply_to_effects(StepWriter& out) noexcept {
  StepOutput& output = out.output();
  effects_.apply(output.sample, wound());
  CutEvent event;
  while (!output.events.is_full() && effects_.take_event(record_.kerfs(), event))
    output.events.push(event);
  output.flex = effects_.flex();
  output.hottest_celsius = effects_.heat().hottest_now_celsius();
}

}  // namespace hallux::simulator
