/// The scoring metrics: one row each with its id, unit, subject and wording. Rubrics, scoring and
/// sentences read this table.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace hallux::scenarios {

/// In the order of the table.
enum class Metric : std::uint8_t {
  AngleDeg,
  TransverseTiltDeg,
  SagittalTiltDeg,
  CommonAxisDeg,
  IncludedAngleDeg,
  LocationMm,
  MeanMm,
  RmsMm,
  EntryMm,
  ExitMm,
  DepthMm,
  StepMm,
  FlatnessMm,
  LedgesCount,
  PastLandmarkMm,
  NotchMm,
  ThicknessMm,
  ThicknessMaxMm,
  WedgeErrorDeg,
  WedgeSagittalDeg,
  WedgeReversed,
  BaseMm,
  ApexOffsetMm,
  ApexAngleDeg,
  HingeMm,
  OverCutMm,
  HingeLost,
  PieceOut,
  WedgeClosed,
  CorrectionDeg,
  ShorteningMm,
  GapMm,
  ContactShare,
  ShiftMm,
  ShiftErrorMm,
  TurnErrorDeg,
  ElevationMm,
  Shifted,
  Fixed,
  DirectionDeg,
  TipToJointMm,
  ProtrusionMm,
  LengthErrorMm,
  Cortices,
  Insertions,
  OverhangMm,
  RightTool,
  JointMarginMm,
  DangerContactsCount,
  DangerS,
  DangerDepthMm,
  HotS,
  NecroticMm3,
  PlungeMm,
  BreakthroughNewton,
  BreakthroughMmS,
  ForcePeakNewton,
  ForceP95Newton,
  SideLoadNewton,
  RestartsCount,
  AirCuttingS,
  StartedInBone,
  IrrigatedShare,
  Sparc,
  Ldlj,
  StepOrder,
  WrongBonesCount,
  TimeS,
  PlanningS,
  IdleS,
  PathRatio,
  Count
};

/// What an item or gate with this metric must name.
enum class MetricSubject : std::uint8_t {
  Cut,
  /// A cut along the bone, which is planned from landmarks of depth and exit.
  CutAlong,
  /// A cut across the bone.
  CutAcross,
  /// The bridge, or the wedge that its two cuts take out.
  Hinge,
  /// One cut, or the worse of a hinge's two.
  CutOrHinge,
  /// One cut, or an implant as below.
  CutOrImplant,
  /// A cut or a hinge whose piece a step removes.
  Piece,
  /// A hinge that a step closes.
  Closing,
  /// A hinge that a step closes, or a fragment.
  ClosingOrFragment,
  OneFragment,
  /// A wire or a screw; or a group of alternative steps, of which the implants of the one that was
  /// carried out are meant, the worst of them.
  OneImplant,
  /// A danger zone, or none: all of them together.
  Zone,
  /// Nothing: it is about the whole attempt.
  Attempt
};

/// Which way a metric is better; a rubric gives its knots so.
enum class MetricSense : std::uint8_t {
  Lower,
  Higher,
  /// A planned value lies between, or it has a sign.
  Band
};

/// How a metric is said: `subject`, the value, `tail`, and where a direction helps `lean`, the
/// direction and `lean_end`. Where the value is 0 and `at_zero` is not empty, that is said in place
/// of all of it.
struct MetricWording {
  const char* subject = "";
  const char* tail = "";
  const char* lean = "";
  const char* lean_end = "";
  const char* at_zero = "";
};

struct MetricName {
  Metric metric = Metric::Count;
  /// The id in rubrics and score cards; its last word is the unit.
  std::string_view name;
  /// Empty for a claim, a count and a share.
  std::string_view unit;
  MetricSubject subject = MetricSubject::Cut;
  MetricSense sense = MetricSense::Lower;
  MetricWording wording = {};
  /// Its value is 1 where it holds, and the item's title says it.
  bool is_claim = false;
  /// Its value may be below 0.
  bool is_signed = false;
};

/// Its value is a number of things, or a claim: exact.
bool is_counted(const MetricName& metric) noexcept;

/// source  docs/metrics.md
std::span<const MetricName> known_metrics() noexcept;
/// Nothing (null) where there is no metric of that name; what is returned lives as long as the
/// program.
const MetricName* find_metric(std::string_view name) noexcept;
std::string_view name_of(Metric metric) noexcept;
/// Whether that metric is known, and a claim.
bool is_claim(std::string_view name) noexcept;

/// "cut", "hinge", "zone", "fragment", "implant", "step" or "attempt": what the metric is about.
std::string_view about_text(MetricSubject subject) noexcept;
/// "lower", "higher" or "band".
std::string_view sense_text(MetricSense sense) noexcept;

}  // namespace hallux::scenarios
