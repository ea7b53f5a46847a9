/// What another performance would have earned: a change moves what was done, and the same scorer
/// measures it again.
///
///     tilt, roll, offset, stop    move the kerf as a whole; faces, wedge, bridge and joint margin
///                                 are measured again, what was done to the bone otherwise stays
///     a metric of the work        replaces that one value
///
/// A cut stays as finished as it was: whoever leads the blade elsewhere saws as far.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "assessment/assess.h"
#include "assessment/rebuild/bone_surfaces.h"

namespace hallux::assessment {

/// "tilt:proximal_face", "stop:lateral_hinge", "irrigated_share".
struct Change {
  std::string name;
  /// What is to be in place of what was [deg, mm, or the metric's unit].
  double to = 0.0;
};

/// A change that can be asked for.
struct KnownChange {
  std::string name, unit;
  /// What was.
  double from = 0.0;
  /// Replaces a value instead of moving a kerf.
  bool is_replaced = false;
};

/// What changes earn.
struct WhatIfOutcome {
  database::ScoreCard card;
  std::vector<Measurement> measurements;
};

struct ProposedChange {
  KnownChange change;
  double to = 0.0;
  /// Thousandths of a point of 100; above 0.
  std::int64_t gain_milli = 0;
  /// Of the rubric, those that lose less.
  std::vector<std::string> items;
  /// Those that capped the score, and would not.
  std::vector<std::string> lifted_gates;
};

struct Proposals {
  /// The greatest gain first; three at most.
  std::vector<ProposedChange> changes;
  /// All of them together.
  std::int64_t score_milli = 0, gain_milli = 0;
};

/// Borrows scenario, bones and recording; takes the examination over.
class WhatIf {
 public:
  /// needs   the examination is of these
  WhatIf(const scenarios::Scenario& scenario, simulator::Bones bones,
         const simulator::Recording& recording, std::string_view device_class,
         Examination examination);

  const Examination& examination() const noexcept { return examination_; }
  const std::vector<KnownChange>& known() const noexcept { return known_; }
  /// errors  ScenarioError naming the changes there are, where one is not known
  /// thread  any; tenths of a second where a kerf moves
  WhatIfOutcome with(const std::vector<Change>& changes) const;
  /// The three changes towards the plan, or to full points, that gain most by themselves.
  Proposals propose(const Progress& progress = {}) const;

 private:
  Evidence evidence() const noexcept;
  void know_cut(std::size_t cut);
  void know_hinge(const scenarios::PlannedHinge& hinge);
  void know_metrics();
  const KnownChange& find(const std::string& name) const;
  bool moves(const std::vector<Change>& changes) const;
  std::vector<Measurement> measured_again(const std::vector<Change>& changes) const;
  std::vector<Change> candidates() const;

  const scenarios::Scenario& scenario_;
  simulator::Bones bones_;
  const simulator::Recording& recording_;
  std::string device_class_;
  Examination examination_;
  OpenedFields fields_;
  BoneSurfaces surfaces_;
  std::vector<KnownChange> known_;
};

}  // namespace hallux::assessment
