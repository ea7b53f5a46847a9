/// What would have earned more, in words: the same on paper, on the screen and in the terminal.
#pragma once

#include <string>
#include <vector>

#include "assessment/what_if.h"

namespace hallux::ui {

struct SaidChange {
  /// What was to be otherwise: "First cut: turned back by 3.2°, seen from dorsal".
  std::string head;
  /// Which way it was off, and which items would have lost less.
  std::string body;
  /// "+4.2 points".
  std::string gain;
  /// Of the rubric, those that lose less.
  std::vector<std::string> items;
};

struct SaidWhatIf {
  /// The greatest gain first.
  std::vector<SaidChange> changes;
  /// What they earn together: "Both together", the score that would have been, and by how much it
  /// is more. Empty where there are fewer than two.
  std::string together, together_score, together_gain;
  /// Why nothing is proposed; empty where something is.
  std::string nothing;
};

/// needs   proposals, plan and card are of one attempt at this scenario
SaidWhatIf said_what_if(const assessment::Proposals& proposals, const scenarios::Scenario& scenario,
                        const scenarios::Plan& plan, const database::ScoreCard& card);

/// That the numbers are the scorer's, and what stayed as it was.
std::string_view what_if_note() noexcept;

}  // namespace hallux::ui
