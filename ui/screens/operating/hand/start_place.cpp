#include "ui/screens/operating/hand/start_place.h"

#include "ui/sight/start_place.h"

namespace hallux::ui {

RigidTransform start_pose(const PreparedCase& prepared_case) {
  return start_pose(prepared_case.scenario, prepared_case.bones, prepared_case.plan);
}

Camera start_camera(const PreparedCase& prepared_case) {
  return start_camera(prepared_case.scenario, prepared_case.bones, prepared_case.plan);
}

}  // namespace hallux::ui
