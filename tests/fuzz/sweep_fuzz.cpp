/// Feeds any bytes to parse_sweep: it must throw CutInputError, or give a sweep that a field can be
/// stamped with.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "simulator/base/check.h"
#include "simulator/cutting/field/region_outline.h"
#include "tests/support/outline_area.h"
#include "ui/jobs/cut_sweep.h"

namespace {

using namespace hallux;

constexpr std::size_t poses_at_most = 64;  // a field is small, a list of poses is not

/// The plane that the first pose lies in, with its tip in the middle.
simulator::KerfPlane plane_of(const simulator::SweepPose& pose) {
  const Vec3 hint = std::abs(pose.direction.z) < 0.5 ? Vec3(0.0, 0.0, 1.0) : Vec3(1.0, 0.0, 0.0);
  return {{rotation_from_axes(pose.direction, hint), pose.tip_in_mesh_mm}, 0.5};
}

void stamp(const simulator::Sweep& sweep) {
  const simulator::KerfPlane plane = plane_of(sweep.poses.front());
  ui::expect_in_plane(sweep, plane, "fuzz");
  const simulator::BladePath path = simulator::path_in_plane(sweep, plane);
  simulator::KerfField field({.origin_mm = {-2.0, -2.0}, .u_count = 81, .v_count = 81});
  double before_mm2 = 0.0;
  for (std::size_t i = 0; i < path.poses.size(); ++i) {
    simulator::stamp_motion(field, path.blade, path.poses[i == 0 ? 0 : i - 1], path.poses[i]);
    const double opened_mm2 = tests::area_mm2(outline_of(field));
    CHECK(std::isfinite(opened_mm2) && opened_mm2 > before_mm2 - 1.0e-2);
    before_mm2 = opened_mm2;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(bytes), size);
  try {
    const simulator::Sweep sweep = ui::parse_sweep(text, "fuzz");
    CHECK(!sweep.poses.empty() && sweep.width_mm > 0.0 && sweep.depth_mm > 0.0);
    for (const simulator::SweepPose& pose : sweep.poses) {
      CHECK(std::abs(glm::dot(pose.direction, pose.direction) - 1.0) < 1.0e-9);
    }
    if (sweep.poses.size() <= poses_at_most) stamp(sweep);
  } catch (const ui::CutInputError&) {
  }
  return 0;
}
