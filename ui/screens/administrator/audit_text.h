/// What the audit keeps as codes, said in words. Inside this corner only.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "database/records/audit_line.h"
#include "ui/widgets/texts/texts.h"

namespace hallux::ui {

/// What was done ("Gave a one-time code"), or what was refused ("Publish a scenario version").
std::string deed_text(const Texts& texts, const database::AuditLine& line);

/// To what: a login, a cohort, "Attempt 1b9f03aa", "Note 12"; free text behind it where there is
/// some.
std::string subject_text(const Texts& texts, const database::AuditLine& line);

/// Every code with words.
std::vector<std::string_view> known_deeds();

}  // namespace hallux::ui
