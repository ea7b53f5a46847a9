/// Where a blade touches bone: points along its teeth, on its faces and on its edges, and the
/// surface that each is near to. Inside this room only.
///
///     collar                          teeth
///       o    o    o    o    o    o    o :
///       o    o    o    o    o    o    o :     rows across the blade from edge to edge,
///       o    o    o    o    o    o    o :     balls as thick as the blade;
///       o    o    o    o    o    o    o :     every second tooth, a small ball right behind it
///       o    o    o    o    o    o    o :
///
/// The surface is what still stands: the original bone's, minus open kerfs and pieces taken out.
#pragma once

#include <array>
#include <span>

#include "simulator/contact/surface_memory.h"
#include "simulator/contact/wound.h"

namespace hallux::simulator {

inline constexpr std::size_t contact_tooth_count = 11;
inline constexpr std::size_t contact_rows = 8;
inline constexpr std::size_t contact_columns = 5;
inline constexpr std::size_t contact_point_count =
    contact_tooth_count + contact_rows * contact_columns;

using BladeMemory = std::array<SurfaceMemory, contact_point_count>;

/// A blade may touch so many fragments at once; what it touches of others is not felt.
inline constexpr std::size_t touched_fragments = 3;
/// As many contacts as there may be at once.
inline constexpr std::size_t contact_limit = touched_fragments * contact_point_count;

/// A point of the blade, or of what is moved, near standing bone.
struct BladeContact {
  /// Below contact_limit, another for each fragment that the point is near to.
  std::size_t point = 0;
  /// From the tool's origin, bone frame.
  Vec3 arm_mm{0.0, 0.0, 0.0};
  /// Out of the bone, unit length.
  Vec3 normal{0.0, 0.0, 0.0};
  /// Between the point's ball and the bone, negative where it is in.
  double gap_mm = 0.0;
  bool is_tooth = false;
};

/// The contacts of one pose; the first `count` of the list.
struct BladeContacts {
  std::array<BladeContact, contact_limit> list{};
  std::size_t count = 0;

  std::span<const BladeContact> all() const noexcept { return {list.data(), count}; }
};

/// All points whose ball is within `margin_mm` of standing bone. Left out are points in an open
/// kerf while no piece is missing (its walls are the teeth's), and points more than a millimetre
/// inside bone, which have no way out.
/// errors  none: total, allocates nothing
/// thread  haptic
BladeContacts find_contacts(const RigidTransform& bone_from_tool, const Wound& bone,
                            double margin_mm, OfFragments<BladeMemory>& memory) noexcept;

}  // namespace hallux::simulator
