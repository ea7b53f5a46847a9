/// The forceps: a piece is wanted, what it meets is asked for, it is held and led, it is let go.
/// Inside this corner only.
///
///     Empty --want--> Wanted --ask--> Asked --hold--> Holding --let_go--> Empty
#pragma once

#include <cstdint>
#include <optional>

#include "simulator/contact/gripped_body.h"
#include "simulator/jobs/geometry_job.h"
#include "simulator/record/refusals.h"

namespace hallux::simulator {

class Forceps {
 public:
  enum class Phase { Empty, Wanted, Asked, Holding };

  Phase phase() const noexcept { return phase_; }
  bool is_empty() const noexcept { return phase_ == Phase::Empty; }
  bool is_holding() const noexcept { return phase_ == Phase::Holding; }
  std::int32_t wanted() const noexcept { return wanted_; }
  /// Held; -1: none is.
  std::int32_t fragment() const noexcept { return is_holding() ? fragment_ : -1; }

  /// needs   is_empty()
  void want(std::int32_t piece) noexcept {
    phase_ = Phase::Wanted;
    wanted_ = piece;
  }
  void ask() noexcept { phase_ = Phase::Asked; }
  void let_go() noexcept { phase_ = Phase::Empty; }
  /// Holds a fragment from now on. Borrows what the job found until it lets go.
  /// found   of that piece
  /// wound   the fragment and all that it meets stand in it
  void hold(std::int32_t fragment, const GrippedPiece& found, const Wound& wound,
            const std::optional<WoundJoint>& joint,
            const RigidTransform& wound_from_handle) noexcept;
  const RigidTransform& wound_from_piece() const noexcept { return body_.wound_from_piece; }

  /// Drives the piece home from now on.
  void drive() noexcept { drive_left_mm_ = drive_most_mm; }
  /// Leads the piece for one tick.
  GrippedOutcome lead(const RigidTransform& wound_from_handle, double duration_s,
                      const ContactSettings& settings) noexcept;

 private:
  /// So far a piece is driven at most, and so fast.
  static constexpr double drive_most_mm = 5.0, drive_speed_mm_s = 5.0;
  /// Driven home: it hardly goes further.
  static constexpr double home_share = 0.02;

  Phase phase_ = Phase::Empty;
  std::int32_t wanted_ = 0, fragment_ = -1;
  /// In the piece's frame.
  Vec3 closing_{0.0, 0.0, 0.0};
  double drive_left_mm_ = 0.0;
  GrippedBody body_;
};

}  // namespace hallux::simulator
