/// Export of one person's data for that person: tables as CSV and JSON, in plain words.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <stdexcept>

#include "database/records/ids.h"
#include "database/store/connection.h"

namespace hallux::database {

struct PersonExport {
  std::filesystem::path directory;
  std::int64_t files = 0, rows = 0;
};

/// Thrown where `progress` asked to stop: nothing was left.
class ExportStopped : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Writes `explanation.txt`, `person.json` with everything, and a CSV file for each table, all from
/// one moment, into a directory that is new or empty; complete or not there. Other people are named
/// where the person sees their names anyway; notes that are private to instructors are not in it,
/// and their number is.
/// errors  DatabaseError: NotFound; Refused where the directory holds something; storage failures;
///         ExportStopped
PersonExport export_person(Database& database, PersonId person,
                           const std::filesystem::path& directory,
                           const std::function<bool(double)>& progress = {});

}  // namespace hallux::database
