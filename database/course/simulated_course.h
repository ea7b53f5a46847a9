/// The mark of a simulated course: its people are nobody, its attempts scripted and no grades.
#pragma once

#include "database/store/connection.h"

namespace hallux::database {

bool is_simulated_course(Database& database);

/// errors  DatabaseError Refused where the directory has people or attempts already
void check_may_be_simulated(Database& database);

/// Marks the directory, for good: every attempt made in it from now on is marked as well.
/// errors  DatabaseError Refused where it has people or attempts already
void mark_as_simulated_course(Database& database);

}  // namespace hallux::database
