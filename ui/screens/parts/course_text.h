/// What the screens of a course say about moments, people and operations.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "database/records/attempt.h"
#include "database/records/notice.h"
#include "ui/widgets/texts/texts.h"

namespace hallux::ui {

/// The moment now, ISO 8601 in UTC, as the database writes it.
std::string utc_now_text();

/// "today", "yesterday", "5 days ago", beyond a month the date; "never" for "".
std::string ago_text(const Texts& texts, std::string_view utc, std::string_view now_utc);

/// An operation's name as a word of its own: "akin" is "Akin".
std::string operation_text(std::string_view scenario_name);

/// An attempt as a list calls it: its operation and when it was begun.
std::string attempt_name(const Texts& texts, const database::AttemptHeader& attempt);

/// A notice in one sentence. Somebody whose name was erased is "somebody".
std::string notice_text(const Texts& texts, const database::Notice& notice);

/// The name that is shown: the login where there is none.
std::string shown_name_of(std::string_view login, std::string_view display_name);

/// The same of somebody who may have been erased.
std::string person_name_of(const Texts& texts, std::string_view login,
                           std::string_view display_name);

/// True where `words` holds `part`, capital or small (a-z). Everything holds "".
bool contains_text(std::string_view words, std::string_view part);

}  // namespace hallux::ui
