#include "scenarios/foot/half_edge_surface.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "scenarios/foot/march_tetrahedra.h"
#include "scenarios/foot/topology.h"
#include "scenarios/scenario_error.h"

namespace hallux::scenarios {
namespace {

simulator::IndexedMesh ball(double spacing_mm) {
  const Field field = [](const Vec3& p) {
    const double r = std::sqrt(glm::dot(p, p) + 1e-12);
    return Dual{r - 3.0, p / r};
  };
  return march_tetrahedra(
      sample_field(field, {{-4.0, -4.0, -4.0}, {4.0, 4.0, 4.0}, spacing_mm, 1.0}));
}

TEST(MarchTetrahedra, ClosesABallOutward) {
  const simulator::IndexedMesh mesh = ball(0.5);
  EXPECT_NO_THROW(check_sphere(mesh, "ball"));
  // Chords lie inside the ball by at most (cube diagonal)^2 / (8 r); volume 4/3 pi 27 = 113.1.
  EXPECT_LT(simulator::signed_volume_mm3(mesh), 113.1);
  EXPECT_GT(simulator::signed_volume_mm3(mesh), 113.1 * (1.0 - 3.0 * 0.75 / (8.0 * 3.0 * 3.0)));
}

TEST(MarchTetrahedra, StaysClosedOnNoise) {
  SampledField noise;
  noise.x_count = noise.y_count = noise.z_count = 9;
  noise.values.assign(729, 1.0);
  for (std::int32_t k = 1; k < 8; ++k) {
    for (std::int32_t j = 1; j < 8; ++j) {
      for (std::int32_t i = 1; i < 8; ++i) {
        noise.values[noise.index(i, j, k)] = (i * 7 + j * 13 + k * 31) % 5 < 2 ? -0.3 : 0.4;
      }
    }
  }
  EXPECT_EQ(topology_of(march_tetrahedra(noise)).unpaired_edges, 0);
}

TEST(HalfEdgeSurface, RefusesAnOpenMesh) {
  simulator::IndexedMesh mesh = ball(1.0);
  mesh.triangles.pop_back();
  EXPECT_THROW(half_edges_from(mesh), ScenarioError);
}

TEST(HalfEdgeSurface, ComesBackAsItWas) {
  const simulator::IndexedMesh mesh = ball(1.0);
  const simulator::IndexedMesh back = indexed_from(half_edges_from(mesh));
  EXPECT_EQ(back.points_mm, mesh.points_mm);
  ASSERT_EQ(back.triangles.size(), mesh.triangles.size());
  EXPECT_EQ(simulator::signed_volume_mm3(back), simulator::signed_volume_mm3(mesh));
}

RC_GTEST_PROP(HalfEdgeSurface, StaysASphereUnderAnySplitsCollapsesAndFlips, ()) {
  HalfEdgeSurface surface = half_edges_from(ball(1.5));
  OpenMesh::TriConnectivity& mesh = surface.connections;
  const auto moves = *rc::gen::container<std::vector<std::pair<int, unsigned>>>(
      rc::gen::pair(rc::gen::inRange(0, 3), rc::gen::arbitrary<unsigned>()));
  for (const auto& [kind, where] : moves) {
    const OpenMesh::EdgeHandle e(static_cast<int>(where % mesh.n_edges()));
    const OpenMesh::HalfedgeHandle h = mesh.halfedge_handle(e, 0);
    if (mesh.status(e).deleted()) continue;
    if (kind == 0) {
      surface.points_mm.push_back(surface.at(mesh.to_vertex_handle(h)));
      mesh.split(e, mesh.add_vertex());
    }
    if (kind == 1 && mesh.is_collapse_ok(h)) mesh.collapse(h);
    if (kind == 2 && mesh.is_flip_ok(e)) mesh.flip(e);
  }
  const Topology topology = topology_of(indexed_from(surface));
  RC_ASSERT(topology.unpaired_edges == 0);
  RC_ASSERT(topology.components == 1);
  RC_ASSERT(topology.euler_number == 2);
}

TEST(Topology, CountsPartsAndNamesTheFault) {
  simulator::IndexedMesh two = ball(1.0);
  simulator::append_mesh(two, ball(1.0));
  EXPECT_EQ(topology_of(two).components, 2);
  try {
    check_sphere(two, "ball");
    FAIL();
  } catch (const ScenarioError& error) {
    EXPECT_NE(std::string(error.what()).find("the generated ball came out in 2 parts"),
              std::string::npos);
  }
}

}  // namespace
}  // namespace hallux::scenarios
