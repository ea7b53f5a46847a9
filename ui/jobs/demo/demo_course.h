/// A simulated course in an empty data directory, so that every screen can be seen full
/// (`hallux demo`).
///
/// Nobody in it is a person: the people are numbered, the attempts are scripted hands' and marked
/// as simulated in the database, none can become a grade. What happened is told of the past six
/// weeks.
///
///   DIR/demo-in-the-making/hallux.db  is filled through the desks, as people would, with the clock
///                                     set to each moment;
///   DIR/hallux.db                     takes it over in one transaction at the end: all or nothing
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "database/people/passwords.h"
#include "scenarios/scenario.h"
#include "ui/jobs/attempt_jobs.h"

namespace hallux::ui {

struct DemoOptions {
  /// Of each trainee.
  int attempts_max = 6;
  /// That are operated; none: the shipped ones.
  std::vector<scenarios::Scenario> scenarios;
  database::PasswordCost cost;
};

struct DemoAccount {
  std::string login;
  /// "administrator", "instructor", "trainee".
  std::string role;
};

struct DemoCourse {
  /// Of every account; made for this course, kept nowhere else.
  std::string password;
  std::vector<DemoAccount> accounts;
  int attempts = 0, notes = 0, replies = 0, help_requests = 0, decisions = 0;
};

/// errors  DatabaseError: Refused where the directory holds people or attempts; Locked where
///         another demo is being made in it; storage failures. Cancelled: nothing was kept
/// thread  any; a job of a minute that uses all processors
DemoCourse make_demo_course(const std::filesystem::path& directory, const DemoOptions& options,
                            const StageProgress& progress);

}  // namespace hallux::ui
