/// The table a bone is made from: sections along its length, two end caps, features, cartilage, and its place.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/scenario_error.h"
#include "simulator/base/vector.h"

namespace hallux::scenarios {

/// A section perpendicular to x at `position` x length: a twisted superellipse with a third harmonic.
struct Station {
  double position = 0.0;  ///< 0 at the base, 1 at the head
  double centre_y_mm = 0.0;
  double centre_z_mm = 0.0;
  double half_width_mm = 0.0;   ///< along z
  double half_height_mm = 0.0;  ///< along y
  double exponent = 2.0;        ///< 2 is an ellipse, higher is boxier
  double twist_rad = 0.0;       ///< from z towards y
  double cos3 = 0.0;            ///< third harmonic, relative to the radius
  double sin3 = 0.0;            ///< above 0: apex plantar, flat dorsal
  double dorsal_widening = 0.0;
};

/// A quadric across the end of the loft, joined to its side by a rounded rim.
struct EndCap {
  double x_mm = 0.0;
  double rim_radius_mm = 1.0;
  double rim_exponent = 2.0;  ///< 2 is round, higher is sharper
  double y_mm = 0.0;
  double z_mm = 0.0;
  double tilt_y = 0.0;
  double tilt_z = 0.0;
  double curve_yy_per_mm = 0.0;
  double curve_zz_per_mm = 0.0;
  double curve_yz_per_mm = 0.0;
};

enum class FeatureKind { Bump, Groove };

struct Feature {
  std::string name;
  FeatureKind kind = FeatureKind::Bump;
  Vec3 centre_mm{0.0, 0.0, 0.0};  ///< of a bump; first end of a groove
  Vec3 extent_mm{1.0, 1.0, 1.0};  ///< a bump's standard deviations
  double height_mm = 0.0;         ///< a bump's; below 0 is a hollow
  Vec3 end_mm{0.0, 0.0, 0.0};     ///< second end of a groove
  double radius_mm = 1.0;         ///< of a groove
  double blend_mm = 1.0;          ///< of a groove's rim
};

/// Where the head is covered with cartilage: a patch of a sphere, by the angles it reaches from the x axis.
struct HeadCartilage {
  Vec3 centre_mm{0.0, 0.0, 0.0};
  double radius_mm = 1.0;
  double medial_rad = 0.0;
  double lateral_rad = 0.0;
  double dorsal_rad = 0.0;
  double plantar_rad = 0.0;
};

/// How a medial eminence grows; its apex lies at centre z - radius z - eminence_mm.
struct EminenceShape {
  Vec3 centre_mm{0.0, 0.0, 0.0};  ///< at eminence 0
  Vec3 radii_mm{1.0, 1.0, 1.0};
  double blend_mm = 1.0;
  std::vector<Vec3> sulcus_mm;  ///< line of the groove beside it; moved along x and y onto the head
  double sulcus_radius_mm = 1.0;
  double sulcus_depth_mm = 0.5;
  double sulcus_blend_mm = 1.0;
};

/// How thick the cortex is in the middle of the shaft, and at least everywhere.
struct CortexShape {
  double mid_mm = 2.2;
  double floor_mm = 0.7;
};

struct BonePlace {
  Vec3 base_in_world_mm{0.0, 0.0, 0.0};
  Vec3 head_in_world_mm{1.0, 0.0, 0.0};
};

struct BoneTable {
  std::string bone;   ///< "first_metatarsal"
  std::string shape;  ///< "MT1A"
  std::string credit;
  double length_mm = 0.0;
  double relief_mm = 0.0;  ///< amplitude of the surface's roughness
  std::vector<Station> stations;
  EndCap base;
  EndCap head;
  std::vector<Feature> features;  ///< in the order in which they act
  HeadCartilage cartilage;
  std::optional<EminenceShape> eminence;  ///< absent where none grows on this bone
  CortexShape cortex;
  BonePlace place;
};

/// Reads a table; `name` stands in the messages.
/// errors  ScenarioError naming the line and the mend
/// source  docs/foot.md, section "The table"
BoneTable parse_bone_table(std::string_view text, std::string_view name);

/// A table compiled into the program, by its file name: "first_metatarsal.txt".
/// errors  ScenarioError where none of that name is shipped
BoneTable shipped_bone_table(std::string_view name);

}  // namespace hallux::scenarios
