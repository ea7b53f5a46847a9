/// A course of any size, written as rows: for what has to be quick where there are many of them.
#pragma once

#include <cstdint>

#include "database/records/score.h"
#include "tests/database/some_database.h"

namespace hallux::database {

struct BigCourse {
  std::int32_t trainees = 1000, attempts_each = 100;
};

/// Into an empty directory: root, who administers; kim, who teaches "big", with all trainees
/// (trainee-1, ...); and lee, who teaches "idle", whose five trainees have done nothing. Each
/// second attempt is an assessment, with a card of the usual length; most of them are decided
/// about; each tenth attempt has a question, each tenth of those is open. The audit's rows are
/// there, its chain is not. Passwords are `password`, at the cheapest cost.
void make_big_course(Database& database, const BigCourse& course, const std::string& password);

/// As long as a real one: five groups, four gates and twenty lines.
ScoreCard card_of_usual_length(bool is_gated);

}  // namespace hallux::database
