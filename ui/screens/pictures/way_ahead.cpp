#include "ui/screens/pictures/way_ahead.h"

#include <array>
#include <cmath>

#include "ui/widgets/texts/number_text.h"

namespace hallux::ui {

namespace {

/// A feed that leads to the hinge more slowly leads elsewhere.
constexpr double least_towards_hinge = 0.2;

}  // namespace

std::optional<double> way_to_hinge_mm(const scenarios::PlannedHinge& hinge,
                                      const RigidTransform& bone_from_tool) noexcept {
  const simulator::HingeLine& line = hinge.bridge.line;
  const double towards = glm::dot(line.outward, axis_x(bone_from_tool));
  if (towards < least_towards_hinge) return std::nullopt;
  return glm::dot(line.outward, line.point_in_bone_mm - bone_from_tool.translation_mm) / towards;
}

std::optional<WayAhead> way_ahead(const simulator::BladeAhead& ahead,
                                  std::optional<double> to_hinge_mm) noexcept {
  if (!ahead.to_bone_mm) {
    if (ahead.beside_mm <= touching_mm) return std::nullopt;
    return WayAhead{WayEnd::Beside, ahead.beside_mm};
  }
  if (*ahead.to_bone_mm > touching_mm) return WayAhead{WayEnd::Bone, *ahead.to_bone_mm};
  if (to_hinge_mm)
    return WayAhead{*to_hinge_mm < 0.0 ? WayEnd::PastHinge : WayEnd::Hinge, std::abs(*to_hinge_mm)};
  return WayAhead{WayEnd::FarSide, ahead.to_far_side_mm.value_or(0.0)};
}

std::optional<double> stroke_end_mm(const simulator::BladeAhead& ahead,
                                    std::optional<double> to_hinge_mm) noexcept {
  return to_hinge_mm ? to_hinge_mm : ahead.to_far_side_mm;
}

std::string words_of(const Texts& texts, const WayAhead& way) {
  // In the order of WayEnd.
  constexpr std::array<const char*, 5> ids{"operate.tip.bone", "operate.tip.beside",
                                           "operate.tip.far", "operate.tip.hinge",
                                           "operate.tip.past_hinge"};
  return texts.say(ids[static_cast<std::size_t>(way.to)],
                   {{"way", fixed_text(way.way_mm, 1) + " mm"}});
}

}  // namespace hallux::ui
