/// The plane of a cut on one patient, of each kind that a scenario may say.
/// Inside this corner only.
#pragma once

#include <optional>

#include "scenarios/faces/reference_face.h"
#include "scenarios/geometry/ground.h"
#include "simulator/cutting/hinge/hinge.h"

namespace hallux::scenarios {

/// One cut on its way to a plan: what the scenario asks, whereon, and the words that a refusal
/// begins with.
struct AskedCut {
  const ReferenceCut& cut;
  const Ground& ground;
  std::size_t bone = 0;
  std::string path;
};

/// Where a cut goes, before its place in the bone is looked for.
struct LaidFace {
  ReferenceFace face;
  /// Unit direction in the face, square to the blade's way: distal, or dorsal across the bone.
  Vec3 axis{1.0, 0.0, 0.0};
};

/// AlongAxis and Transverse.
/// errors  ScenarioError naming the landmark that this bone lacks, or the axis that has no
///         direction
LaidFace lay_along_axis(const AskedCut& asked);
LaidFace lay_transverse(const AskedCut& asked);
/// ThroughHinge: about the line, by the angle from the face in which the line lies.
LaidFace lay_through_hinge(const AskedCut& asked, const simulator::HingeLine& line,
                           double wedge_rad);
/// Turned. With unit vectors c along `contains`, f the part of `from` square to it, and angles a
/// and r, g = cos a f + sin a (c x f) lies in the face, and its normal is
/// cos r (c x g) + sin r c, or the opposite, which points away from the kept side.
/// from_face  of the cut that it is turned from; null where that is a direction
/// errors     ScenarioError: names, a `from` along `contains`, a side that lies in the face
LaidFace lay_turned(const AskedCut& asked, const ReferenceFace* from_face);

/// The part of the face that is to be cut; nothing where the cut says no window.
/// errors  ScenarioError: names, a direction square to the face
std::optional<FaceWindow> lay_window(const AskedCut& asked, const ReferenceFace& face);

/// A direction laid into a face.
/// errors  ScenarioError with these words where it is square to the face
Vec3 laid_in(const ReferenceFace& face, const Vec3& direction, const std::string& path,
             std::string_view what, std::string_view mend);

}  // namespace hallux::scenarios
