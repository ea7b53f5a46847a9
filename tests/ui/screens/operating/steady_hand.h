/// A person's hand on mouse and keyboard who sees where the saw is and corrects: whole pixels,
/// notches and key presses, as a real mouse gives them, through the events of the window.
#pragma once

#include "simulator/base/transform.h"
#include "tests/ui/screens/operating/some_operation.h"

namespace hallux::ui {

class SteadyHand {
 public:
  /// needs  the operation runs; the person sees what NotedScenes notes
  explicit SteadyHand(Operator& person);

  /// Leads the saw there through the air, by pointer, wheel, left drag and keys. False where it
  /// does not come to rest within 0.12 mm (half a notch of the wheel) and 0.3 degrees of it.
  bool lead_to(const RigidTransform& world_from_tool);
  /// Where the saw is led, moved on, whatever holds the saw.
  void nudge(const Vec3& way_in_world_mm);
  void toggle_saw();
  const RigidTransform& world_from_tool() const;

 private:
  EyeView eye() const;
  void wait(double seconds);
  /// The pointer goes where it is to be.
  void point();
  void send(InputEvent event);
  void turn(const Vec3& turn_in_view_rad);

  Operator& person_;
  Point pointer_;
  Modifiers modifiers_;
  /// Less than a pixel or a notch.
  Vec3 owed_in_view_mm_{0.0, 0.0, 0.0};
};

}  // namespace hallux::ui
