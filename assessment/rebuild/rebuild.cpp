#include "assessment/rebuild/rebuild.h"

#include <algorithm>
#include <utility>

namespace hallux::assessment {

namespace {

using simulator::Bvh;
using simulator::CutEvent;
using simulator::CutEventKind;
using simulator::CutSolid;
using simulator::KerfField;
using simulator::Recording;
using simulator::SectionMask;
using simulator::ToolSample;
using simulator::ToolStatus;

/// Stamping takes about this share of the time; the rest is cutting solids.
constexpr double stamping_share = 0.5;
constexpr std::size_t samples_per_report = 4096;
/// What is not removed is not done, however little is missing.
constexpr double almost_done = 0.999;

void freeze_until(RebuiltBone& rebuilt, const Recording& recording, std::size_t& next_event,
                  std::int64_t tick) {
  for (; next_event < recording.events.size() && recording.events[next_event].tick <= tick;
       ++next_event) {
    const CutEvent& event = recording.events[next_event];
    if (event.kind != CutEventKind::PlaneFrozen || rebuilt.fields.freeze(event.pose) < 0) continue;
    RebuiltKerf kerf;
    kerf.frozen_tick = kerf.first_cutting_tick = kerf.last_cutting_tick = event.tick;
    rebuilt.kerfs.push_back(std::move(kerf));
  }
}

void note_cutting(RebuiltBone& rebuilt, const ToolSample& sample) {
  const bool is_of_kerf = sample.kerf >= 0 && sample.kerf < rebuilt.fields.count();
  if (!is_of_kerf || !has(sample.status, ToolStatus::Cutting)) return;
  RebuiltKerf& kerf = rebuilt.kerfs[static_cast<std::size_t>(sample.kerf)];
  if (kerf.cutting_samples++ == 0) kerf.first_cutting_tick = sample.tick;
  kerf.last_cutting_tick = sample.tick;
}

void open_kerfs(RebuiltBone& rebuilt, const Recording& recording, const Progress& progress) {
  std::size_t next_event = 0;
  for (std::size_t index = 0; index < recording.samples.size(); ++index) {
    const ToolSample& sample = recording.samples[index];
    freeze_until(rebuilt, recording, next_event, sample.tick);
    rebuilt.fields.follow(sample);
    note_cutting(rebuilt, sample);
    if (index % samples_per_report != 0) continue;
    const double done = static_cast<double>(index) / static_cast<double>(recording.samples.size());
    report(progress, stamping_share * done);
  }
}

std::vector<double> covered_fractions(const SectionMask& mask, const KerfField& field) {
  std::vector<std::int64_t> open(mask.node_count.size(), 0);
  const std::int32_t u_count = mask.grid.u_count;
  for (std::size_t node = 0; node < mask.region_of_node.size(); ++node) {
    const std::int16_t region = mask.region_of_node[node];
    if (region < 0) continue;
    const std::int32_t u = static_cast<std::int32_t>(node) % u_count;
    const std::int32_t v = static_cast<std::int32_t>(node) / u_count;
    if (field.at(u, v) > 0.0F) ++open[static_cast<std::size_t>(region)];
  }
  std::vector<double> fractions;
  for (std::size_t region = 0; region < open.size(); ++region) {
    const double nodes = static_cast<double>(mask.node_count[region]);
    fractions.push_back(nodes > 0.0 ? static_cast<double>(open[region]) / nodes : 0.0);
  }
  return fractions;
}

bool any_of(const std::vector<std::uint8_t>& flags) noexcept {
  for (const std::uint8_t flag : flags) {
    if (flag != 0) return true;
  }
  return false;
}

/// Takes one kerf out of the solid; whether the solid changed.
bool cut_kerf(CutSolid& solid, const Bvh& bvh, RebuiltBone& rebuilt, std::int32_t index) {
  RebuiltKerf& kerf = rebuilt.kerfs[static_cast<std::size_t>(index)];
  const KerfField& field = rebuilt.fields.field(index);
  kerf.section = slice_section(solid, bvh, rebuilt.fields.plane(index));
  const SectionMask mask = mask_section(kerf.section, solid, bvh, field.grid());
  kerf.is_touched = touched_regions(mask, field);
  kerf.is_removed = covered_regions(mask, field);
  kerf.covered_fraction = covered_fractions(mask, field);
  if (!any_of(kerf.is_removed)) return false;
  kerf.removed_mm3 = slab_volume_mm3(solid, kerf.section, kerf.is_removed);
  rebuilt.removed_mm3 += kerf.removed_mm3;
  solid = remove_slab(solid, bvh, kerf.section, index, kerf.is_removed);
  return true;
}

void keep_pieces(RebuiltBone& rebuilt, const CutSolid& solid) {
  for (CutSolid& piece : split_pieces(solid)) {
    const double volume_mm3 = signed_volume_mm3(piece.mesh);
    if (volume_mm3 < simulator::debris_limit_mm3) {
      rebuilt.debris_mm3 += volume_mm3;
      ++rebuilt.debris_count;
      continue;
    }
    rebuilt.piece_volumes_mm3.push_back(volume_mm3);
    rebuilt.pieces.push_back(std::move(piece));
  }
}

void cut_kerfs(CutSolid& solid, RebuiltBone& rebuilt, const Progress& progress) {
  Bvh bvh(solid.mesh);
  const std::int32_t count = rebuilt.fields.count();
  for (std::int32_t index = 0; index < count; ++index) {
    report(progress, stamping_share + (1.0 - stamping_share) * index / count);
    const bool is_last = index + 1 == count;
    if (cut_kerf(solid, bvh, rebuilt, index) && !is_last) bvh = Bvh(solid.mesh);
  }
}

}  // namespace

double RebuiltKerf::done_fraction() const noexcept {
  for (std::size_t region = 0; region < is_touched.size(); ++region) {
    if (is_removed[region] != 0) return 1.0;
    if (is_touched[region] != 0) return std::min(covered_fraction[region], almost_done);
  }
  return 0.0;
}

bool RebuiltKerf::is_finished() const noexcept { return done_fraction() == 1.0; }

RebuiltBone rebuild(const simulator::Bone& bone, const simulator::BladeSize& blade,
                    const simulator::Recording& recording, const Progress& progress) {
  RebuiltBone rebuilt{
      simulator::KerfSet(blade, bone.world_from_bone), {}, {}, {}, 0.0, 0.0, 0.0, 0};
  open_kerfs(rebuilt, recording, progress);
  CutSolid solid = simulator::uncut_solid(solid_of(bone));
  rebuilt.input_mm3 = signed_volume_mm3(solid.mesh);
  if (rebuilt.fields.count() > 0) cut_kerfs(solid, rebuilt, progress);
  keep_pieces(rebuilt, solid);
  report(progress, 1.0);
  return rebuilt;
}

}  // namespace hallux::assessment
