/// What was on the screen at each moment of an attempt. Inside this corner only.
#pragma once

#include <string>
#include <vector>

#include "simulator/record/display_fact.h"
#include "ui/widgets/texts/texts.h"

namespace hallux::ui {

enum class Seen {
  /// The view is what was on the screen.
  Recorded,
  /// Of an older attempt, or one without a window.
  NotRecorded,
  /// What stands there is no view, or one that this program does not know.
  Unusable
};

struct SeenView {
  Seen seen = Seen::NotRecorded;
  /// Where it is Recorded.
  simulator::ShownView view = {};
};

class SeenViews {
 public:
  SeenViews() = default;
  /// By tick, as they are kept: nobody vouches for them.
  explicit SeenViews(std::vector<simulator::DisplayFact> facts) : facts_(std::move(facts)) {}

  /// Turns from fact to fact where they follow each other closely, as the person turned the view;
  /// stays else. Before the first fact it is the first.
  SeenView at(double time_s) const noexcept;

 private:
  std::vector<simulator::DisplayFact> facts_;
};

/// What is shown as seen, in words: the screen as it was, or why it is the operator's view.
std::string seen_text(const Texts& texts, const SeenView& seen);

}  // namespace hallux::ui
