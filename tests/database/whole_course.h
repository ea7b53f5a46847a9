/// A course of any size as the program itself leaves it, recordings, chains and audit included: for
/// what goes through all of a directory. Where rows are enough, tests/database/big_course.h is
/// quicker.
#pragma once

#include <cstdint>
#include <string>

#include "database/store/connection.h"

namespace hallux::database {

struct WholeCourse {
  std::int32_t trainees = 2000, attempts = 20'000;
  /// Of each recording, simulated milliseconds.
  std::int64_t ticks = 1000;
};

/// Into an empty directory: root, who administers; kim, who teaches "autumn"; trainee-1, ... in it.
/// Attempts go round the trainees; each has a score, each tenth a decision. The password of root is
/// `password`, at the cheapest cost.
void make_whole_course(Database& database, const WholeCourse& course, const std::string& password);

}  // namespace hallux::database
