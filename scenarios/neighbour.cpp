#include "scenarios/neighbour.h"

#include "scenarios/foot/first_metatarsal.h"
#include "scenarios/foot/first_proximal_phalanx.h"

namespace hallux::scenarios {

simulator::Bone neighbour_of(const Scenario& scenario, double edge_mm) {
  const BoneRequest request{.edge_mm = edge_mm};
  return scenario.patient.bone == "first_metatarsal"
             ? make_first_proximal_phalanx(first_proximal_phalanx_table(), request)
             : make_first_metatarsal(first_metatarsal_table(), request);
}

}  // namespace hallux::scenarios
