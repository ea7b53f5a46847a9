#include "simulator/step/forceps.h"

namespace hallux::simulator {

void Forceps::hold(std::int32_t fragment, const GrippedPiece& found, const Wound& wound,
                   const std::optional<WoundJoint>& joint,
                   const RigidTransform& wound_from_handle) noexcept {
  phase_ = Phase::Holding;
  fragment_ = fragment;
  closing_ = found.closing;
  drive_left_mm_ = 0.0;
  body_ = {};
  body_.surface = found.surface.get();
  body_.points_mm = found.points_mm;
  body_.centroid_mm = found.centroid_mm;
  body_.joint = joint;
  body_.wound_from_piece = wound.fragment(fragment)->wound_from_fragment;
  body_.handle_from_piece = inverse(wound_from_handle) * body_.wound_from_piece;
  for (const MetFragment& met : found.met) {
    const WoundFragment* const standing = wound.fragment(met.fragment);
    if (standing == nullptr || body_.others.is_full()) continue;
    body_.others.push({met.surface.get(), met.points_mm, standing->wound_from_fragment,
                       standing->fragment_from_wound});
  }
  choose_points(body_);
}

GrippedOutcome Forceps::lead(const RigidTransform& wound_from_handle, double duration_s,
                             const ContactSettings& settings) noexcept {
  if (!(drive_left_mm_ > 0.0))
    return move_gripped(body_, wound_from_handle, std::nullopt, settings);
  const double way_mm = drive_speed_mm_s * duration_s;
  const Vec3 drive_mm = way_mm * transform_direction(body_.wound_from_piece, closing_);
  const GrippedOutcome outcome = move_gripped(body_, wound_from_handle, drive_mm, settings);
  drive_left_mm_ -= way_mm;
  const bool is_home = outcome.is_touching && outcome.moved_mm < home_share * way_mm;
  if (is_home) drive_left_mm_ = 0.0;
  // The hand holds it where it came to, not where it was before.
  body_.handle_from_piece = inverse(wound_from_handle) * body_.wound_from_piece;
  return outcome;
}

}  // namespace hallux::simulator
