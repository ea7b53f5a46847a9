/// Finding named points on a finished bone. Inside this corner only.
#pragma once

#include "scenarios/foot/bone_field.h"
#include "simulator/mesh/bone.h"

namespace hallux::scenarios {

struct LandmarkSources {
  const BoneTable& table;
  const BoneField& field;
  const simulator::IndexedMesh& outer;
  double length_mm = 0.0;
};

/// The bone's point nearest to a place in the table.
Vec3 on_surface(const LandmarkSources& sources, const Vec3& point_in_table_mm);
/// The same of an end's middle.
Vec3 cap_centre(const LandmarkSources& sources, const EndCap& cap);
/// Centroid of the area in which the plane x = x_mm cuts the surface; exact for the mesh.
/// needs   the plane cuts the mesh
Vec3 slice_centroid(const simulator::IndexedMesh& mesh, double x_mm);
/// The corner with the greatest `along . p` of the slice across `axis` (0 is x, 1 y, 2 z) at
/// `at_mm`.
/// needs   the plane cuts the mesh
Vec3 slice_extreme(const simulator::IndexedMesh& mesh, glm::length_t axis, double at_mm,
                   const Vec3& along);
/// The mesh point with the greatest `along . p` among those with x in [low, high].
Vec3 extreme_point(const simulator::IndexedMesh& mesh, const Vec3& along, double low_mm,
                   double high_mm);

struct RestingPoints {
  Vec3 medial{0.0, 0.0, 0.0};
  Vec3 lateral{0.0, 0.0, 0.0};
};

/// Where, seen from dorsal, a straight edge rests that is laid across one end of the bone: facing
/// -1 the base, +1 the head. On a hollow end these are the two sides of its rim, and the edge is
/// the joint's line as a radiograph shows it.
/// needs   the mesh has points on both sides of middle_z_mm
RestingPoints straight_edge(const simulator::IndexedMesh& mesh, double facing, double middle_z_mm);

}  // namespace hallux::scenarios
