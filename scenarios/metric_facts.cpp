#include "scenarios/metric_facts.h"

#include <array>

namespace hallux::scenarios {
namespace {

constexpr std::array<MetricFacts, static_cast<std::size_t>(Metric::Count)> facts = {{
    {Metric::AngleDeg, "angle between the normals of the fitted and the planned plane",
     "docs/metrics.md"},
    {Metric::TransverseTiltDeg,
     "difference of atan2(n_z, n_x), actual minus planned, both normals distal", "docs/metrics.md"},
    {Metric::SagittalTiltDeg,
     "difference of atan2(n_y, n_x), actual minus planned, both normals distal", "docs/metrics.md"},
    {Metric::LocationMm,
     "greatest one-sided distance of a sample of the face from the planned plane",
     "docs/metrics.md; an ISO 1101 zone of position is twice as wide"},
    {Metric::MeanMm, "mean of the distances of the samples from the planned plane, without sign",
     "docs/metrics.md"},
    {Metric::RmsMm, "root mean square of the distances of the samples from the planned plane",
     "docs/metrics.md"},
    {Metric::EntryMm,
     "actual minus planned plane at the plan's entry, along x across the bone, else along the "
     "planned normal",
     "docs/metrics.md"},
    {Metric::ExitMm,
     "actual minus planned plane at the plan's exit, along x across the bone, else along the "
     "planned normal",
     "docs/metrics.md"},
    {Metric::DepthMm,
     "distance without sign of the fitted from the planned plane at the depth landmark",
     "docs/metrics.md"},
    {Metric::StepMm,
     "distance without sign of the fitted from the planned plane at the exit landmark",
     "docs/metrics.md"},
    {Metric::FlatnessMm,
     "97.5th minus 2.5th percentile of the distances of the cutting tooth line from its own fitted "
     "plane",
     "docs/metrics.md; surfaces of sawn tibiae, scilit cacd00c7"},
    {Metric::LedgesCount,
     "kerfs of the cut whose wall stands more than 0.5 mm from the face that counts",
     "docs/metrics.md; surfaces of sawn tibiae, scilit cacd00c7"},
    {Metric::PastLandmarkMm,
     "how far the fitted plane passes the depth landmark to the kept side; the worst kerf",
     "docs/metrics.md"},
    {Metric::NotchMm,
     "the part of the step at the exit that goes into the kept bone; the worst kerf",
     "docs/metrics.md"},
    {Metric::ThicknessMm,
     "mean way from the face's samples along its normal to the uncut surface, or to a wedge's "
     "other face",
     "docs/metrics.md"},
    {Metric::ThicknessMaxMm,
     "greatest way from the face's samples along its normal to the uncut surface, or to a wedge's "
     "other face",
     "docs/metrics.md"},
    {Metric::WedgeErrorDeg,
     "difference of the faces' transverse tilts minus the planned one, without sign",
     "docs/metrics.md"},
    {Metric::WedgeSagittalDeg,
     "difference of the faces' sagittal tilts minus the planned one, without sign",
     "docs/metrics.md"},
    {Metric::WedgeReversed,
     "1 where the faces' transverse tilts differ the other way round than planned",
     "docs/metrics.md"},
    {Metric::BaseMm, "gap between the faces at the entry, along x", "docs/metrics.md"},
    {Metric::ApexOffsetMm,
     "distance of the planned hinge's point from the line in which the faces meet",
     "docs/metrics.md"},
    {Metric::ApexAngleDeg, "angle between the line in which the faces meet and the planned one",
     "docs/metrics.md"},
    {Metric::HingeMm,
     "least intact bone between a kerf's tip and the far cortex, rows every 0.05 mm",
     "docs/metrics.md"},
    {Metric::OverCutMm, "how far the teeth opened beyond the far cortex where it lies furthest out",
     "docs/metrics.md"},
    {Metric::HingeLost, "1 where hinge_mm is 0",
     "docs/metrics.md; Fallat, Podiatry Today: a broken hinge is very unstable"},
    {Metric::PieceOut,
     "1 where most of the bone beyond the face, at a 0.5 mm grid, was free and taken out",
     "docs/metrics.md"},
    {Metric::WedgeClosed, "1 where the hinge closed", "docs/metrics.md"},
    {Metric::CorrectionDeg,
     "transverse tilt of the x axis of the half that turned, positive as planned",
     "docs/metrics.md"},
    {Metric::ShorteningMm,
     "by how much the bone's distal end on its axis came nearer to the origin", "docs/metrics.md"},
    {Metric::GapMm,
     "greatest distance of the first face's samples from the second face's plane once turned",
     "docs/metrics.md"},
    {Metric::ContactShare,
     "share of the first face's samples no more than 0.2 mm from the second face once turned",
     "docs/metrics.md"},
    {Metric::JointMarginMm,
     "least distance of opened bone, 0.1 mm grid, from the triangles of the joint surfaces",
     "docs/metrics.md"},
    {Metric::DangerContactsCount,
     "contacts of the running blade with the zone; one ends 0.5 mm away for 0.2 s",
     "docs/metrics.md"},
    {Metric::DangerS, "seconds in which the running blade's distance to the zone was 0 or less",
     "docs/metrics.md"},
    {Metric::DangerDepthMm, "how deep the running blade was in the zone at most",
     "docs/metrics.md"},
    {Metric::HotS, "seconds in which any bone was above 47 degrees Celsius, by the heat model",
     "docs/haptics.md, Heat; thresholds of Eriksson and Albrektsson"},
    {Metric::NecroticMm3,
     "bone whose dose reached 16 minutes at 43 degrees Celsius (CEM43), by the heat model",
     "docs/haptics.md, Heat; thresholds of Eriksson and Albrektsson"},
    {Metric::PlungeMm,
     "way of the furthest tooth along the feed in the 200 ms after a break-through; the worst",
     "docs/metrics.md; plunge of drills, Kazum"},
    {Metric::BreakthroughNewton,
     "mean size of the force on the hand in the 20 ms before a break-through; the worst",
     "docs/metrics.md; Nigam 2022"},
    {Metric::BreakthroughMmS,
     "mean speed along the feed in the 50 ms after a break-through; the worst", "docs/metrics.md"},
    {Metric::ForcePeakNewton, "greatest mean of the force on the hand over 20 ticks that all cut",
     "docs/metrics.md; forces of interns at a drill, unm_jor vol7 23"},
    {Metric::ForceP95Newton, "95th percentile of the force on the hand over the ticks that cut",
     "docs/metrics.md"},
    {Metric::SideLoadNewton,
     "root mean square of the force along the blade's normal over the ticks that cut",
     "docs/metrics.md"},
    {Metric::RestartsCount,
     "entries into the kerfs, after more than 3 mm away, beyond one for each blade's width of the "
     "section",
     "docs/metrics.md"},
    {Metric::AirCuttingS,
     "seconds in stretches over 2 s with the saw on, no contact, within 50 mm of the bone",
     "docs/metrics.md"},
    {Metric::StartedInBone, "1 where the saw was switched on while teeth touched bone",
     "docs/metrics.md"},
    {Metric::IrrigatedShare, "of the ticks that cut, the share with water",
     "docs/metrics.md; temperature at a sagittal saw, FA07B4B6"},
    {Metric::Sparc,
     "median spectral arc length of the handle's speed over free movements; nothing below three",
     "docs/metrics.md, Smoothness; Balasubramanian 2015, 10.1186/s12984-015-0090-9"},
    {Metric::Ldlj,
     "median log dimensionless jerk of the handle's speed over free movements; nothing below three",
     "docs/metrics.md, Smoothness; Balasubramanian 2015, 10.1186/s12984-015-0090-9"},
    {Metric::StepOrder,
     "longest common subsequence of the steps carried out and those required, over the required "
     "ones",
     "docs/metrics.md"},
    {Metric::TimeS, "from started to finished while the clock ran", "docs/metrics.md"},
    {Metric::PlanningS, "from started to the first tick that cut", "docs/metrics.md"},
    {Metric::IdleS, "seconds in stretches over 1.5 s with the handle below 2 mm/s and no cutting",
     "docs/metrics.md"},
    {Metric::PathRatio,
     "way of the tooth line's middle within 50 mm of the bone over the plan's shortest way",
     "docs/metrics.md"},
}};

constexpr bool is_whole() {
  for (std::size_t place = 0; place < facts.size(); ++place) {
    const MetricFacts& row = facts[place];
    if (static_cast<std::size_t>(row.metric) != place) return false;
    if (row.formula.empty() || row.source.empty()) return false;
  }
  return true;
}
static_assert(is_whole(), "a metric lacks its formula or its source");

}  // namespace

const MetricFacts& facts_of(Metric metric) noexcept {
  return facts[static_cast<std::size_t>(metric)];
}

}  // namespace hallux::scenarios
