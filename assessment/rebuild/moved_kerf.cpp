#include "assessment/rebuild/moved_kerf.h"

#include <algorithm>

namespace hallux::assessment {

namespace {

using simulator::FieldGrid;
using simulator::FieldWindow;
using simulator::KerfField;
using simulator::OpenedField;

/// The nodes that are not as they were at first.
FieldWindow window_of(const KerfField& field) {
  const FieldGrid& grid = field.grid();
  const float closed_mm = KerfField::closed_mm(grid);
  FieldWindow window{grid.u_count, grid.v_count, 0, 0};
  for (std::int32_t u = 0; u < grid.u_count; ++u) {
    for (std::int32_t v = 0; v < grid.v_count; ++v) {
      if (field.at(u, v) == closed_mm) continue;
      window.u_first = std::min(window.u_first, u);
      window.v_first = std::min(window.v_first, v);
      window.u_last = std::max(window.u_last, u + 1);
      window.v_last = std::max(window.v_last, v + 1);
    }
  }
  return window.is_empty() ? FieldWindow{} : window;
}

OpenedField kept_field(const simulator::KerfPlane& plane, const KerfField& field) {
  OpenedField kept;
  kept.plane = plane;
  kept.grid = field.grid();
  kept.window = window_of(field);
  for (std::int32_t u = kept.window.u_first; u < kept.window.u_last; ++u) {
    for (std::int32_t v = kept.window.v_first; v < kept.window.v_last; ++v)
      kept.inside_mm.push_back(field.at(u, v));
  }
  return kept;
}

}  // namespace

OpenedFields kept_fields(const simulator::KerfSet& kerfs) {
  OpenedFields fields;
  for (std::int32_t kerf = 0; kerf < kerfs.count(); ++kerf)
    fields.push_back(kept_field(kerfs.plane(kerf), kerfs.field(kerf)));
  return fields;
}

void move_kerf(simulator::Recording& recording, OpenedFields& fields,
               const RigidTransform& world_from_bone, const KerfMove& move) {
  std::int32_t frozen = 0;
  for (simulator::CutEvent& event : recording.events) {
    if (event.kind != simulator::CutEventKind::PlaneFrozen) continue;
    if (frozen++ != move.kerf) continue;
    const RigidTransform moved = move.bone_from_moved * transform_from(event.pose);
    event.pose = simulator::quantise(moved);
    fields[static_cast<std::size_t>(move.kerf)].plane.bone_from_kerf = transform_from(event.pose);
  }
  const RigidTransform world_from_moved =
      world_from_bone * move.bone_from_moved * inverse(world_from_bone);
  for (simulator::ToolSample& sample : recording.samples) {
    if (sample.kerf != move.kerf) continue;
    sample.world_from_tool =
        simulator::quantise(world_from_moved * transform_from(sample.world_from_tool));
  }
}

}  // namespace hallux::assessment
