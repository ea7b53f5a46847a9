/// Export of one person's data for that person: tables as CSV and JSON, in plain words.
/// Inside this room only.
#pragma once

#include <cstdint>
#include <filesystem>
#include <stdexcept>

#include "database/records/ids.h"
#include "database/store/connection.h"
#include "simulator/base/progress.h"

namespace hallux::database {

struct PersonExport {
  std::filesystem::path directory;
  std::int64_t files = 0, rows = 0;
};

/// Writes `explanation.txt`, `person.json` with everything, and a CSV file for each table, all from
/// one moment, into a directory that is new or empty; complete or not there. Other people are named
/// where the person sees their names anyway; notes that are private to instructors are not in it,
/// and their number is.
/// errors  DatabaseError: NotFound; BadInput where it lies in the data directory; Refused where it
///         holds something; storage failures; Cancelled
PersonExport export_person(Database& database, PersonId person,
                           const std::filesystem::path& directory, const Progress& progress = {});

}  // namespace hallux::database
