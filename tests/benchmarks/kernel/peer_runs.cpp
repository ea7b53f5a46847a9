#include "tests/benchmarks/kernel/peer_runs.h"

#include <stdexcept>
#include <utility>

#include "simulator/cutting/solid/commit_patch.h"
#include "tests/benchmarks/kernel/our_cut.h"
#include "tests/benchmarks/peers/cgal_solid.h"
#include "tests/benchmarks/peers/thesis_mesh.h"
#include "tests/benchmarks/peers/vtk_solid.h"

namespace hallux::benchmarks {

using namespace simulator;

namespace {

Repetitions repetitions_for(const BoneWorld& world) {
  if (world.wanted >= 1'000'000) return {.least = 2, .most = 2, .limit_s = 4.0};
  if (world.wanted >= 100'000) return {.least = 3, .most = 7, .limit_s = 4.0};
  return {.least = 5, .most = 25, .limit_s = 2.0};
}

/// Ours are short: more of them fit.
Repetitions more(const Repetitions& repetitions) {
  return {.least = 5, .most = 10 * repetitions.most, .limit_s = 0.5 * repetitions.limit_s};
}

/// Times work on what `make` gives; the last result stays in `result`, and results are freed
/// outside the clock.
template <typename Result, typename Make, typename Work>
Percentiles time_kept(const Repetitions& repetitions, std::optional<Result>& result, Make make,
                      Work work) {
  return time_ms(
      repetitions,
      [&] {
        result.reset();
        return make();
      },
      [&](auto& made) { result.emplace(work(made)); });
}

constexpr auto nothing = [] { return 0; };

/// The corner of the mesh nearest to the saw: where the thesis's walk begins.
std::uint32_t touched_triangle(const BoneWorld& world, const Bvh& bvh) {
  const Vec3 feed = transform_direction(world.plane.bone_from_kerf, Vec3(1.0, 0.0, 0.0));
  const std::optional<RayHit> hit =
      bvh.first_hit(world.plane.bone_from_kerf.translation_mm - 100.0 * feed, feed);
  if (!hit) throw std::runtime_error("the kerf's plane misses the bone");
  return hit->triangle;
}

bool is_closed(const IndexedMesh& mesh) { return CgalInexactSolid(mesh).is_closed(); }

}  // namespace

std::string BoneWorld::name() const {
  const std::string count = wanted >= 1'000'000 ? std::to_string(wanted / 1'000'000) + "M"
                                                : std::to_string(wanted / 1'000) + "k";
  return count + (is_hollow ? " hollow" : " solid");
}

void run_vtk(const BoneWorld& world, Outcomes& outcomes) {
  const VtkSolid bone(world.mesh);
  const auto [below, above] = sides_of_slab(world.plane);
  std::optional<std::pair<VtkSolid, VtkSolid>> halves;
  Outcome& outcome = outcomes[Method::VtkHalves];
  outcome.time_ms = time_kept(repetitions_for(world), halves, nothing, [&](int) {
    return std::pair(bone.clipped(below), bone.clipped(above));
  });
  outcome.removed_mm3 =
      bone.volume_mm3() - (halves->first.volume_mm3() + halves->second.volume_mm3());
}

void run_cgal(const BoneWorld& world, Outcomes& outcomes) {
  const CgalInexactSolid bone(world.mesh), slab(slab_box(world.plane));
  const Repetitions repetitions = repetitions_for(world);
  const auto [below, above] = sides_of_slab(world.plane);
  const HalfSpace middle = sides_of(world.plane, 0.0)[0];
  using Pair = std::pair<CgalInexactSolid, CgalInexactSolid>;
  std::optional<Pair> pair;
  std::optional<CgalInexactSolid> mesh;

  outcomes[Method::CgalSplit].time_ms = time_kept(
      repetitions, mesh, [&] { return CgalInexactSolid(bone); },
      [&](CgalInexactSolid& copy) {
        copy.split(middle);
        return std::move(copy);
      });
  Outcome& halves = outcomes[Method::CgalHalves];
  halves.time_ms = time_kept(
      repetitions, pair, [&] { return Pair(bone, bone); },
      [&](Pair& copies) {
        copies.first.clip(below);
        copies.second.clip(above);
        return std::move(copies);
      });
  halves.removed_mm3 = bone.volume_mm3() - (pair->first.volume_mm3() + pair->second.volume_mm3());
  halves.is_closed = pair->first.is_closed() && pair->second.is_closed();

  Outcome& difference = outcomes[Method::CgalDifference];
  difference.time_ms = time_kept(
      repetitions, pair, [&] { return Pair(bone, slab); },
      [&](Pair& copies) {
        copies.first.subtract(copies.second);
        return std::move(copies);
      });
  difference.removed_mm3 = bone.volume_mm3() - pair->first.volume_mm3();
  difference.is_closed = pair->first.is_closed();
}

void run_thesis(const BoneWorld& world, Outcomes& outcomes) {
  const std::uint32_t touched = touched_triangle(world, Bvh(world.mesh));
  std::optional<ThesisMesh> mesh;
  outcomes[Method::ThesisSlice].time_ms = time_kept(
      repetitions_for(world), mesh, [&] { return ThesisMesh(world.mesh); },
      [&](ThesisMesh& made) {
        made.begin_cut(world.plane, {&touched, 1});
        return std::move(made);
      });
}

void run_ours(const BoneWorld& world, Outcomes& outcomes) {
  const CutSolid bone = uncut_solid(world.mesh);
  const Bvh bvh(bone.mesh);
  const RegionOutline region = whole_plane();
  const auto slice = [&] {
    return slice_slab(bone, bvh, world.plane, 0, region.corners_mm[0], region.corners_mm[2]);
  };
  const Repetitions repetitions = more(repetitions_for(world));
  std::optional<SlabSlice> contact;
  outcomes[Method::OurContact].time_ms =
      time_kept(repetitions, contact, nothing, [&](int) { return slice(); });

  SolidPatch patch;
  Outcome& slab = outcomes[Method::OurSlab];
  slab.time_ms = time_kept(repetitions, contact, nothing, [&](int) {
    SlabSlice made = slice();
    PatchBuilder builder(made);
    if (!builder.build(region, patch)) throw std::runtime_error("the kernel refused a whole slab");
    return made;
  });
  std::optional<CutSolid> committed;
  Outcome& compacted = outcomes[Method::OurCompacted];
  compacted.time_ms = time_kept(repetitions_for(world), committed, nothing, [&](int) {
    const SlabSlice made = slice();
    PatchBuilder(made).build(region, patch);
    return commit_patch(bone, patch);
  });
  slab.is_closed = compacted.is_closed = is_closed(committed->mesh);
  slab.removed_mm3 = compacted.removed_mm3 =
      signed_volume_mm3(bone.mesh) - signed_volume_mm3(committed->mesh);
}

}  // namespace hallux::benchmarks
