#include "assessment/measure_piece.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "simulator/base/units.h"
#include "tests/assessment/examined_attempt.h"

namespace hallux::assessment {
namespace {

using testing::examined;
using testing::ExaminedAttempt;
using testing::Stroke;

/// Poses are recorded to 1 um.
constexpr double pose_mm = 0.001;

TEST(Thickness, OfASlabIsTheSameEverywhere) {
  for (const double face_z_mm : {-8.0, -9.25, -6.0}) {
    const ExaminedAttempt made =
        examined(testing::block_scenario(), {Stroke{.face_z_mm = face_z_mm}});
    EXPECT_NEAR(made.value("thickness_mm", "eminence"), face_z_mm + 12.0, pose_mm);
    EXPECT_NEAR(made.value("thickness_max_mm", "eminence"), face_z_mm + 12.0, pose_mm);
  }
}

/// Of bone between a face that is turned by this about the block's y at (30, -8) and the block's
/// medial side, or its distal end where that comes first; at this x of the face.
double thickness_at(double x_mm, double tilt_rad) {
  const double deep_mm = 4.0 + (x_mm - 30.0) * std::tan(tilt_rad);
  return std::min(deep_mm / std::cos(tilt_rad), (60.0 - x_mm) / std::sin(tilt_rad));
}

TEST(Thickness, OfATiltedFaceIsAlongItsOwnNormal) {
  const double tilt_rad = radian_from_degree(4.0);
  const ExaminedAttempt made = examined(testing::block_scenario(), {Stroke{.tilt_rad = tilt_rad}});
  double sum_mm = 0.0, greatest_mm = 0.0;
  constexpr int parts = 60000;
  for (int part = 0; part < parts; ++part) {
    const double thick_mm = thickness_at((part + 0.5) * 60.0 / parts, tilt_rad);
    sum_mm += thick_mm;
    greatest_mm = std::max(greatest_mm, thick_mm);
  }
  // Samples stand a quarter of a millimetre apart, and may have a row more at one end.
  EXPECT_NEAR(made.value("thickness_mm", "eminence"), sum_mm / parts, 0.01);
  EXPECT_NEAR(made.value("thickness_max_mm", "eminence"), greatest_mm,
              0.25 * std::tan(tilt_rad) + pose_mm);
}

TEST(Thickness, OfAWedgeFallsFromItsBaseToTheHinge) {
  const ExaminedAttempt made = examined(testing::akin_with_deeds(), testing::AkinAttempt{});
  // From the first face, across the bone, to one that is turned by 10 degrees about z = 6.5.
  const double slope = std::tan(radian_from_degree(10.0));
  double sum_mm = 0.0, greatest_mm = 0.0;
  const CutFace& first = made.examination.faces[0][0];
  for (const Vec3& sample_mm : first.samples_in_bone_mm) {
    const double thick_mm = std::max(0.0, (6.5 - sample_mm.z) * slope);
    sum_mm += thick_mm;
    greatest_mm = std::max(greatest_mm, thick_mm);
  }
  const double mean_mm = sum_mm / static_cast<double>(first.samples_in_bone_mm.size());
  EXPECT_NEAR(made.value("thickness_mm", "lateral"), mean_mm, pose_mm);
  EXPECT_NEAR(made.value("thickness_max_mm", "lateral"), greatest_mm, pose_mm);
  EXPECT_NEAR(greatest_mm, 14.0 * slope, 0.25 * slope) << "at the entry";
}

TEST(Thickness, WithoutOneOfItsFacesIsNotMade) {
  for (const char* metric : {"thickness_mm", "thickness_max_mm"}) {
    const ExaminedAttempt half =
        examined(testing::akin_with_deeds(), testing::AkinAttempt{.has_second = false});
    EXPECT_EQ(half.found(metric, "lateral").absence, Absence::NotMade);
    EXPECT_EQ(half.found(metric, "lateral").done_fraction, 0.0);
    const ExaminedAttempt none =
        examined(testing::block_scenario(), std::vector<testing::Stroke>{});
    EXPECT_EQ(none.found(metric, "eminence").absence, Absence::NotMade);
  }
}

}  // namespace
}  // namespace hallux::assessment
