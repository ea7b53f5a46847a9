/// The bone that the cuts of a step part off: what lies beyond their faces as they were sawn.
///
///           kept        | waste            A wedge is the bone between two faces, each beyond the
///     ..................|------------.     other.
///                       | parted off  )
///     ..................|------------'
///                      face
///
/// One notion for the score, which asks whether that bone went, and for whoever operates, who is
/// told which free piece is it.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "scenarios/plan.h"
#include "scenarios/site/site_watch.h"
#include "simulator/bone/cut_bone.h"
#include "simulator/cutting/field/kerf_set.h"

namespace hallux::scenarios {

/// A face that was sawn, and the part of its plane in which its section lies: further off the plane
/// may meet bone that has nothing to do with it.
struct SawnFace {
  /// The waste on the side of the normal.
  ReferenceFace plane;
  RigidTransform kerf_from_bone;
  /// Of the regions of the section that the blade touched, in the kerf's plane.
  Vec2 low_mm{0.0, 0.0}, high_mm{0.0, 0.0};
};

/// By name the cuts around what a step removes: its own, or of a wedge those beside its hinge.
std::vector<std::string> cuts_around(const OperationStep& step, const Plan& plan);

/// The face that a cut left so far.
/// needs   the cut is begun
SawnFace sawn_face(const HeldCut& held, const PlannedCut& cut, double kerf_mm);

bool lies_beyond(std::span<const SawnFace> faces, const Vec3& point_in_bone_mm) noexcept;

/// Places of a 0.5 mm grid in the bone beyond all the faces; none where there is no face. What the
/// blade took is not among them: of a thin wedge that is half.
/// whole   what their fragment was cut from
/// kerfs   of all, those in it
/// thread  any; some 10 ms
std::vector<Vec3> parted_places_mm(std::span<const SawnFace> faces,
                                   const simulator::SolidWithTree& whole,
                                   const simulator::KerfSet& all,
                                   const simulator::KerfNumbers& kerfs);

/// Whether more than half of the places lie in the bodies: a corner that breaks off is not the
/// piece, and an edge that stays is one still.
bool are_mostly_in(std::span<const simulator::Bvh* const> bodies,
                   std::span<const Vec3> places_mm) noexcept;

}  // namespace hallux::scenarios
