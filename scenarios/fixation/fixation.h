/// Fragments, how they are shifted, and what holds them, as a scenario of format 2 says it. All
/// points and directions are names (scenarios/geometry/named_geometry.h).
/// Inside this corner only.
#pragma once

#include <string>
#include <vector>

namespace hallux::scenarios {

/// A piece that the planned faces part from its bone.
struct Fragment {
  std::string name, title;
  /// Empty: the patient's first.
  std::string bone;
  /// A point: the fragment is the piece that holds it.
  std::string holds;
  std::string origin;
};

/// A slide along a direction, or a turn about a direction through a point, by the right hand; both
/// as they lie in the bone before anything was shifted.
struct FragmentMove {
  bool is_turn = false;
  std::string direction;
  double slide_mm = 0.0;
  /// Of a turn.
  std::string through;
  double turn_rad = 0.0;
};

/// How a fragment is brought to where it is to heal: its moves, one after the other.
struct FragmentShift {
  std::string name, title, fragment;
  std::vector<FragmentMove> moves;
  /// Then closed until the faces touch.
  bool is_closed = false;
  std::string origin = {};
};

struct Range {
  double low_mm = 0.0, high_mm = 0.0;
  double middle_mm() const noexcept { return 0.5 * (low_mm + high_mm); }
};

enum class ImplantKind { Wire, Screw };

/// A joint surface that an implant keeps away from.
struct ImplantClearance {
  /// One of joint_surfaces.
  std::string joint_surface;
  double least_mm = 0.0;
};

/// A wire or a screw: from its entry along its direction, planned with the middle of its ranges.
struct Implant {
  ImplantKind kind = ImplantKind::Wire;
  std::string name, title;
  /// In whose frame it is planned; empty: the patient's first.
  std::string bone;
  std::string entry, direction;
  Range diameter;
  /// From the entry to the tip.
  Range length;
  /// Names of fragments, or of bones: then the rest of that bone.
  std::vector<std::string> engages;
  /// How many walls of cortex it is to hold in.
  int cortices = 1;
  std::vector<ImplantClearance> clear_of;
  /// It comes out again.
  bool is_temporary = false;
  std::string origin;
};

}  // namespace hallux::scenarios
