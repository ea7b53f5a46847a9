/// The attempts of both scripted hands at a shipped operation, with score and replay: what the
/// hands' tests look at.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace hallux::tests {

inline constexpr std::size_t table_seeds = 20;
inline constexpr std::array<const char*, 2> table_hands{"expert", "novice"};

struct AttemptRow {
  double score = 0.0;
  /// Items A1 and A2.
  double angle_deg = 0.0, location_mm = 0.0;
  /// Where the rubric has them.
  double hinge_mm = 0.0, over_cut_mm = 0.0;
  /// Every item.
  bool is_measured = false;
  /// The greatest on the hand.
  double force_newton = 0.0;
  /// Of 5 x 5 mm that went above 47 degrees.
  double hot_patches = 0.0;
  double zone_contacts = 0.0;
  bool freed_a_piece = false, closed_hinge = false;
  /// No deed of the operation is missing: the piece is out, the wedge closed.
  bool is_done = true;
  bool is_identical = false;
  std::int64_t difference_tick = -1;
  double duration_s = 0.0;
};

/// Of the seeds 1, 2, ...
using AttemptRows = std::vector<AttemptRow>;

struct AttemptTable {
  /// By hand, then by seed - 1.
  std::array<AttemptRows, table_hands.size()> rows{};
};

/// Carries out, scores and replays those of the seeds 1 to `seeds`, on two threads, and prints the
/// table with the time it took.
AttemptTable run_attempts(std::string_view scenario, std::size_t seeds = table_seeds);

double median(const AttemptRows& rows, double AttemptRow::*value);

/// Expects that every attempt replays identically, and that the expert's do all of the operation,
/// touch no danger zone and are measured wholly; of the novice's one in five may lack a cut: two
/// cuts that go into one kerf leave nothing to measure of the second.
void expect_sound(const AttemptTable& table);
/// Prints the medians; expects besides that the expert's median score is above 75 and the novice's
/// below 45, that each hand cuts within 30 % of the errors it is said to have, and that only the
/// novice's median overheats bone.
void expect_told_apart(const AttemptTable& table);

}  // namespace hallux::tests
