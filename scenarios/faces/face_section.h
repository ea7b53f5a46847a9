/// The section of a bone by a planned face. Inside this corner only.
#pragma once

#include <optional>

#include "scenarios/faces/reference_face.h"
#include "simulator/mesh/indexed_mesh.h"

namespace hallux::scenarios {

/// The point of the bone's section by the face that lies furthest in the direction; nothing where
/// the face misses.
std::optional<Vec3> furthest_in_face(const ReferenceFace& face, const simulator::IndexedMesh& mesh,
                                     const Vec3& direction);

/// The same of the part of the section within the window.
std::optional<Vec3> furthest_in_window(const ReferenceFace& face, const FaceWindow& window,
                                       const simulator::IndexedMesh& mesh, const Vec3& direction);

}  // namespace hallux::scenarios
