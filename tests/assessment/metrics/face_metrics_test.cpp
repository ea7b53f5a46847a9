#include "assessment/metrics/face_metrics.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scenarios/site/bone_words.h"
#include "simulator/base/units.h"

namespace hallux::assessment {
namespace {

const FacePlane medial_face{Vec3{0.0, 0.0, -1.0}, 8.0};

TEST(FaceMetrics, ThePlannedFaceItselfHasNoError) {
  const std::vector<Vec3> samples{{50.0, 1.0, -8.0}, {55.0, -3.0, -8.0}};
  const FaceMetrics metrics = measure_face(samples, medial_face, medial_face, {});
  EXPECT_EQ(metrics.angle_deg, 0.0);
  EXPECT_EQ(metrics.location_mm, 0.0);
  EXPECT_EQ(metrics.rms_mm, 0.0);
}

TEST(FaceMetrics, DistancesKeepTheWorstSampleWithItsSign) {
  const std::vector<Vec3> samples{{50.0, 0.0, -7.0}, {55.0, 0.0, -8.5}, {60.0, 0.0, -8.0}};
  const FaceMetrics metrics =
      measure_face(samples, medial_face, medial_face,
                   {Vec3{50.0, 0.0, 0.0}, Vec3{60.0, 0.0, 0.0}, Vec3{0.0, 0.0, -1.0}});
  EXPECT_DOUBLE_EQ(metrics.location_mm, 1.0);
  EXPECT_DOUBLE_EQ(metrics.worst_mm, -1.0);
  EXPECT_EQ(metrics.worst_point_in_bone_mm, samples[0]);
  EXPECT_DOUBLE_EQ(metrics.mean_mm, 0.5);
  EXPECT_DOUBLE_EQ(metrics.rms_mm, std::sqrt(1.25 / 3.0));
}

TEST(FaceMetrics, AFaceThatLooksMoreDorsallyIsDeepestDorsally) {
  const double tilt_rad = radian_from_degree(5.0);
  const FacePlane actual{Vec3{0.0, std::sin(tilt_rad), -std::cos(tilt_rad)}, 8.0};
  const Vec3 deepest = deepest_direction(actual, medial_face);
  EXPECT_EQ(scenarios::direction_text(deepest), "dorsal");
  EXPECT_NEAR(std::sqrt(glm::dot(deepest, deepest)), std::sin(tilt_rad), 1e-12);
  // The dorsal edge of the actual face lies further lateral (z rises), so more bone was taken
  // there.
  const Vec3 dorsal_edge{0.0, 10.0, 0.0};
  EXPECT_LT(distance_along_mm(actual, dorsal_edge, medial_face.normal),
            distance_along_mm(medial_face, dorsal_edge, medial_face.normal));
  EXPECT_NEAR(measure_face({}, actual, medial_face, {}).angle_deg, 5.0, 1e-12);
}

}  // namespace
}  // namespace hallux::assessment
