/// A bone as it is operated on: outer surface, marrow canal, cortex law, landmarks and its place in
/// the foot.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "simulator/base/transform.h"
#include "simulator/mesh/indexed_mesh.h"

namespace hallux::simulator {

/// Thickness of the cortex as a law of the axial position t = x / length: 0 at the base facet, 1 at
/// the head.
/// source  reference: c(t) = mid (0.35 + 0.65 exp(-((t - 0.5) / 0.22)^2)), never below the floor
struct CortexLaw {
  double mid_mm = 2.2;
  double floor_mm = 0.7;
  double length_mm = 63.2;

  friend bool operator==(const CortexLaw&, const CortexLaw&) = default;
};

double cortex_thickness_mm(const CortexLaw& law, double x_in_bone_mm) noexcept;

struct Landmark {
  std::string name;
  Vec3 point_in_bone_mm{0.0, 0.0, 0.0};

  friend bool operator==(const Landmark&, const Landmark&) = default;
};

/// Bone frame: origin at the base facet's centre, x to the head's centre, y dorsal, z lateral;
/// right foot [mm].
struct Bone {
  /// "first_metatarsal".
  std::string name;
  /// What made it, with version and parameters; or the file it was read from.
  std::string generator;
  /// Source and licence of its shape; empty where there is none to give.
  std::string credit;
  /// Closed, outward.
  IndexedMesh outer;
  /// The marrow as a void: closed, inward-facing; may be empty.
  IndexedMesh canal;
  /// Absent: all bone is cortical.
  std::optional<CortexLaw> cortex;
  std::vector<Landmark> landmarks;
  RigidTransform world_from_bone;

  friend bool operator==(const Bone&, const Bone&) = default;
};

/// Outer surface and canal as one closed mesh.
IndexedMesh solid_of(const Bone& bone);
/// The named landmark [mm, bone frame]; nothing where the bone has none of that name.
std::optional<Vec3> find_landmark(const Bone& bone, std::string_view name);

/// The bone as bytes, the same bytes for the same bone on every machine; its name in the store is
/// their digest.
std::vector<std::byte> encode_bone(const Bone& bone);
/// errors  MeshError where the bytes are not a bone: cut short, counts beyond the bytes, indices
///         out of range, NaN
Bone decode_bone(std::span<const std::byte> bytes);

}  // namespace hallux::simulator
