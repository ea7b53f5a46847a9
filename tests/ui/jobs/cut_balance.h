/// Cuts a bone's file by seeded planes and holds the pieces against the balance that every cut must
/// keep.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "simulator/base/random.h"
#include "simulator/mesh/read_mesh.h"
#include "ui/jobs/cut_mesh.h"

namespace hallux::tests {

/// A plane in a random direction through the middle half of the mesh's extent.
inline ui::CutGroup random_group(const simulator::IndexedMesh& mesh, Random& random) {
  ui::CutGroup group;
  group.normal = {random.normal(), random.normal(), random.normal()};
  double low = INFINITY, high = -INFINITY;
  for (const Vec3& point : mesh.points_mm) {
    low = std::min(low, glm::dot(group.normal, point));
    high = std::max(high, glm::dot(group.normal, point));
  }
  group.offset = low + (high - low) * random.uniform(0.25, 0.75);
  group.kerf_mm = random.uniform(0.2, 1.2);
  return group;
}

/// pieces + debris + removed = input, within 1e-6 of the input and 0.1 percent of what was removed;
/// every piece closed.
inline void expect_balance(const std::filesystem::path& mesh_file, std::uint64_t seed,
                           int group_count) {
  const simulator::IndexedMesh mesh = simulator::read_mesh(mesh_file);
  Random random(seed);
  ui::CutRequest request{mesh_file, {}, {}};
  for (int i = 0; i < group_count; ++i) request.groups.push_back(random_group(mesh, random));
  request.output_folder = std::filesystem::path(testing::TempDir()) /
                          ("cut-" + mesh_file.stem().string() + "-" + std::to_string(seed));
  const ui::CutReport report = ui::cut_mesh(request, {});
  ASSERT_GE(report.pieces.size(), 2U);
  double sum_mm3 = report.debris_mm3 + report.removed_mm3;
  for (const ui::WrittenPiece& piece : report.pieces) {
    EXPECT_TRUE(piece.is_closed) << piece.file;
    sum_mm3 += piece.volume_mm3;
    EXPECT_NO_THROW(simulator::read_mesh(request.output_folder / piece.file));
  }
  EXPECT_NEAR(sum_mm3, report.input_mm3, 1.0e-6 * report.input_mm3);
  EXPECT_NEAR(sum_mm3, report.input_mm3, 1.0e-3 * report.removed_mm3);
  std::filesystem::remove_all(request.output_folder);
}

}  // namespace hallux::tests
