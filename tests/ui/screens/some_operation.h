/// A person's Akin operation, recorded on a bone of a thousand triangles: two kerfs, a wedge that
/// comes free and is taken out, a score of the real rubric.
#pragma once

#include "scenarios/scenario.h"
#include "simulator/mesh/bone.h"
#include "simulator/record/record.h"
#include "tests/database/some_course.h"

namespace hallux::ui {

struct SomeOperation {
  scenarios::Scenario scenario;
  simulator::Bone bone;
  /// Without gaps: one line and one sample a tick.
  simulator::Recording recording;
  double wedge_mm3 = 0.0;
  std::int64_t first_cut_done_tick = 0, wedge_out_tick = 0;
};

/// Both faces a few degrees off.
SomeOperation some_operation();

/// Stores it as the attempt of that person, with what was on the screen; with its score unless
/// `is_scored` is false.
database::AttemptId operated_by(database::SomeCourse& course, const std::string& login,
                                const SomeOperation& operation, bool is_scored = true,
                                std::span<const simulator::DisplayFact> facts = {});

}  // namespace hallux::ui
