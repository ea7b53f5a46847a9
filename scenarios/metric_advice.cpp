#include "scenarios/metric_advice.h"

#include <array>

namespace hallux::scenarios {
namespace {

constexpr std::array<MetricAdvice, static_cast<std::size_t>(Metric::Count)> advice = {{
    {Metric::AngleDeg, "A face that leans tips what is joined on it.",
     "Sight down the blade from two sides before the teeth touch, and keep the handpiece level "
     "while they find their slot."},
    {Metric::TransverseTiltDeg, "It turns the toe sideways.",
     "Look straight down on the blade before the teeth touch."},
    {Metric::SagittalTiltDeg, "It lifts the toe or presses it down.",
     "Keep the handpiece level with the sole before the teeth touch."},
    {Metric::LocationMm, "Where the cut lies decides what is kept.",
     "Mark the entry, and lay the teeth on the mark before the saw starts."},
    {Metric::MeanMm, "Where the cut lies decides what is kept.",
     "Mark the entry, and lay the teeth on the mark before the saw starts."},
    {Metric::RmsMm, "Where the cut lies decides what is kept.",
     "Mark the entry, and lay the teeth on the mark before the saw starts."},
    {Metric::EntryMm, "The cut began where it was not planned.",
     "Mark the entry, and lay the teeth on the mark before the saw starts."},
    {Metric::ExitMm, "The blade drifted on its way.",
     "Let the saw do the work; a blade that is forced follows the softer bone."},
    {Metric::DepthMm, "Too little leaves the prominence, too much opens the joint.",
     "Lay the blade 1 mm medial to the sulcus, and look again after the first millimetres."},
    {Metric::StepMm, "A ledge or a notch is felt under the skin and weakens the shaft.",
     "Look along the shaft before you saw, and let the blade run out flush with it."},
    {Metric::FlatnessMm, "Faces that are not flat touch in few places and heal slowly.",
     "Keep the blade in its kerf and draw it back only along it."},
    {Metric::LedgesCount, "Faces with ledges touch in few places.",
     "Go on in the first kerf instead of beginning another."},
    {Metric::PastLandmarkMm, "Past the sulcus the head is staked, and the toe may go into varus.",
     "Stay 1 mm medial to the sulcus; take more only after a look."},
    {Metric::NotchMm, "A notch weakens the shaft.",
     "Raise the handle a little before the blade runs out of the shaft."},
    {Metric::ThicknessMm, "What is taken is gone.",
     "Measure before you saw, the blade's thickness included."},
    {Metric::ThicknessMaxMm, "What is taken is gone.",
     "Measure before you saw, the blade's thickness included."},
    {Metric::WedgeErrorDeg, "The wedge is the correction: the toe ends up off by as much.",
     "Measure the base before the second cut, the blade's thickness included."},
    {Metric::WedgeSagittalDeg, "Closing such a wedge lifts the toe or presses it down.",
     "Keep the blade square to the sole in both cuts."},
    {Metric::WedgeReversed, "Closing it bends the toe further the way it was bent.",
     "Begin the second cut on the far side of the first, at the base of the wedge."},
    {Metric::BaseMm, "The base sets the angle: about 1 mm is 4 degrees.",
     "Measure the base before the second cut, the blade's thickness included."},
    {Metric::ApexOffsetMm, "Faces that do not meet at the hinge leave a step.",
     "Aim the second cut at the end of the first."},
    {Metric::ApexAngleDeg, "A hinge that is turned closes askew.",
     "Keep the blade square to the sole in both cuts."},
    {Metric::HingeMm, "Too thin a hinge breaks, too thick a one does not bend.",
     "Ease off when the pitch drops, and look after each millimetre near the far cortex."},
    {Metric::OverCutMm, "Nerve and vessels lie a few millimetres beyond.",
     "Ease to under 10 N before the far cortex, and finish with short strokes."},
    {Metric::HingeLost, "A broken hinge is very unstable.",
     "Ease off when the pitch drops, and stop a millimetre before the far cortex."},
    {Metric::PieceOut, "Without it the operation is not done.",
     "Saw until the piece is free, then take it out."},
    {Metric::WedgeClosed, "An open wedge is a broken toe.",
     "Leave a hinge between 0.8 and 2 mm, take the wedge out, then close it."},
    {Metric::CorrectionDeg, "It is what the operation is for.",
     "Measure the base before the second cut."},
    {Metric::ShorteningMm, "A shorter bone loads its neighbours.",
     "Take no more than the wedge asks for."},
    {Metric::GapMm, "A gap heals slowly.", "Saw both faces flat and square."},
    {Metric::ContactShare, "Faces that hardly touch heal slowly.",
     "Saw both faces flat and square."},
    {Metric::JointMarginMm, "A joint surface that is cut does not come back.",
     "Find the joint line first, and begin further from it."},
    {Metric::DangerContactsCount, "What the running saw touches is cut.",
     "Stop the saw before you move it beside tendons and nerves, and keep its edges inside the "
     "bone."},
    {Metric::DangerS, "What the running saw touches is cut.",
     "Stop the saw before you move it beside tendons and nerves."},
    {Metric::DangerDepthMm, "What the running saw touches is cut.",
     "Stop the saw before you move it beside tendons and nerves."},
    {Metric::HotS, "Bone at 47 degrees for a minute dies.",
     "Start the water first, push steadily, and draw back every few seconds."},
    {Metric::NecroticMm3, "Dead bone heals slowly and may be infected.",
     "Start the water first, push steadily, and draw back every few seconds."},
    {Metric::PlungeMm, "What lies beyond is cut before a hand can stop.",
     "Ease off when the pitch drops, and finish with short strokes."},
    {Metric::BreakthroughNewton, "The push that breaks through plunges.",
     "Ease to under 10 N when the pitch drops."},
    {Metric::BreakthroughMmS, "What lies beyond is cut before a hand can stop.",
     "Ease off when the pitch drops."},
    {Metric::ForcePeakNewton, "A forced blade bends, heats and plunges.",
     "Let the saw do the work: 8 to 15 N are enough."},
    {Metric::ForceP95Newton, "A forced blade bends, heats and plunges.",
     "Let the saw do the work: 8 to 15 N are enough."},
    {Metric::SideLoadNewton, "A blade that is levered bends and leaves its plane.",
     "Push along the blade only; to turn it, draw it back first."},
    {Metric::RestartsCount, "Each new entry may leave a ledge.",
     "Keep the blade in the kerf, and draw it back only along it."},
    {Metric::AirCuttingS, "A saw that runs in the air cuts what it meets.",
     "Stop the saw when it leaves the bone."},
    {Metric::StartedInBone, "Teeth that start in bone catch and jump.",
     "Start the saw a centimetre before the bone."},
    {Metric::IrrigatedShare, "Dry bone heats within seconds.", "Start the water before the saw."},
    {Metric::Sparc, "Corrections on the way cost time and aim.",
     "Look where you are going, then go there in one movement."},
    {Metric::Ldlj, "Corrections on the way cost time and aim.",
     "Look where you are going, then go there in one movement."},
    {Metric::StepOrder, "What is done out of order has to be undone.",
     "Read the next step aloud before you begin it."},
    {Metric::TimeS, "A tourniquet has its time.", "Plan longer, then saw each cut once."},
    {Metric::PlanningS, "A minute of looking spares two of sawing.",
     "Look at the plan from two sides before the first cut."},
    {Metric::IdleS, "Standing still is no planning once bone is open.",
     "Decide on the next stroke while the blade is out."},
    {Metric::PathRatio, "Detours tire the hand and pass what must not be touched.",
     "Go straight to the entry, and leave the way that you came."},
}};

constexpr bool is_whole() {
  for (std::size_t place = 0; place < advice.size(); ++place) {
    const MetricAdvice& row = advice[place];
    if (static_cast<std::size_t>(row.metric) != place) return false;
    if (row.why.empty() || row.next_time.empty()) return false;
  }
  return true;
}
static_assert(is_whole(), "a metric lacks its advice");

}  // namespace

std::string advice_text(std::string_view metric) {
  const MetricName* known = find_metric(metric);
  if (known == nullptr) return {};
  const MetricAdvice& row = advice[static_cast<std::size_t>(known->metric)];
  return std::string(row.why) + " " + std::string(row.next_time);
}

}  // namespace hallux::scenarios
