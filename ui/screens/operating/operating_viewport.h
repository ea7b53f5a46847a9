/// The picture of an operation: the camera and the eyes, the bone, the saw, its chips and the
/// planned face. Inside this corner only.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "simulator/loop/attempt_watch.h"
#include "ui/render/scene/swarf.h"
#include "ui/render/scene_painter.h"
#include "ui/screens/operating/hand/start_place.h"
#include "ui/screens/operating/hand/steering.h"
#include "ui/screens/operating/hand/tools_in_hand.h"
#include "ui/screens/operating/hud/operating_hud.h"
#include "ui/screens/operating/site/bone_being_cut.h"
#include "ui/screens/operating/site/site_picture.h"
#include "ui/screens/pictures/shown_camera.h"

namespace hallux::ui {

/// What is there to be shown in a frame; all borrowed.
struct OperationInSight {
  const PreparedCase& prepared_case;
  /// The bone before anybody operates on it; nobody asks for it where there is one that is cut.
  const BonePictures& wholes;
  BoneBeingCut* bone = nullptr;
  /// The loop's newest; nothing before its first step.
  const simulator::LoopView* loop = nullptr;
  RigidTransform world_from_target;
  /// What is in the hand; null: the scenario's saw.
  const ToolsInHand* tools = nullptr;
  /// The face to saw along, where people may see it.
  const scenarios::PlannedCut* cut = nullptr;
  /// The wire or screw to be set and the shift to be made, where people may see them.
  const scenarios::PlannedImplant* implant = nullptr;
  std::optional<std::size_t> shift = {};
  bool is_paused = false, is_irrigated = false;
  /// What stands around the bone; null: nothing.
  const SitePicture* site = nullptr;
  bool is_neighbour_shown = true;
  /// Bone that still holds, and where it is deepest; null: nobody is to know, or knows.
  const SiteFacts* facts = nullptr;
  /// In practice: danger zones, outlines of free pieces, the blade's line on the bone, and how far
  /// the teeth are from it; else only whether they touch.
  bool is_guided = false;
  /// Marked, where somebody is to go.
  std::span<const Mark> goals = {};
};

class OperatingViewport {
 public:
  /// Stands before the site.
  void face(const PreparedCase& prepared_case) { sight_.camera = start_camera(prepared_case); }
  void set_display(const Rect& display) noexcept { sight_.display = display; }

  /// Hears the pointer and the keys of hand, camera and eyes; the camera follows.
  /// may_lead         somebody leads the saw
  /// tip_in_world_mm  what the pointer's way is measured at
  Steered hear(Ui& ui, const AreaResponse& area, const PreparedCase& prepared_case, bool may_lead,
               const Vec3& tip_in_world_mm);
  /// Nobody leads the saw in this frame: the hand is set down where it goes on.
  void release_pointer() noexcept;
  /// The camera goes as a 3D mouse is pushed and turned: what is looked at turns with its cap.
  void turn(const simulator::PointerMotion& motion) noexcept;
  bool is_led_by_pointer() const noexcept { return steering_.is_led_by_pointer(); }
  const HandLift& lift() const noexcept { return steering_.lift(); }
  const Quat& world_from_view() const noexcept { return sight_.camera.world_from_view; }

  /// Draws behind the widgets of this frame.
  void draw(Ui& ui, ScenePainter& painter, const OperationInSight& shown);

  /// Where a point is on the window; nothing where it lies behind the eye.
  std::optional<Point> place_of(const Vec3& point_in_world_mm) const {
    return place_on(sight_, point_in_world_mm);
  }
  /// The saw as it was drawn last, as places on the window.
  std::vector<ToolPlace> tool_places() const;
  StereoMode stereo_mode() const noexcept { return stereo_.mode; }
  /// What is in the picture, as it is kept beside the recording; not what stands beside it.
  simulator::ShownView shown_view() const noexcept;
  /// Between two pictures, the slower of the last.
  double frame_ms() const noexcept { return frame_ms_; }

 private:
  Camera sight_along_blade() const;
  void hear_views(Ui& ui, const PreparedCase& prepared_case);
  void hear_eyes(Ui& ui);
  void let_chips_fly(double step_s, const OperationInSight& shown);
  Scene scene(const Ui& ui, const OperationInSight& shown, double swings) const;

  Sight sight_;
  Steering steering_;
  StereoSetting stereo_;
  /// The saw as it was drawn last, or the outline of another tool, and what was hidden of it then.
  SawInScene drawn_saw_;
  std::array<double, blade_sight_count> hidden_along_blade_{};
  Swarf swarf_{1};
  double last_s_ = 0.0, frame_ms_ = 0.0;
  long pictures_ = 0;
};

}  // namespace hallux::ui
