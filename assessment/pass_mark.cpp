#include "assessment/pass_mark.h"

namespace hallux::assessment {

PassAnswer pass_answer(const database::PassFacts& facts, std::int64_t standing_milli) noexcept {
  if (facts.is_gated) return PassAnswer::NotReached;
  if (facts.measured_milli < facts.rubric_milli) return PassAnswer::NotDecided;
  const bool is_safe = static_cast<double>(facts.safety_earned_milli) >=
                       safety_pass_share * static_cast<double>(facts.safety_measured_milli);
  return standing_milli >= pass_milli && is_safe ? PassAnswer::Reached : PassAnswer::NotReached;
}

PassAnswer pass_answer(const database::ScoreCard& card, std::int64_t standing_milli) noexcept {
  return pass_answer(pass_facts_of(card), standing_milli);
}

}  // namespace hallux::assessment
