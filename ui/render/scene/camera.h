/// Where a picture is seen from: a screen that stands in the world, and eyes in front of it.
///
///          eye left  eye right
///              \      /
///               \    /  viewing distance
///        ________\__/________
///        screen plane, x right, y up, z to the viewer
///
/// Seen through the window that the screen is, off axis for each eye: what lies in the screen plane
/// lands on the same pixel for both, what lies behind it is shifted apart as it is with real eyes.
/// Lengths are real millimetres divided by the magnification, so hand, picture and eyes keep one
/// scale.
///
/// source  reference/platform 1 (stereo, measured); frustum never toed in
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "ui/render/scene/float_vector.h"

namespace hallux::ui {

/// The screen on the desk and who looks at it.
struct Viewer {
  double screen_width_mm = 520.0;
  /// From the eyes to the screen.
  double distance_mm = 620.0;
  /// Between the pupils; 50 to 75.
  double eye_distance_mm = 63.0;
  /// Of the screen's width: how far apart the eyes' pictures may lie.
  double parallax_limit = 1.0 / 30.0;

  friend bool operator==(const Viewer&, const Viewer&) = default;
};

/// Looks at the target from the z side of the view frame.
struct Camera {
  /// In the world.
  Vec3 target_mm{0.0, 0.0, 0.0};
  /// View: x right, y up, z to the viewer.
  Quat world_from_view{1.0, 0.0, 0.0, 0.0};
  /// Millimetres on the screen for one in the world.
  double magnification = 8.0;
  /// How far behind the screen plane the target lies, in the world.
  double target_depth_mm = 6.0;

  friend bool operator==(const Camera&, const Camera&) = default;
};

enum class StandardView : std::uint8_t {
  /// As one stands: from above, medial and distal.
  Operator,
  Dorsal,
  Medial,
  Lateral,
  Plantar,
  Distal,
  Proximal,
  /// In the plane of a blade, which is seen edge on: follows from where the blade is, see
  /// seen_along_blade.
  AlongBlade
};
inline constexpr int standard_view_count = 8;

/// The three ways to look along a blade: across it to both sides, and over the handle to where the
/// saw goes.
enum class BladeSight : std::uint8_t { AcrossFromPlus, AcrossFromMinus, OverHandle };
inline constexpr std::size_t blade_sight_count = 3;

/// Turned about the target: to the right around the world's dorsal axis, then up around the view's
/// own x.
Camera orbited(const Camera& camera, double right_rad, double up_rad) noexcept;
/// Moved so that the picture follows by this much of the screen's width, to the right and up.
Camera panned(const Camera& camera, const Viewer& viewer, const Vec2& shares) noexcept;
/// Magnified by the factor, kept within 1 and 60.
Camera zoomed(const Camera& camera, double factor) noexcept;
/// The same target and magnification, seen from a side; world = foot frame (x distal, y dorsal, z
/// lateral, right foot).
/// needs   view is not AlongBlade
Camera standard_view(const Camera& camera, StandardView view) noexcept;
/// Looks at the middle of a blade's teeth, exactly in its plane, as upright as that lets it.
/// frame   blade: x where the saw goes, y along the teeth, z the normal
Camera along_blade(const Camera& camera, const RigidTransform& world_from_blade,
                   BladeSight sight) noexcept;
/// The best of those: of the ways on which least of the teeth is hidden the one with the smallest
/// turn. Who looks along the blade already gets the next of them.
/// hidden_shares  of the teeth, by BladeSight
Camera seen_along_blade(const Camera& camera, const RigidTransform& world_from_blade,
                        const std::array<double, blade_sight_count>& hidden_shares = {}) noexcept;
/// As near as shows a ball around the target wholly.
Camera fitted(const Camera& camera, const Viewer& viewer, double radius_mm, double aspect) noexcept;

enum class Eye : std::int8_t { Left = -1, Middle = 0, Right = 1 };

/// One eye's view of the world, ready to draw.
struct EyeView {
  /// Eye frame: the eye at the origin, looking along -z.
  DoubleMatrix4 view_from_world{1.0};
  DoubleMatrix4 clip_from_view{1.0};
  Vec3 eye_in_world_mm{0.0, 0.0, 0.0};
  Quat world_from_view{1.0, 0.0, 0.0, 0.0};
  /// Of the picture as it is shown.
  double width_over_height = 1.0;

  DoubleMatrix4 clip_from_world() const noexcept { return clip_from_view * view_from_world; }
  friend bool operator==(const EyeView&, const EyeView&) = default;
};

/// `width_over_height` is the whole picture's on the screen, whatever the pixels of one eye.
/// ensures a point in the screen plane has the same place in both eyes
EyeView view_of(const Camera& camera, const Viewer& viewer, Eye eye,
                double width_over_height) noexcept;

/// The same view with its picture moved by shares of its width and height, to the right and up.
EyeView shifted(const EyeView& view, const Vec2& shares) noexcept;

/// Where a point of the world lands, from the picture's upper left in shares of its width and
/// height; z is the depth in [-1, 1], or beyond where it is cut off.
Vec3 place_in_picture(const EyeView& view, const Vec3& point_in_world_mm) noexcept;
/// The point of the world at that place and depth.
Vec3 point_at(const EyeView& view, const Vec3& place) noexcept;

}  // namespace hallux::ui
