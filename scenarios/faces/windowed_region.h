/// The part of a section that lies within a planned window.
#pragma once

#include "scenarios/faces/reference_face.h"
#include "simulator/cutting/slice/section.h"

namespace hallux::scenarios {

/// Contours, extent and area of what is left of the region; the plane may be tilted against the
/// window's face. Without contours where nothing lies within.
simulator::SectionRegion within_window(const simulator::SectionRegion& region,
                                       const simulator::KerfPlane& plane, const FaceWindow& window);

/// Of each region of a section what lies within; the others go.
void keep_within(simulator::Section& section, const simulator::KerfPlane& plane,
                 const FaceWindow& window);

}  // namespace hallux::scenarios
