#include "assessment/rebuild/opened_fields.h"

#include <span>

#include "assessment/rebuild/open_kerfs.h"
#include "simulator/cutting/field/kerf_set.h"
#include "simulator/jobs/lying_bones.h"

namespace hallux::assessment {

namespace {

constexpr std::size_t samples_per_report = 4096;

bool is_same(const simulator::FieldGrid& a, const simulator::FieldGrid& b) noexcept {
  return a.origin_mm == b.origin_mm && a.spacing_mm == b.spacing_mm && a.u_count == b.u_count &&
         a.v_count == b.v_count;
}

bool is_same(const simulator::KerfPlane& a, const simulator::KerfPlane& b) noexcept {
  return a.bone_from_kerf.rotation == b.bone_from_kerf.rotation &&
         a.bone_from_kerf.translation_mm == b.bone_from_kerf.translation_mm &&
         a.thickness_mm == b.thickness_mm;
}

}  // namespace

OpenedFields opened_fields(const simulator::Tray& tray, const simulator::Bones& bones,
                           const simulator::Recording& recording, const Progress& progress) {
  simulator::KerfSet kerfs(tray, poses_of(bones));
  std::vector<simulator::OpeningNotes> notes;
  const auto count = static_cast<double>(recording.samples.size());
  open_kerfs(
      kerfs, recording,
      [&](std::int64_t) { notes.emplace_back(kerfs.field(kerfs.count() - 1).grid()); },
      [&](std::size_t index, std::span<const simulator::RisenKerf> risen) {
        for (const simulator::RisenKerf& each : risen) {
          notes[static_cast<std::size_t>(each.kerf)].note(kerfs.field(each.kerf), each.window,
                                                          recording.samples[index].tick);
        }
        if (index % samples_per_report == 0) report(progress, static_cast<double>(index) / count);
      });
  OpenedFields fields;
  for (std::int32_t kerf = 0; kerf < kerfs.count(); ++kerf) {
    fields.push_back(
        notes[static_cast<std::size_t>(kerf)].finish(kerfs.plane(kerf), kerfs.field(kerf)));
  }
  return fields;
}

bool are_of(const OpenedFields& fields, const simulator::Tray& tray, const simulator::Bones& bones,
            const simulator::Recording& recording) {
  simulator::KerfSet kerfs(tray, poses_of(bones));
  freeze_kerfs(
      kerfs, recording, [](std::int64_t) {}, [](std::size_t) {});
  if (static_cast<std::size_t>(kerfs.count()) != fields.size()) return false;
  for (std::int32_t kerf = 0; kerf < kerfs.count(); ++kerf) {
    const simulator::OpenedField& field = fields[static_cast<std::size_t>(kerf)];
    if (!is_same(field.grid, kerfs.field(kerf).grid()) || !is_same(field.plane, kerfs.plane(kerf)))
      return false;
  }
  return true;
}

}  // namespace hallux::assessment
