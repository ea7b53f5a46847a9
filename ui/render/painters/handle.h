/// The part of a held tool behind its tip, and what of it gives way so that the tip is seen. No
/// graphics. Inside this corner only.
///
///     eye - - - - - - - - - - - - - - - - - > tip
///               handle: seen through near that line, where it lies before the tip
#pragma once

#include "ui/render/scene/box.h"
#include "ui/render/scene/camera.h"
#include "ui/render/scene/scene.h"

namespace hallux::ui {

/// Lies along its tool's x axis; the tip is the tool's origin.
struct Handle {
  RigidTransform world_from_tool;
  double front_x_mm = 0.0, back_x_mm = 0.0;
  /// No point of it is further from the axis, in y and z.
  Vec2 half_mm{0.0, 0.0};
  /// Of all of it.
  double presence = 1.0;
  /// What is nearer to the eye than the tip by less is whole, 4 mm further on it gives way.
  double keeps_mm = 2.0;
};

/// Hub, neck, grip and cable.
Handle handle_of(const SawInScene& saw) noexcept;
/// Chuck, neck, grip and cable.
Handle handle_of(const DriverInScene& driver) noexcept;
/// What a driver holds, whose end behind would hide the tip from who looks along it.
Handle held_of(const DriverInScene& driver) noexcept;
/// Both handles, without the jaws.
Handle handle_of(const ForcepsInScene& forceps) noexcept;

/// Within the first of the line from the eye to the tip the handle is seen through, beyond the
/// second it is whole.
inline constexpr double clear_within_mm = 12.0, whole_beyond_mm = 19.0;

/// Around the part of the handle that lies between the eye and the tip, so that it is seen through
/// there; tool frame.
Box before_the_tip(const Handle& handle, const Vec3& eye_mm) noexcept;
/// Around the part of the handle of which something is seen through; empty where it is whole.
Box seen_through_part(const Handle& handle, const EyeView& view) noexcept;

}  // namespace hallux::ui
