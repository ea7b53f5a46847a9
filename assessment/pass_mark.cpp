#include "assessment/pass_mark.h"

#include <algorithm>

namespace hallux::assessment {

namespace {

constexpr const char* safety_group = "safety";

bool is_safe(const database::GroupScore& group) noexcept {
  return static_cast<double>(group.earned_milli) >=
         safety_pass_share * static_cast<double>(group.measured_milli);
}

}  // namespace

PassAnswer pass_answer(const database::ScoreCard& card, std::int64_t standing_milli) noexcept {
  const bool is_gated = std::any_of(card.gates.begin(), card.gates.end(),
                                    [](const auto& gate) { return gate.is_triggered; });
  if (is_gated) return PassAnswer::NotReached;
  if (card.measured_milli < card.rubric_milli) return PassAnswer::NotDecided;
  const bool is_all_safe =
      std::all_of(card.groups.begin(), card.groups.end(),
                  [](const auto& group) { return group.name != safety_group || is_safe(group); });
  return standing_milli >= pass_milli && is_all_safe ? PassAnswer::Reached : PassAnswer::NotReached;
}

}  // namespace hallux::assessment
