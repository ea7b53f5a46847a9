#include "assessment/rebuild/rebuild.h"

#include <algorithm>
#include <span>
#include <utility>

#include "assessment/rebuild/open_kerfs.h"
#include "simulator/base/check.h"
#include "simulator/bone/cut_bone.h"
#include "simulator/cutting/solid/opened_volume.h"
#include "simulator/cutting/solid/slab_volume.h"

namespace hallux::assessment {

namespace {

using simulator::CutBone;
using simulator::CutSolid;
using simulator::KerfField;
using simulator::Recording;
using simulator::ToolSample;
using simulator::ToolStatus;

/// Stamping takes about this share of the time; the rest is cutting solids.
constexpr double stamping_share = 0.5;
constexpr std::size_t samples_per_report = 4096;
/// What is not removed is not done, however little is missing.
constexpr double almost_done = 0.999;
/// The share of a region's volume that is rounding: positions are kept to about 1e-9 of a bone.
constexpr double nothing_left = 1.0e-6;

void note_cutting(RebuiltBone& rebuilt, const ToolSample& sample) {
  const bool is_of_kerf = sample.kerf >= 0 && sample.kerf < rebuilt.fields.count();
  if (!is_of_kerf || !has(sample.status, ToolStatus::Cutting)) return;
  RebuiltKerf& kerf = rebuilt.kerfs[static_cast<std::size_t>(sample.kerf)];
  if (kerf.cutting_samples++ == 0) kerf.first_cutting_tick = sample.tick;
  kerf.last_cutting_tick = sample.tick;
}

RebuiltKerf frozen_at(std::int64_t tick) {
  RebuiltKerf kerf;
  kerf.frozen_tick = kerf.first_cutting_tick = kerf.last_cutting_tick = tick;
  return kerf;
}

void stamp_kerfs(RebuiltBone& rebuilt, const Recording& recording, const SampleFollower& follow,
                 const Progress& progress) {
  const auto count = static_cast<double>(recording.samples.size());
  open_kerfs(
      rebuilt.fields, recording,
      [&](std::int64_t tick) { rebuilt.kerfs.push_back(frozen_at(tick)); },
      [&](std::size_t index, std::span<const simulator::RisenKerf>) {
        note_cutting(rebuilt, recording.samples[index]);
        if (follow) follow(recording.samples[index], rebuilt.fields);
        if (index % samples_per_report == 0)
          report(progress, stamping_share * static_cast<double>(index) / count);
      });
}

void put_kerfs(RebuiltBone& rebuilt, const Recording& recording, const OpenedFields& opened) {
  freeze_kerfs(
      rebuilt.fields, recording,
      [&](std::int64_t tick) { rebuilt.kerfs.push_back(frozen_at(tick)); },
      [&](std::size_t index) { note_cutting(rebuilt, recording.samples[index]); });
  for (std::size_t kerf = 0; kerf < opened.size(); ++kerf) {
    rebuilt.fields.put(static_cast<std::int32_t>(kerf), opened[kerf].window,
                       opened[kerf].inside_mm);
  }
}

/// How much of each region the outline takes. What rounding leaves of a region that was taken
/// wholly is nothing.
void measure_regions(RebuiltKerf& kerf, const CutSolid& solid) {
  const std::size_t count = kerf.section.regions.size();
  for (std::size_t region = 0; region < count; ++region) {
    std::vector<std::uint8_t> only(count, 0);
    only[region] = 1;
    const double whole_mm3 = slab_volume_mm3(solid, kerf.section, only);
    const double opened_mm3 = opened_volume_mm3(solid, kerf.section.regions[region].triangles,
                                                kerf.section.plane, kerf.outline);
    const double fraction = whole_mm3 > 0.0 ? opened_mm3 / whole_mm3 : 0.0;
    const bool is_whole = fraction > 1.0 - nothing_left;
    kerf.opened_fraction.push_back(is_whole ? 1.0 : std::max(fraction, 0.0));
    kerf.is_touched.push_back(fraction > nothing_left ? 1 : 0);
    kerf.is_removed.push_back(is_whole ? 1 : 0);
  }
}

/// The kerf in the bone that the kerfs before it leave.
void cut_kerf(RebuiltBone& rebuilt, CutBone& bone, std::int32_t index) {
  RebuiltKerf& kerf = rebuilt.kerfs[static_cast<std::size_t>(index)];
  const KerfField& field = rebuilt.fields.field(index);
  const simulator::KerfPlane& plane = rebuilt.fields.plane(index);
  const simulator::SolidWithTree before = bone.before(index);
  kerf.section = slice_section(before.solid, before.bvh, plane);
  kerf.outline = outline_of(field);
  measure_regions(kerf, before.solid);
  bone.put_kerf(index, {index, plane, field.grid(), kerf.outline});
  kerf.removed_mm3 = bone.cut(index).removed_mm3;
  rebuilt.removed_mm3 += kerf.removed_mm3;
}

void keep_pieces(RebuiltBone& rebuilt, const CutSolid& solid) {
  simulator::SortedBodies sorted = sort_bodies(split_pieces(solid));
  rebuilt.pieces = std::move(sorted.bodies);
  rebuilt.piece_volumes_mm3 = std::move(sorted.volumes_mm3);
  rebuilt.debris_mm3 = sorted.debris_mm3;
  rebuilt.debris_count = static_cast<std::int32_t>(sorted.crumbs.size());
}

}  // namespace

double RebuiltKerf::done_fraction() const noexcept {
  for (std::size_t region = 0; region < is_touched.size(); ++region) {
    if (is_removed[region] != 0) return 1.0;
    if (is_touched[region] != 0) return std::min(opened_fraction[region], almost_done);
  }
  return 0.0;
}

bool RebuiltKerf::is_finished() const noexcept { return done_fraction() == 1.0; }

RebuiltBone rebuild(const simulator::Bone& bone, const simulator::Blade& blade,
                    const simulator::Recording& recording, const Progress& progress,
                    const OpenedFields* opened, const SampleFollower& follow) {
  RebuiltBone rebuilt{
      simulator::KerfSet(blade, bone.world_from_bone), {}, {}, {}, 0.0, 0.0, 0.0, 0};
  if (opened != nullptr) {
    CHECK(!follow);
    CHECK(are_of(*opened, blade, bone.world_from_bone, recording));
    put_kerfs(rebuilt, recording, *opened);
  } else {
    stamp_kerfs(rebuilt, recording, follow, progress);
  }
  CutBone cut(solid_of(bone));
  rebuilt.input_mm3 = signed_volume_mm3(cut.whole().mesh);
  const std::int32_t count = rebuilt.fields.count();
  for (std::int32_t index = 0; index < count; ++index) {
    report(progress, stamping_share + (1.0 - stamping_share) * index / count);
    cut_kerf(rebuilt, cut, index);
  }
  keep_pieces(rebuilt, cut.after_all());
  report(progress, 1.0);
  return rebuilt;
}

}  // namespace hallux::assessment
