/// The whole way from a recording to a score card.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "assessment/measurement.h"
#include "assessment/rebuild/bone_surfaces.h"
#include "assessment/rebuild/cut_face.h"
#include "assessment/rebuild/evidence.h"
#include "assessment/rebuild/rebuild.h"
#include "database/records/score.h"
#include "scenarios/plan.h"
#include "scenarios/scenario.h"
#include "simulator/base/progress.h"
#include "simulator/mesh/bones.h"
#include "simulator/record/tape_lines.h"

namespace hallux::assessment {

/// The score and all that it was computed from, for reports and replays.
struct Examination {
  scenarios::Plan plan;
  RebuiltBone rebuilt;
  /// Per planned cut, the one that counts first; may be empty.
  std::vector<std::vector<CutFace>> faces;
  std::vector<Measurement> measurements;
  database::ScoreCard card;
};

/// recorded      its tape is visited a few times
/// device_class  of what the saw was led with; the rubric may have knots of its own for it
/// errors  Cancelled; ScenarioError where the scenario does not fit the bone (see plan_on); those
///         of whoever keeps the tape
/// thread  any; the same arguments give the same card
Examination assess_fully(const scenarios::Scenario& scenario, simulator::Bones bones,
                         const simulator::Recorded& recorded, std::string_view device_class,
                         const Progress& progress = {});

/// What was kept of an attempt that was examined before.
struct Measured {
  /// Computed from the recording by this version of the metrics.
  std::vector<Measurement> measurements;
  /// For showing: nothing seals what was kept beside the recording.
  OpenedFields opened;
};

/// The same of what was kept: nothing is stamped and nothing measured. The card is made from the
/// measurements alone, whatever the fields are.
/// needs   the outputs of the recording
/// errors  as above
Examination examine_measured(const scenarios::Scenario& scenario, simulator::Bones bones,
                             const simulator::Recording& recording, std::string_view device_class,
                             Measured measured, const Progress& progress = {});

/// What the faces, hinges and pieces tell, and the margin to joints: what follows from where the
/// kerfs lie.
/// surfaces  of the evidence's bones
std::vector<Measurement> measure_geometry(const Evidence& evidence, const BoneSurfaces& surfaces);

/// Each place was said in the frame of the bone that the measurement is of; from now on in that of
/// the first.
void say_in_first(std::vector<Measurement>& all, const Evidence& evidence);

/// The card that these measurements earn by the scenario's rubric: what a change of knots, weights
/// or gates needs.
database::ScoreCard score_measurements(const scenarios::Scenario& scenario,
                                       std::span<const Measurement> measurements,
                                       std::string_view device_class, std::int32_t engine);

}  // namespace hallux::assessment
