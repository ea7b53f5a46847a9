/// How a gripped piece follows the hand: it slides along what it touches and enters nothing, or it
/// turns about a joint or slides along it. Inside this room only.
///
///     handle --coupling--> wanted pose --contacts (proxy.h), joint--> pose of the piece
///
/// Contact goes both ways: points of the piece against the surfaces of the others, and points of
/// those against the surface of the piece; between flat walls that is all there is. Most points lie
/// far from the other body: those that matter are found as it moves (asked_points.h).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "simulator/base/fixed_list.h"
#include "simulator/contact/asked_points.h"
#include "simulator/contact/coupling.h"
#include "simulator/contact/proxy.h"
#include "simulator/contact/wound.h"
#include "simulator/mesh/bvh.h"

namespace hallux::simulator {

static_assert(2 * asked_point_limit <= contact_limit);

/// What the piece meets: surfaces that do not move while it is gripped.
struct StandingSurface {
  const Bvh* surface = nullptr;
  /// In the surface's frame, the foremost first.
  std::span<const Vec3> points_mm;
  RigidTransform wound_from_surface, surface_from_wound;
};

enum class JointMotion { Turn, Slide };

/// An axis that two fragments share, in the wound frame.
struct WoundJoint {
  Vec3 point_mm{0.0, 0.0, 0.0};
  /// Unit.
  Vec3 axis{0.0, 1.0, 0.0};
  /// Nearer to the axis contact is not looked for: there the fragments share a bridge.
  double free_radius_mm = 0.0;
  /// About the axis, or along it.
  JointMotion moves = JointMotion::Turn;
};

/// What the points of one side remember of one surface.
using PointMemories = std::array<SurfaceMemory, gripped_point_limit>;

/// A piece in the forceps.
struct GrippedBody {
  const Bvh* surface = nullptr;
  /// In the piece's frame, the foremost first; at most gripped_point_limit.
  std::span<const Vec3> points_mm;
  Vec3 centroid_mm{0.0, 0.0, 0.0};
  FixedList<StandingSurface, static_cast<std::size_t>(fragment_limit)> others;
  std::optional<WoundJoint> joint;
  RigidTransform wound_from_piece;
  /// As it was when the forceps closed.
  RigidTransform handle_from_piece;
  ProxyLoad load;

  /// Points of all others in the wound frame, the foremost of each first.
  FixedList<Vec3, gripped_point_limit> met_points_mm;
  AskedPoints asked, asked_met;
  /// Of the piece's points each other surface, and of the points met the piece's.
  std::array<PointMemories, static_cast<std::size_t>(fragment_limit)> memories{};
  PointMemories met_memories{};
};

/// Begins with the foremost points of all.
/// needs   the surfaces and their points are set
/// thread  haptic
void choose_points(GrippedBody& gripped) noexcept;

struct GrippedOutcome {
  /// On the hand, in the wound frame.
  CouplingPull pull;
  bool is_touching = false;
  /// The way of the piece's centroid in this tick.
  double moved_mm = 0.0;
};

/// Moves the piece for one tick towards where the hand wants it.
/// drive     beside the hand, a way in this tick that the piece goes as far as contact lets it
/// settings  of the coupling, as a tool's
/// errors  none: total, allocates nothing
/// thread  haptic
GrippedOutcome move_gripped(GrippedBody& gripped, const RigidTransform& wound_from_handle,
                            const std::optional<Vec3>& drive_mm,
                            const ContactSettings& settings) noexcept;

}  // namespace hallux::simulator
