#include "tests/simulator/cutting/frames/kerf_play.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "tests/simulator/cutting/worlds/cut_through.h"

namespace hallux::tests {

using namespace simulator;

namespace {

constexpr double region_reach_mm = 60.0;

struct Play {
  CutSolid solid;
  std::function<KerfPlane(Random&)> draw_plane;
  std::function<std::unique_ptr<GrowingRegion>(Random&)> draw_region;
};

void play_kerf(Play& play, const KerfPlane& plane, std::int32_t kerf, Random& random,
               const FrameVisitor& visit) {
  const Bvh bvh(play.solid.mesh);
  const SlabSlice contact =
      slice_slab(play.solid, bvh, plane, kerf, Vec2(-region_reach_mm), Vec2(region_reach_mm));
  PatchBuilder builder(contact);
  SolidPatch patch;
  const std::unique_ptr<GrowingRegion> growing = play.draw_region(random);
  for (std::int32_t frame = 0; frame < frames_of_kerf; ++frame) {
    const RegionOutline region = growing->next();
    const bool is_built = builder.build(region, patch);
    visit({play.solid, contact, region, patch, builder, is_built, kerf, frame});
  }
  play.solid = commit_patch(play.solid, patch);
}

void play_kerfs(Play play, Random& random, const FrameVisitor& visit,
                const CommitVisitor& visit_commit) {
  KerfPlane plane = play.draw_plane(random);
  for (std::int32_t kerf = 0; kerf < kerfs_played; ++kerf) {
    play_kerf(play, plane, kerf, random, visit);
    if (visit_commit) visit_commit(play.solid, kerf);
    plane = plane_after(plane, random, play.draw_plane);
  }
}

std::function<std::unique_ptr<GrowingRegion>(Random&)> strokes_of(double reach_mm) {
  return [reach_mm](Random& random) {
    return std::make_unique<StrokedRegion>(random, reach_mm, frames_of_kerf);
  };
}

}  // namespace

KerfPlane plane_after(const KerfPlane& plane, Random& random,
                      const std::function<KerfPlane(Random&)>& draw_plane) {
  const KerfAxes axes = axes_of(plane);
  KerfPlane next = plane;
  const auto turned_by = [&](double angle_rad) {
    const Quat turn = rotation_about(Vec3(0.0, 1.0, 0.0), angle_rad);
    next.bone_from_kerf.rotation = next.bone_from_kerf.rotation * turn;
    return next;
  };
  switch (random.bits() % 6) {
    case 0:
      return plane;
    case 1:
      next.bone_from_kerf.translation_mm += plane.thickness_mm * axes.z;
      return next;
    case 2:
      return turned_by(random.uniform(-0.4, 0.4));
    case 3:
      return turned_by(std::acos(0.0));
    default:
      return draw_plane(random);
  }
}

void play_bone(Random& random, const FrameVisitor& visit, const CommitVisitor& visit_commit) {
  play_kerfs({uncut_solid(random_bone(random)), random_plane, strokes_of(12.0)}, random, visit,
             visit_commit);
}

void play_lattice(Random& random, const FrameVisitor& visit, const CommitVisitor& visit_commit) {
  const auto draw_region = [](Random& chance) -> std::unique_ptr<GrowingRegion> {
    if (chance.bits() % 4 == 0) {
      return std::make_unique<StrokedRegion>(chance, 4.0, frames_of_kerf);
    }
    return std::make_unique<LatticeRegion>(chance);
  };
  play_kerfs({uncut_solid(lattice_bone(random)), lattice_plane, draw_region}, random, visit,
             visit_commit);
}

void play_mesh(const IndexedMesh& mesh, Random& random, const FrameVisitor& visit,
               const CommitVisitor& visit_commit) {
  Vec3 min_mm = mesh.points_mm.front(), max_mm = min_mm;
  for (const Vec3& point_mm : mesh.points_mm) {
    min_mm = glm::min(min_mm, point_mm);
    max_mm = glm::max(max_mm, point_mm);
  }
  const Vec3 size_mm = max_mm - min_mm;
  const auto draw_plane = [&](Random& chance) {
    const Vec3 share(chance.uniform(0.2, 0.8), chance.uniform(0.3, 0.7), chance.uniform(0.3, 0.7));
    return plane_through(min_mm + share * size_mm, random_direction(chance),
                         chance.uniform(0.2, 1.2), random_direction(chance));
  };
  const double reach_mm = 0.8 * std::min({size_mm.x, size_mm.y, size_mm.z});
  play_kerfs({uncut_solid(mesh), draw_plane, strokes_of(reach_mm)}, random, visit, visit_commit);
}

}  // namespace hallux::tests
