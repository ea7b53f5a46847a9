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

/// Lines for a spreadsheet, with a head: "entry,at_utc,by,code,did,outcome,to". Codes are kept
/// beside the words; times stay UTC.
std::string audit_csv(const Texts& texts, const std::vector<database::AuditLine>& lines);

/// Every code with words.
std::vector<std::string_view> known_deeds();

}  // namespace hallux::ui
