/// The pictures of docs/metrics.md: what each metric measures, as drawings with its name; the same
/// bytes each time. They are not to scale.
#pragma once

#include <string>
#include <vector>

#include "tests/screenshots/kernel_pictures.h"

namespace hallux::tests {

/// Turns, ends and distances of a face, from dorsal and from medial.
std::string draw_faces();
/// A resection at its two landmarks.
std::string draw_resection();
/// What is left uneven, and how thick the piece is.
std::string draw_piece();
/// The wedge between two faces, and the bridge at its end.
std::string draw_wedge();
/// The wedge taken out and closed.
std::string draw_closing();
/// The arms of a V, their axis, and what stands out after a shift.
std::string draw_arms_of_a_v();
/// A fragment against its plan, and the screw that holds it.
std::string draw_fixation();
/// What must not be touched: zones, joints, hot bone.
std::string draw_harm();
/// Push and way of the teeth over a break-through.
std::string draw_break_through();
/// The attempt's times.
std::string draw_timeline();
/// Free movements of the handle, one's spectrum, and the blade's way.
std::string draw_movements();

/// All of them, in the order of the text.
std::vector<Picture> metric_pictures();

}  // namespace hallux::tests
