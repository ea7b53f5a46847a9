/// A view of bones inside a screen that a person turns: by dragging, by the wheel, and by keys.
///
///     left or middle drag, Alt+arrows   turn          wheel, plus and minus   nearer and farther
///     right drag                        move          1 to 7                  standard views
///                                                     8                       along the blade
///                                                     R                       as it was first
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "ui/render/scene_painter.h"
#include "ui/window/shell/shell.h"

namespace hallux::ui {

/// A name for content as the renderer wants it: never 0, the same for the same words.
std::uint64_t picture_id(std::string_view words) noexcept;

/// The texts that name the standard views, in their order; the keys 1 to 8 show them.
inline constexpr std::array<std::string_view, standard_view_count> standard_view_texts{
    "stage.operator", "stage.dorsal", "stage.medial",   "stage.lateral",
    "stage.plantar",  "stage.distal", "stage.proximal", "stage.along_blade"};

/// From the eye through a place of the picture, in the world.
struct SightRay {
  Vec3 from_mm{0.0, 0.0, 0.0};
  /// Unit.
  Vec3 direction{0.0, 0.0, -1.0};
};

/// What a person did in the view.
struct StageResponse {
  /// Where it was drawn.
  Rect rect;
  /// Clicked without having turned it.
  std::optional<SightRay> pointed;
  /// By hand or key, in this frame: turned, moved, nearer or farther.
  bool was_turned = false;
  /// By key, in this frame, to the view that it was first.
  bool was_turned_back = false;
};

/// Which picture is shown: a screen passes another revision where the scene has changed.
struct StagePicture {
  std::string_view id, label;
  std::uint64_t revision = 0;
  /// Of its corners.
  float radius = 0.0F;
};

class BoneViewport {
 public:
  /// The view that R comes back to: a ball in the world wholly in sight. Takes effect with the next
  /// drawing.
  void look_at(const Vec3& middle_in_world_mm, double radius_mm, const Quat& world_from_view);
  void look_at(const Vec3& middle_in_world_mm, double radius_mm, StandardView view);
  /// Where the blade is whose plane key 8 looks along; without one there is no such view.
  /// frame   x where the saw goes, y along the teeth, z the normal
  void set_blade(const RigidTransform& world_from_blade) { world_from_blade_ = world_from_blade; }
  bool has_blade() const noexcept { return world_from_blade_.has_value(); }
  /// needs   has_blade for AlongBlade
  void turn_to(StandardView view) noexcept;
  void turn_back() noexcept { is_fitted_ = false; }
  /// That camera from now on.
  void show(const Camera& camera) noexcept {
    camera_ = camera;
    is_fitted_ = true;
  }
  /// Plus and minus are the screen's: the view hears them with Alt.
  void leave_plus_and_minus() noexcept { zooms_with_alt_ = true; }
  bool has_view() const noexcept { return radius_mm_ > 0.0; }

  /// Draws the scene where it changed and shows it; hears the pointer and, where `hears_keys`, the
  /// keys.
  /// needs   has_view
  StageResponse draw(Ui& ui, Shell& shell, const Rect& rect, const Scene& scene,
                     const StagePicture& picture, bool hears_keys = true);
  /// Through a place of the picture last drawn, in shares of its width and height from the upper
  /// left.
  SightRay ray_through(const Vec2& shares) const noexcept;
  /// Where a point of the world is seen in the picture last drawn; nothing behind the eye or
  /// outside the rectangle.
  std::optional<Point> seen_at(const Vec3& point_in_world_mm) const noexcept;

 private:
  bool hear_pointer(const AreaResponse& area);
  bool hear_keys(Ui& ui);
  EyeView eye_view() const noexcept;

  Camera camera_, first_;
  std::optional<RigidTransform> world_from_blade_;
  double radius_mm_ = 0.0;
  bool is_fitted_ = false, zooms_with_alt_ = false;
  Rect rect_{0.0F, 0.0F, 1.0F, 1.0F};
  /// What the picture was drawn from.
  std::uint64_t drawn_ = 0;
};

}  // namespace hallux::ui
