/// The part of the guide that belongs to a screen.
#pragma once

#include <cstdint>

namespace hallux::ui {

/// In the order of the guides; where each stands is ui/screens/guide/guides.h's to say.
enum class GuideSection : std::uint8_t {
  Overview,
  SignIn,
  Operations,
  Flight,
  Briefing,
  Operate,
  Result,
  Replay,
  Questions,
  History,
  Account,
  Cohort,
  Attempts,
  Inbox,
  Begin,
  People,
  Cohorts,
  Scenarios,
  Records,
  LeftOpen,
  Devices,
};
inline constexpr int guide_section_count = 21;

}  // namespace hallux::ui
