#include "assessment/metrics/resection.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hallux::assessment {
namespace {

/// The plan stands 1 mm medial (-z) to a sulcus at z = -7 and runs out at a shaft point at z = -8.
const ResectionPlan plan{{Vec3{0.0, 0.0, -1.0}, 8.0}, Vec3{52.0, 4.0, -7.0}, Vec3{38.0, 0.0, -8.0}};

FacePlane face_at(double z_mm) { return {Vec3{0.0, 0.0, -1.0}, -z_mm}; }

TEST(Resection, ThePlannedFaceHasNoError) {
  const ResectionMetrics metrics = measure_resection(plan.face, plan);
  EXPECT_EQ(metrics.depth_error_mm, 0.0);
  EXPECT_EQ(metrics.past_landmark_mm, 0.0);
  EXPECT_EQ(metrics.step_error_mm, 0.0);
  EXPECT_EQ(metrics.notch_mm, 0.0);
}

TEST(Resection, TooLittleTakenLeavesALedgeAndNoNotch) {
  const ResectionMetrics metrics = measure_resection(face_at(-9.25), plan);
  EXPECT_DOUBLE_EQ(metrics.depth_error_mm, 1.25);
  EXPECT_DOUBLE_EQ(metrics.step_error_mm, 1.25);
  EXPECT_EQ(metrics.past_landmark_mm, 0.0);
  EXPECT_EQ(metrics.notch_mm, 0.0);
}

TEST(Resection, TooMuchTakenPassesTheLandmarkByWhatLiesBeyondIt) {
  const ResectionMetrics metrics = measure_resection(face_at(-5.5), plan);
  EXPECT_DOUBLE_EQ(metrics.depth_error_mm, -2.5);
  EXPECT_DOUBLE_EQ(metrics.past_landmark_mm, 1.5);
  EXPECT_DOUBLE_EQ(metrics.notch_mm, 2.5);
}

TEST(Resection, ATiltMovesTheFaceAtTheExitOnly) {
  // Turned about the sulcus by a slope of 1 in 10: at the shaft point, 14 mm proximal, by 1.4 mm.
  const double length = std::sqrt(1.01);
  const Vec3 normal{0.1 / length, 0.0, -1.0 / length};
  const FacePlane tilted{normal, glm::dot(normal, Vec3{52.0, 4.0, -8.0})};
  const ResectionMetrics metrics = measure_resection(tilted, plan);
  EXPECT_NEAR(metrics.depth_error_mm, 0.0, 1e-12);
  EXPECT_NEAR(metrics.step_error_mm, 1.4, 1e-12);
}

}  // namespace
}  // namespace hallux::assessment
