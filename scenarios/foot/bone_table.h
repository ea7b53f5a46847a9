/// The table a bone is made from: sections along its length, two end caps, features, cartilage, and
/// its place. Inside this corner only.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/scenario_error.h"
#include "simulator/base/vector.h"

namespace hallux::scenarios {

/// A section perpendicular to x at `position` x length: a twisted superellipse with a third
/// harmonic.
struct Station {
  /// 0 at the base, 1 at the head.
  double position = 0.0;
  double centre_y_mm = 0.0;
  double centre_z_mm = 0.0;
  /// Along z.
  double half_width_mm = 0.0;
  /// Along y.
  double half_height_mm = 0.0;
  /// 2 is an ellipse, higher is boxier.
  double exponent = 2.0;
  /// From z towards y.
  double twist_rad = 0.0;
  /// Third harmonic, relative to the radius.
  double cos3 = 0.0;
  /// Above 0: apex plantar, flat dorsal.
  double sin3 = 0.0;
  double dorsal_widening = 0.0;
};

/// A quadric across the end of the loft, joined to its side by a rounded rim.
struct EndCap {
  double x_mm = 0.0;
  double rim_radius_mm = 1.0;
  /// 2 is round, higher is sharper.
  double rim_exponent = 2.0;
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
  /// Of a bump; first end of a groove.
  Vec3 centre_mm{0.0, 0.0, 0.0};
  /// A bump's standard deviations.
  Vec3 extent_mm{1.0, 1.0, 1.0};
  /// A bump's; below 0 is a hollow.
  double height_mm = 0.0;
  /// Second end of a groove.
  Vec3 end_mm{0.0, 0.0, 0.0};
  /// Of a groove.
  double radius_mm = 1.0;
  /// Of a groove's rim.
  double blend_mm = 1.0;
};

/// Where the head is covered with cartilage: a patch of a sphere, by the angles it reaches from the
/// x axis.
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
  /// At eminence 0.
  Vec3 centre_mm{0.0, 0.0, 0.0};
  Vec3 radii_mm{1.0, 1.0, 1.0};
  double blend_mm = 1.0;
  /// Line of the groove beside it; moved along x and y onto the head.
  std::vector<Vec3> sulcus_mm;
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
  /// "first_metatarsal".
  std::string bone;
  /// "MT1A".
  std::string shape;
  std::string credit;
  double length_mm = 0.0;
  /// Amplitude of the surface's roughness.
  double relief_mm = 0.0;
  std::vector<Station> stations;
  EndCap base;
  EndCap head;
  /// In the order in which they act.
  std::vector<Feature> features;
  HeadCartilage cartilage;
  /// Absent where none grows on this bone.
  std::optional<EminenceShape> eminence;
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
