#include "assessment/measure_joint.h"

#include "assessment/make_measurement.h"
#include "assessment/rebuild/joint_margin.h"

namespace hallux::assessment {

namespace {

using scenarios::Metric;

Measurement margin_of(const Evidence& evidence) {
  const auto margin = measure_joint_margin(evidence.rebuilt, evidence.plan, evidence.bones);
  if (!margin) {
    const bool has_joints = !evidence.plan.joint_surfaces.empty();
    return absent(Metric::JointMarginMm, has_joints ? Absence::NotMade : Absence::Undefined, {});
  }
  const RebuiltKerf& kerf = evidence.rebuilt.kerfs[static_cast<std::size_t>(margin->kerf)];
  Measurement made = measured(
      Metric::JointMarginMm, margin->margin_mm, {kerf.first_cutting_tick, kerf.last_cutting_tick},
      transform_point(
          first_from(evidence.bones, evidence.plan.joint_surfaces[margin->surface].bone),
          margin->place_in_bone_mm));
  made.bound = margin->bound_mm;
  made.detail = {
      DetailKind::NearestJoint, {}, {evidence.plan.joint_surfaces[margin->surface].title}};
  return made;
}

}  // namespace

Measurement joint_margin_measurement(const Evidence& evidence) {
  Measurement made = margin_of(evidence);
  made.done_fraction = done_fraction_of(evidence.faces);
  return made;
}

}  // namespace hallux::assessment
