#include "ui/screens/parts/attempt_timeline.h"

#include <gtest/gtest.h>

namespace hallux::ui {
namespace {

TEST(AttemptEvents, EachThatIsToldHasItsWords) {
  simulator::Recording recording;
  for (int kind = 1; kind <= static_cast<int>(simulator::CutEventKind::ImplantRefused); ++kind) {
    simulator::CutEvent event;
    event.kind = static_cast<simulator::CutEventKind>(kind);
    recording.events.push_back(event);
  }
  const std::vector<AttemptEvent> told = events_of(recording);
  EXPECT_EQ(told.size(), 36U)
      << "all but touches, known sections, holes that are entered again and carried implants";
  const Texts texts = english_texts();
  for (const AttemptEvent& event : told) EXPECT_NE(texts.text(event.words), event.words);
}

}  // namespace
}  // namespace hallux::ui
