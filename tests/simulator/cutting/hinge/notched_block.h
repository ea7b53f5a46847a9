/// A block with a wedge sawn into it, made directly as a mesh: what two kerfs that stop at a hinge
/// leave.
#pragma once

#include "simulator/cutting/hinge/hinge_gap.h"
#include "simulator/cutting/pieces/cut_solid.h"

namespace hallux::tests {

/// The block fills x -10 to 10, y -6 to 6 and z -7 (medial) to 7. Kerf 0 is the slab |x| <= 0.25
/// from medial to `tip_z_mm`; from `kink_z_mm` to medial the upper wall rises by `rise` per
/// millimetre: the wall of kerf 1.
struct Notch {
  double tip_z_mm = 6.0;
  double kink_z_mm = 3.2;
  /// Tan 10 degrees.
  double rise = 0.17632698070846498;
  /// Of the upper wall per millimetre along y.
  double dorsal_rise = 0.0;
};

simulator::CutSolid notched_block(const Notch& notch);

/// The plane of kerf 0: feed lateral (x = +z of the block), tooth line along y, blade normal -x or,
/// flipped, +x.
simulator::KerfPlane notch_plane(bool looks_distal = true);
/// The plane in which kerf 1 ran: its upper wall lies half a kerf above it.
simulator::KerfPlane upper_plane(const Notch& notch);
/// The lateral bridge: its line along y at z = 6, 1 mm inside the cortex.
simulator::HingeLine notch_hinge();

}  // namespace hallux::tests
