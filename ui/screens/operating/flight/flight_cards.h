/// The card at the end of the first flight. Inside this corner only.
#pragma once

#include "ui/screens/operating/flight/flight_lessons.h"
#include "ui/widgets/ui.h"

namespace hallux::ui {

/// What a lesson is called, as the id of a text.
std::string_view title_of(Lesson lesson) noexcept;

enum class FlightAnswer { Waiting, Operations, Again };
/// What was learned, what was left out, and the ways on.
FlightAnswer draw_flown_card(Ui& ui, const FlightLessons& lessons);

}  // namespace hallux::ui
