#include "simulator/bone/growing_kerf.h"

namespace hallux::simulator {

GrowingKerf::GrowingKerf(const SolidWithTree& stands, const KerfPlane& plane, std::int32_t number,
                         const FieldGrid& grid)
    : contact_(slice_slab(stands.solid, stands.bvh, plane, number, grid)),
      builder_(contact_),
      tracker_(grid) {}

bool GrowingKerf::build(const KerfField& field, SolidPatch& patch) {
  tracker_.update(field);
  return builder_.build(tracker_.outline(), patch);
}

}  // namespace hallux::simulator
