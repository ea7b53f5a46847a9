#include "assessment/measure_cut.h"

#include <gtest/gtest.h>

#include <cmath>

#include "simulator/base/units.h"
#include "tests/assessment/examined_attempt.h"

namespace hallux::assessment {
namespace {

using testing::AkinAttempt;
using testing::examined;
using testing::ExaminedAttempt;
using testing::Stroke;

/// Poses are recorded to 1 um and quaternions to 1e-6.
constexpr double pose_mm = 0.002;
constexpr double pose_deg = 5e-4;

double tangent(double degree) { return std::tan(radian_from_degree(degree)); }

TEST(FaceAcross, ItsTurnsHaveTheSignsOfTheBone) {
  for (const double sign : {1.0, -1.0}) {
    const ExaminedAttempt made =
        examined(testing::akin_scenario(), AkinAttempt{.transverse_deg = sign * 3.0,
                                                       .sagittal1_deg = sign * 2.0,
                                                       .wedge_deg = 12.0,
                                                       .sagittal2_deg = -sign});
    EXPECT_NEAR(made.value("transverse_tilt_deg", "cut1"), sign * 3.0, pose_deg);
    EXPECT_NEAR(made.value("sagittal_tilt_deg", "cut1"), sign * 2.0, pose_deg);
    EXPECT_NEAR(made.value("transverse_tilt_deg", "cut2"), 2.0 + sign * 3.0, pose_deg);
    EXPECT_NEAR(made.value("sagittal_tilt_deg", "cut2"), -sign, pose_deg);
    EXPECT_EQ(made.found("transverse_tilt_deg", "cut1").direction, sign > 0 ? "medial" : "lateral");
    EXPECT_EQ(made.found("sagittal_tilt_deg", "cut1").direction, sign > 0 ? "plantar" : "dorsal");
  }
}

// The plan's first face is x = 6; it is entered at z = -7.5 and ends at the hinge, z = 6.5.
TEST(FaceAcross, EntryAndExitAreAlongTheBone) {
  const ExaminedAttempt distal =
      examined(testing::akin_scenario(), AkinAttempt{.entry_x_mm = 7.0, .transverse_deg = 3.0});
  EXPECT_NEAR(distal.value("entry_mm", "cut1"), 1.0, pose_mm);
  EXPECT_NEAR(distal.value("exit_mm", "cut1"), 1.0 - 14.0 * tangent(3.0), pose_mm);
  EXPECT_EQ(distal.found("entry_mm", "cut1").direction, "distal");
  const ExaminedAttempt proximal =
      examined(testing::akin_scenario(), AkinAttempt{.entry_x_mm = 5.5, .transverse_deg = 3.0});
  EXPECT_NEAR(proximal.value("entry_mm", "cut1"), -0.5, pose_mm);
  EXPECT_NEAR(proximal.value("exit_mm", "cut1"), -0.5 - 14.0 * tangent(3.0), pose_mm);
  EXPECT_EQ(proximal.found("exit_mm", "cut1").direction, "proximal");
  // The second face is planned to be entered 14 tan 10 degrees further distal.
  EXPECT_NEAR(proximal.value("entry_mm", "cut2"),
              -0.5 - 14.0 * tangent(3.0) + 14.0 * (tangent(13.0) - tangent(10.0)), pose_mm);
}

// The plan is z = -8 with its normal medial; the sulcus lies at x = 50, the exit at x = 10.
TEST(FaceAlong, EntryAndExitAreAlongThePlannedNormal) {
  for (const double face_z_mm : {-9.0, -7.0}) {
    const ExaminedAttempt made =
        examined(testing::block_scenario(), {Stroke{.face_z_mm = face_z_mm}});
    EXPECT_NEAR(made.value("entry_mm", "eminence"), -8.0 - face_z_mm, pose_mm);
    EXPECT_NEAR(made.value("exit_mm", "eminence"), -8.0 - face_z_mm, pose_mm);
    EXPECT_EQ(made.found("exit_mm", "eminence").direction, face_z_mm < -8.0 ? "medial" : "lateral");
    EXPECT_NEAR(made.value("mean_mm", "eminence"), 1.0, pose_mm);
    EXPECT_NEAR(made.value("rms_mm", "eminence"), 1.0, pose_mm);
  }
  const ExaminedAttempt tilted =
      examined(testing::block_scenario(), {Stroke{.tilt_rad = radian_from_degree(2.0)}});
  EXPECT_NEAR(tilted.value("exit_mm", "eminence"), 20.0 * tangent(2.0), pose_mm)
      << "at x = 10 the face lies further medial";
}

// Of the distances of a face turned about its middle the mean is a quarter of its length times the
// slope, the root mean square that length over the root of 12.
TEST(FaceAlong, MeanAndRootMeanSquareOfATurnedFace) {
  const double slope = std::sin(radian_from_degree(3.0));
  const ExaminedAttempt made =
      examined(testing::block_scenario(), {Stroke{.tilt_rad = radian_from_degree(3.0)}});
  const double length_mm = 60.0 / std::cos(radian_from_degree(3.0));
  EXPECT_NEAR(made.value("mean_mm", "eminence"), 0.25 * length_mm * slope, 0.01);
  EXPECT_NEAR(made.value("rms_mm", "eminence"), length_mm * slope / std::sqrt(12.0), 0.01);
  EXPECT_NEAR(made.value("location_mm", "eminence"), 0.5 * length_mm * slope, 0.25 * slope);
}

double ledges_of(const std::vector<Stroke>& strokes) {
  return examined(testing::block_scenario(), strokes).value("ledges_count", "eminence");
}

TEST(Ledges, AreOtherKerfsFurtherThanHalfAMillimetreFromTheFace) {
  EXPECT_EQ(ledges_of({Stroke{}}), 0.0);
  EXPECT_EQ(ledges_of({Stroke{}, Stroke{.face_z_mm = -7.45, .last_y_mm = 6.0}}), 1.0);
  EXPECT_EQ(ledges_of({Stroke{}, Stroke{.face_z_mm = -7.55, .last_y_mm = 6.0}}), 0.0);
  EXPECT_EQ(ledges_of({Stroke{}, Stroke{.face_z_mm = -7.0, .last_y_mm = 6.0},
                       Stroke{.face_z_mm = -6.0, .last_y_mm = 6.0}}),
            2.0);
}

TEST(Ledges, AKerfThatLeftNoWallIsNone) {
  // It was sawn in air above the block.
  EXPECT_EQ(ledges_of({Stroke{}, Stroke{.face_z_mm = -5.0, .last_y_mm = 9.8}}), 0.0);
}

}  // namespace
}  // namespace hallux::assessment
