#include "simulator/cutting/solid/working_solid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "simulator/base/random.h"
#include "simulator/cutting/solid/commit_patch.h"
#include "tests/simulator/cutting/worlds/cut_through.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/worlds.h"

namespace hallux::tests {
namespace {

using namespace simulator;

/// A wavy blade's region: as far as `reach_mm` along x, 9 mm wide.
RegionOutline wavy_region(double reach_mm) {
  RegionOutline region;
  region.corners_mm = {Vec2(-50.0, -4.5), Vec2(reach_mm, -4.5)};
  for (int i = 1; i < 20; ++i) {
    region.corners_mm.emplace_back(reach_mm + (i % 2 == 0 ? 0.03 : -0.02), -4.5 + 0.45 * i);
  }
  region.corners_mm.emplace_back(reach_mm, 4.5);
  region.corners_mm.emplace_back(-50.0, 4.5);
  region.loop_ends = {static_cast<std::uint32_t>(region.corners_mm.size())};
  return region;
}

SolidPatch patch_of(const CutSolid& solid, const KerfPlane& plane, std::int32_t kerf,
                    double reach_mm) {
  const KerfContact contact =
      slice_contact(solid, Bvh(solid.mesh), plane, kerf, Vec2(-60.0), Vec2(60.0));
  PatchBuilder builder(contact);
  SolidPatch patch;
  EXPECT_TRUE(builder.build(wavy_region(reach_mm), patch));
  return patch;
}

IndexedMesh world(std::size_t kind) {
  if (kind == 0) return hollow_tube({.segments = 24, .rings = 6});
  if (kind == 1) return sphere(9.0, 7);
  if (kind == 2) return u_shape(Vec3(30.0, 20.0, 8.0), 6.0);
  return solid_block(Vec3(25.0, 12.0, 10.0));
}

/// Slanted, the same plane again, parallel at exactly the kerf's thickness, a wedge to the first.
KerfPlane plane_of_cut(std::int32_t cut, const Vec3& shift_mm) {
  const double step_mm = cut == 2 ? 0.6 : 0.0;
  const Vec3 normal = cut == 3 ? Vec3(0.8, 0.6, 0.0) : Vec3(0.96, 0.28, 0.0);
  return plane_through(shift_mm + step_mm * normal, normal, 0.6, Vec3(0.0, 0.2, 1.0));
}

/// Each half-edge's neighbours agree, each face is a triangle of living parts, and a walk around a vertex meets all of
/// its faces.
void expect_sound(const HalfEdgeMesh& mesh) {
  std::vector<std::size_t> faces_at(mesh.n_vertices(), 0);
  std::size_t faces = 0, edges = 0;
  for (const auto face : mesh.all_faces()) {
    if (mesh.status(face).deleted()) continue;
    ++faces;
    auto side = mesh.halfedge_handle(face);
    for (int k = 0; k < 3; ++k, side = mesh.next_halfedge_handle(side)) {
      ASSERT_EQ(mesh.face_handle(side), face);
      ASSERT_FALSE(mesh.status(side).deleted() || mesh.status(mesh.edge_handle(side)).deleted());
      const auto next = mesh.next_halfedge_handle(side);
      ASSERT_EQ(mesh.prev_halfedge_handle(next), side);
      ASSERT_EQ(mesh.from_vertex_handle(next), mesh.to_vertex_handle(side));
      ASSERT_TRUE(mesh.face_handle(mesh.opposite_halfedge_handle(side)).is_valid());
      ++faces_at[static_cast<std::size_t>(mesh.to_vertex_handle(side).idx())];
    }
    ASSERT_EQ(side, mesh.halfedge_handle(face));
  }
  for (const auto edge : mesh.all_edges()) edges += mesh.status(edge).deleted() ? 0 : 1;
  EXPECT_EQ(2 * edges, 3 * faces);
  for (const auto vertex : mesh.all_vertices()) {
    const std::size_t expected = faces_at[static_cast<std::size_t>(vertex.idx())];
    EXPECT_EQ(mesh.status(vertex).deleted(), expected == 0);
    if (expected == 0) continue;
    std::size_t met = 0;
    auto leaving = mesh.halfedge_handle(vertex);
    do {
      ASSERT_EQ(mesh.from_vertex_handle(leaving), vertex);
      leaving = mesh.opposite_halfedge_handle(mesh.prev_halfedge_handle(leaving));
    } while (++met < 10'000 && leaving != mesh.halfedge_handle(vertex));
    EXPECT_EQ(met, expected);
  }
}

void expect_same(const CutSolid& a, const CutSolid& b) {
  EXPECT_EQ(a.mesh.points_mm.size(), b.mesh.points_mm.size());
  EXPECT_EQ(a.mesh.triangles.size(), b.mesh.triangles.size());
  EXPECT_TRUE(a.mesh == b.mesh);
  EXPECT_TRUE(a.origins == b.origins);
}

TEST(WorkingSolid, BeginsWithTheNumbersOfTheSolid) {
  const CutSolid solid = uncut_solid(world(0));
  const WorkingSolid working(solid);
  const IndexedSolid base = working.indexed();
  expect_same(base.solid, solid);
  for (std::uint32_t i = 0; i < base.faces.size(); ++i) EXPECT_EQ(base.faces[i], i);
  for (std::uint32_t i = 0; i < base.vertices.size(); ++i) EXPECT_EQ(base.vertices[i], i);
  expect_sound(working.half_edges());
}

TEST(WorkingSolid, ShowingAPatchHidesItsFacesAndNoOthers) {
  const CutSolid solid = uncut_solid(world(0));
  WorkingSolid working(solid);
  const IndexedSolid base = working.indexed();
  for (const double reach_mm : {-3.0, 4.0, 1.0}) {
    const SolidPatch patch = patch_of(solid, plane_of_cut(0, Vec3(0.0)), 0, reach_mm);
    ASSERT_FALSE(patch.hidden.empty());
    working.show(patch, base);
    std::vector<std::uint32_t> hidden;
    for (const auto face : working.half_edges().all_faces()) {
      if (working.is_hidden(face)) hidden.push_back(static_cast<std::uint32_t>(face.idx()));
    }
    EXPECT_EQ(hidden, patch.hidden);
    expect_same(working.indexed().solid, solid);
  }
}

TEST(WorkingSolid, FourCommitsInPlaceAreFourCommittedPatches) {
  for (std::size_t kind = 0; kind < 4; ++kind) {
    for (const double reach_mm : {-1.0, 3.0, 40.0}) {
      CutSolid expected = uncut_solid(world(kind));
      WorkingSolid working(expected);
      for (std::int32_t cut = 0; cut < 4; ++cut) {
        const IndexedSolid base = working.indexed();
        const double own_reach_mm = cut == 1 ? reach_mm + 1.0 : reach_mm;
        const SolidPatch patch =
            patch_of(base.solid, plane_of_cut(cut, Vec3(0.3, 0.1, 0.2)), cut, own_reach_mm);
        expected = commit_patch(base.solid, patch);
        ASSERT_EQ(working.commit(patch, base), CommitOutcome::Done);
        expect_same(working.indexed().solid, expected);
        expect_closed(expected);
        expect_sound(working.half_edges());
      }
      EXPECT_EQ(working.commits(), 4U);
    }
  }
}

TEST(WorkingSolid, ACommitLeavesOtherHandlesAndAllTablesWhereTheyAre) {
  const CutSolid solid = uncut_solid(world(1));
  WorkingSolid working(solid);
  const IndexedSolid base = working.indexed();
  const HalfEdgeMesh& mesh = working.half_edges();
  const void* const points = mesh.points();
  const void* const status = &mesh.status(OpenMesh::FaceHandle(0));
  const void* const skins = &working.skin(OpenMesh::VertexHandle(0));
  const void* const edges = &mesh.edge(OpenMesh::EdgeHandle(0));
  const void* const faces = &mesh.face(OpenMesh::FaceHandle(0));
  const SolidPatch patch = patch_of(solid, plane_of_cut(0, Vec3(0.0)), 0, 2.0);
  const SpareRoom before = working.room_left();
  ASSERT_EQ(working.commit(patch, base), CommitOutcome::Done);
  EXPECT_EQ(mesh.points(), points);
  EXPECT_EQ(&mesh.status(OpenMesh::FaceHandle(0)), status);
  EXPECT_EQ(&working.skin(OpenMesh::VertexHandle(0)), skins);
  EXPECT_EQ(&mesh.edge(OpenMesh::EdgeHandle(0)), edges);
  EXPECT_EQ(&mesh.face(OpenMesh::FaceHandle(0)), faces);
  EXPECT_EQ(working.room_left().triangles, before.triangles - patch.triangles.size());

  const std::set<std::uint32_t> hidden(patch.hidden.begin(), patch.hidden.end());
  for (std::uint32_t i = 0; i < solid.mesh.triangles.size(); ++i) {
    const OpenMesh::FaceHandle face(static_cast<int>(i));
    ASSERT_EQ(mesh.status(face).deleted(), hidden.contains(i));
    if (hidden.contains(i)) continue;
    std::size_t k = 0;
    for (const auto corner : mesh.fv_range(face)) {
      const std::uint32_t point = solid.mesh.triangles[i][k++];
      EXPECT_EQ(static_cast<std::uint32_t>(corner.idx()), point);
      const Vec3& place = solid.mesh.points_mm[point];
      EXPECT_EQ(mesh.point(corner), OpenMesh::Vec3d(place.x, place.y, place.z));
    }
  }
}

/// Weights by the normal equations: another way than skin_weights goes.
std::array<double, 3> weights_on(const std::array<Vec3, 3>& at, const Vec3& point) {
  const Vec3 a = at[1] - at[0], b = at[2] - at[0], p = point - at[0];
  const double aa = glm::dot(a, a), ab = glm::dot(a, b), bb = glm::dot(b, b);
  const double pa = glm::dot(p, a), pb = glm::dot(p, b), whole = aa * bb - ab * ab;
  const double second = (pa * bb - pb * ab) / whole, third = (pb * aa - pa * ab) / whole;
  return {1.0 - second - third, second, third};
}

TEST(WorkingSolid, NewPointsOfTheSkinBlendTheirParentsAndPointsOfWallsHaveNone) {
  const CutSolid solid = uncut_solid(sphere(9.0, 9));
  WorkingSolid working(solid);
  const IndexedSolid base = working.indexed();
  const SolidPatch patch = patch_of(solid, plane_of_cut(0, Vec3(0.0)), 0, 2.0);
  std::size_t on_skin = 0, inside = 0;
  for (std::size_t i = 0; i < patch.parents.size(); ++i) {
    const Vec3& point = patch.points_in_bone_mm[i];
    const SkinPoint skin = working.skin_at(base, patch.parents[i], point);
    if (patch.parents[i] == no_index) {
      EXPECT_FALSE(skin.is_on_skin);
      ++inside;
      continue;
    }
    ASSERT_TRUE(skin.is_on_skin);
    ++on_skin;
    const Triangle& parent = solid.mesh.triangles[patch.parents[i]];
    std::array<Vec3, 3> at;
    for (std::size_t k = 0; k < 3; ++k) at[k] = solid.mesh.points_mm[parent[k]];
    const std::array<double, 3> weights = weights_on(at, point);
    Vec3 normal(0.0);
    for (std::size_t k = 0; k < 3; ++k) {
      normal +=
          weights[k] * working.skin(OpenMesh::VertexHandle(static_cast<int>(parent[k]))).normal;
    }
    normal /= std::sqrt(glm::dot(normal, normal));
    const Vec3 turn = skin.normal - normal, shift = skin.on_bone_mm - point;
    EXPECT_LT(glm::dot(turn, turn), 1e-22);
    EXPECT_LT(glm::dot(shift, shift), 1e-22);
  }
  EXPECT_GT(on_skin, 50U);
  EXPECT_GT(inside, 10U);
}

TEST(WorkingSolid, SkinSurvivesFourCutsAndCompaction) {
  WorkingSolid working(uncut_solid(sphere(9.0, 9)));
  for (std::int32_t cut = 0; cut < 4; ++cut) {
    const IndexedSolid base = working.indexed();
    const SolidPatch patch = patch_of(base.solid, plane_of_cut(cut, Vec3(0.0)), cut, 2.0 + cut);
    ASSERT_EQ(working.commit(patch, base), CommitOutcome::Done);
  }
  const WorkingSolid copy = working.compacted();
  expect_same(copy.indexed().solid, working.indexed().solid);
  const HalfEdgeMesh& mesh = copy.half_edges();
  std::size_t bare = 0;
  for (const auto face : mesh.faces()) {
    for (const auto corner : mesh.fv_range(face)) {
      const SkinPoint& skin = copy.skin(corner);
      if (copy.origin(face).kerf == -1) {
        // Each corner of a face of the skin knows its own place and a normal near the sphere's.
        ASSERT_TRUE(skin.is_on_skin);
        const OpenMesh::Vec3d& place = mesh.point(corner);
        const Vec3 point(place[0], place[1], place[2]);
        const Vec3 shift = skin.on_bone_mm - point;
        EXPECT_LT(glm::dot(shift, shift), 1e-18);
        EXPECT_GT(glm::dot(skin.normal, point) / std::sqrt(glm::dot(point, point)), 0.98);
      } else if (!skin.is_on_skin) {
        ++bare;
      }
    }
  }
  EXPECT_GT(bare, 20U);
}

TEST(WorkingSolid, WithoutRoomItSaysSoAndACompactedCopyTakesTheCut) {
  const CutSolid solid = uncut_solid(world(0));
  WorkingSolid working(solid, {.points = 10, .triangles = 10});
  IndexedSolid base = working.indexed();
  const SolidPatch patch = patch_of(solid, plane_of_cut(0, Vec3(0.0)), 0, 40.0);
  working.show(patch, base);
  EXPECT_EQ(working.commit(patch, base), CommitOutcome::NoRoom);
  expect_same(working.indexed().solid, solid);
  EXPECT_TRUE(working.is_hidden(OpenMesh::FaceHandle(static_cast<int>(patch.hidden.front()))));
  EXPECT_EQ(working.commits(), 0U);

  WorkingSolid roomy = working.compacted();
  base = roomy.indexed();
  ASSERT_EQ(roomy.commit(patch, base), CommitOutcome::Done);
  expect_same(roomy.indexed().solid, commit_patch(solid, patch));
}

/// All of a plane's slab.
SolidPatch slab_patch(const CutSolid& solid, const KerfPlane& plane, std::int32_t kerf) {
  const KerfContact contact =
      slice_contact(solid, Bvh(solid.mesh), plane, kerf, Vec2(-60.0), Vec2(60.0));
  RegionOutline all;
  all.corners_mm = {Vec2(-50.0, -50.0), Vec2(50.0, -50.0), Vec2(50.0, 50.0), Vec2(-50.0, 50.0)};
  all.loop_ends = {4};
  PatchBuilder builder(contact);
  SolidPatch patch;
  EXPECT_TRUE(builder.build(all, patch));
  return patch;
}

TEST(WorkingSolid, ItsPiecesAreThoseOfTheCommittedSolid) {
  const CutSolid solid = uncut_solid(hollow_tube({.segments = 24, .rings = 6}));
  WorkingSolid working(solid);
  const SolidPatch patch = slab_patch(solid, axis_plane(0, 2.0, 0.5), 0);
  ASSERT_EQ(working.commit(patch, working.indexed()), CommitOutcome::Done);
  const WorkingPieces pieces = working.pieces();
  const std::vector<CutSolid> expected = split_pieces(commit_patch(solid, patch));
  ASSERT_EQ(pieces.bodies.size(), 2U);
  ASSERT_EQ(expected.size(), 2U);
  EXPECT_EQ(pieces.debris_count, 0U);
  for (std::size_t i = 0; i < 2; ++i) {
    expect_same(pieces.bodies[i].indexed().solid, expected[i]);
    expect_sound(pieces.bodies[i].half_edges());
    EXPECT_TRUE(pieces.bodies[i].skin(OpenMesh::VertexHandle(0)).is_on_skin);
  }
}

TEST(WorkingSolid, SheetsBetweenKerfsAreDebrisAndNoBodies) {
  for (const double apart_mm : {0.5, 0.5002}) {
    WorkingSolid working(uncut_solid(solid_block(Vec3(25.0, 12.0, 10.0))));
    for (std::int32_t kerf = 0; kerf < 2; ++kerf) {
      const IndexedSolid base = working.indexed();
      const KerfPlane plane = axis_plane(0, kerf * apart_mm, 0.5);
      ASSERT_EQ(working.commit(slab_patch(base.solid, plane, kerf), base), CommitOutcome::Done);
    }
    const WorkingPieces pieces = working.pieces();
    EXPECT_EQ(pieces.bodies.size(), 2U);
    EXPECT_NEAR(pieces.debris_mm3, 120.0 * (apart_mm - 0.5), 1e-9);
  }
}

TEST(WorkingSolid, ACommitTakesNoMemoryOnceItHasSeenAsLargeAPatch) {
  WorkingSolid working(uncut_solid(sphere(9.0, 12)));
  for (std::int32_t cut = 0; cut < 2; ++cut) {
    const IndexedSolid base = working.indexed();
    // The second cut lies further out, where the sphere is smaller.
    const KerfPlane plane = axis_plane(0, cut == 0 ? 0.5 : 6.5, 0.5);
    const SolidPatch patch = patch_of(base.solid, plane, cut, 1.0);
    const std::uint64_t before = allocations_of_this_thread();
    ASSERT_EQ(working.commit(patch, base), CommitOutcome::Done);
    const std::uint64_t taken = allocations_of_this_thread() - before;
    if (cut == 0) continue;
#ifdef NDEBUG
    EXPECT_EQ(taken, 0U);
#else
    // OpenMesh's assertions compare the names of types as strings at each access of a property.
    EXPECT_LE(taken, 12 * patch.triangles.size());
#endif
  }
}

}  // namespace
}  // namespace hallux::tests
