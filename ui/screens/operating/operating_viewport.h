/// The picture of an operation: the camera and the eyes, the bone, the saw, its chips and the
/// planned face. Inside this corner only.
#pragma once

#include <array>
#include <optional>

#include "simulator/loop/attempt_watch.h"
#include "ui/render/scene/swarf.h"
#include "ui/render/scene_painter.h"
#include "ui/screens/operating/bone_being_cut.h"
#include "ui/screens/operating/steering.h"
#include "ui/screens/pictures/shown_camera.h"

namespace hallux::ui {

/// What is there to be shown in a frame; all borrowed.
struct OperationInSight {
  const PreparedCase& prepared_case;
  /// The bone before anybody operates on it; nobody asks for it where there is one that is cut.
  const BonePicture& whole;
  BoneBeingCut* bone = nullptr;
  /// The loop's newest; nothing before its first step.
  const simulator::LoopView* loop = nullptr;
  RigidTransform world_from_target;
  /// The face to saw along, where people may see it.
  const scenarios::PlannedCut* cut = nullptr;
  bool is_paused = false, is_irrigated = false;
};

class OperatingViewport {
 public:
  /// Stands before the site.
  void face(const PreparedCase& prepared_case) { sight_.camera = start_camera(prepared_case); }
  void set_display(const Rect& display) noexcept { sight_.display = display; }

  /// Turns camera and eyes as the pointer and the keys of views ask for.
  void look(Ui& ui, const AreaResponse& area, const PreparedCase& prepared_case);
  /// What pointer and keys ask of the saw in this frame.
  std::array<simulator::PointerMotion, 2> motions(Ui& ui, const AreaResponse& area,
                                                  const Vec3& tip_in_world_mm);
  /// Nobody leads the saw in this frame.
  void release_pointer() noexcept { steering_.release_pointer(); }
  bool is_led_by_pointer() const noexcept { return steering_.is_led_by_pointer(); }
  const Quat& world_from_view() const noexcept { return sight_.camera.world_from_view; }

  /// Draws behind the widgets of this frame.
  void draw(Ui& ui, ScenePainter& painter, const OperationInSight& shown);

  /// Where a point is on the window; nothing where it lies behind the eye.
  std::optional<Point> place_of(const Vec3& point_in_world_mm) const {
    return place_on(sight_, point_in_world_mm);
  }
  StereoMode stereo_mode() const noexcept { return stereo_.mode; }
  /// What is on the screen, as it is kept beside the recording.
  simulator::ShownView shown_view() const noexcept;
  /// Between two pictures, the slower of the last.
  double frame_ms() const noexcept { return frame_ms_; }

 private:
  void hear_views(Ui& ui, const PreparedCase& prepared_case);
  void let_chips_fly(double step_s, const OperationInSight& shown);
  Scene scene(const Ui& ui, const OperationInSight& shown) const;

  Sight sight_;
  Steering steering_;
  StereoSetting stereo_;
  Swarf swarf_{1};
  double last_s_ = 0.0, frame_ms_ = 0.0;
  long pictures_ = 0;
};

}  // namespace hallux::ui
