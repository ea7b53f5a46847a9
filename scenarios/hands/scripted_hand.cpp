#include "scenarios/hands/scripted_hand.h"

#include <algorithm>

#include "scenarios/hands/motion_writer.h"
#include "scenarios/hands/stroke_plan.h"
#include "simulator/base/random.h"
#include "simulator/contact/tool_motion.h"

namespace hallux::scenarios {

namespace {

using simulator::CommandKind;

constexpr double overlap_mm = 3.0;
constexpr double hover_mm = 15.0;  ///< in front of the bone between strokes
constexpr double settle_mm = 2.0;  ///< in front of the bone before sawing

/// Takes the blade through one stroke and out again. Where the stroke ends in bone the push is let go at once.
void write_stroke(MotionWriter& writer, const Stroke& stroke,
                  const std::vector<FeedMoment>& moments, const HandSkill& skill) {
  const double coupling_newton_per_mm = simulator::ContactSettings{}.coupling_newton_per_mm;
  writer.go_to(stroke.first_mm - hover_mm, stroke.along_mm, skill.approach_mm_s);
  writer.set_saw(true);
  writer.go_to(stroke.first_mm - settle_mm, stroke.along_mm, skill.approach_mm_s);
  writer.wait(0.2);
  writer.go_to(stroke.first_mm, stroke.along_mm, lean_mm_s);
  writer.push_through(moments, coupling_newton_per_mm);
  if (stroke.stops_in_bone) {
    writer.go_to(stroke.end_mm, stroke.along_mm, skill.approach_mm_s, 0.3, 0.3);
  } else {
    writer.go_to(stroke.end_mm + skill.push.exit_newton / coupling_newton_per_mm, stroke.along_mm,
                 lean_mm_s, 0.3, 0.3);
  }
  writer.wait(1.0);
  writer.go_to(stroke.first_mm - hover_mm, stroke.along_mm, skill.approach_mm_s, 0.3, 0.0);
  writer.set_saw(false);
}

/// A hand at work: what it knows, what it aims at, and the motion so far.
struct Work {
  const Scenario& scenario;
  const Plan& plan;
  const KnownBone& known;
  const simulator::TissueMap& tissue;
  const HandSkill& skill;
  std::uint64_t seed;
  const std::vector<AimedCut>& cuts;
  MotionWriter& writer;
  std::size_t cut_at_hand;  ///< in whose plane the blade is held
};

std::vector<Stroke> strokes_of(const Work& work, std::size_t cut) {
  const AimedCut& aimed = work.cuts[cut];
  std::vector<Stroke> strokes =
      plan_strokes(aimed.region, work.scenario.blade.size.width_mm, overlap_mm);
  return aimed.stop_mm ? stopped(strokes, *aimed.stop_mm, work.skill.looks) : strokes;
}

/// Where the blade is brought to a cut: in front of its first stroke, or of the bone where the hand means to stop before it.
Stroke first_stroke(const Work& work, std::size_t cut) {
  const std::vector<Stroke> strokes = strokes_of(work, cut);
  return strokes.empty() ? Stroke{.first_mm = work.cuts[cut].region.min_mm.x} : strokes.front();
}

void saw(Work& work, std::size_t cut) {
  const AimedCut& aimed = work.cuts[cut];
  const std::vector<Stroke> strokes = strokes_of(work, cut);
  if (cut != work.cut_at_hand) {
    const Stroke first = first_stroke(work, cut);
    work.writer.turn_to(work.known.bone.world_from_bone * aimed.plane.bone_from_kerf,
                        first.first_mm - 2.0 * hover_mm, first.along_mm, work.skill.approach_mm_s);
    work.cut_at_hand = cut;
  }
  Random jitter(work.seed, cut == 0 ? "hand.strokes" : "hand.strokes." + work.plan.cuts[cut].name);
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    // The first stroke makes the plane; later ones come back to it as well as the hand can.
    if (i > 0) {
      work.writer.set_jitter(jitter.truncated_normal(0.0, work.skill.stroke_jitter_mm),
                             jitter.truncated_normal(0.0, work.skill.stroke_jitter_rad));
    }
    const std::vector<FeedMoment> moments = predict_feed(
        strokes[i], std::span(strokes).first(i), aimed.plane, work.tissue,
        work.scenario.blade.size.width_mm, work.scenario.blade.cycles_per_minute, work.skill.push);
    write_stroke(work.writer, strokes[i], moments, work.skill);
  }
}

std::size_t index_of_cut(const Plan& plan, std::string_view name) {
  return static_cast<std::size_t>(find_cut(plan, name) - plan.cuts.data());
}

void carry_out(Work& work, const OperationStep& step) {
  switch (step.kind) {
    case StepKind::Cut:
      saw(work, index_of_cut(work.plan, step.cut));
      break;
    case StepKind::Remove:
      work.writer.say(CommandKind::PickUp, simulator::piece_freed_last);
      break;
    case StepKind::Close:
      work.writer.say(CommandKind::CloseHinge);
      break;
    case StepKind::Verify:
    case StepKind::Finish:
      break;
  }
  work.writer.wait(step.kind == StepKind::Verify ? 1.0 : 0.5);
}

std::size_t first_cut_of(const Scenario& scenario, const Plan& plan) {
  const auto step =
      std::find_if(scenario.steps.begin(), scenario.steps.end(),
                   [](const OperationStep& candidate) { return candidate.kind == StepKind::Cut; });
  return step == scenario.steps.end() ? 0 : index_of_cut(plan, step->cut);
}

}  // namespace

ScriptedHand make_hand(const Scenario& scenario, const simulator::Bone& bone, const Plan& plan,
                       const HandSkill& skill, std::uint64_t seed) {
  const KnownBone known(bone);
  ScriptedHand hand{{}, aim(scenario, plan, known, skill, seed)};
  const std::size_t first = first_cut_of(scenario, plan);
  const AimedCut& aimed = hand.cuts.at(first);
  MotionWriter writer(bone.world_from_bone * aimed.plane.bone_from_kerf, skill, seed);
  const simulator::TissueMap tissue(bone);
  Work work{scenario, plan, known, tissue, skill, seed, hand.cuts, writer, first};
  const Stroke stroke = first_stroke(work, first);
  writer.place(stroke.first_mm - 3.0 * hover_mm, stroke.along_mm);
  writer.say(CommandKind::Start);
  for (std::size_t step = 0; step < scenario.steps.size(); ++step) {
    carry_out(work, scenario.steps[step]);
    writer.say(CommandKind::StepDone, static_cast<std::int32_t>(step));
  }
  writer.say(CommandKind::Finish);
  hand.motion = writer.finish();
  return hand;
}

}  // namespace hallux::scenarios
