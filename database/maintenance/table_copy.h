/// Copy of all tables at one moment, without the chunks and display facts that lie beside them as
/// recordings: the part of a backup that is written anew each time. Inside this corner only.
#pragma once

#include <filesystem>
#include <functional>
#include <span>

#include "database/maintenance/recording_file.h"
#include "database/store/connection.h"

namespace hallux::database {

/// Writes them into a new database `file`, row by row from one snapshot. `elsewhere` is asked
/// inside the snapshot which attempts' recordings are to be left out. `goes_on` is asked between
/// rows; where it answers no, the copy ends as it is.
/// errors  DatabaseError: storage failures; Damaged where the copy does not hold together
void copy_tables(Database& source, const std::filesystem::path& file,
                 const std::function<std::vector<AttemptId>()>& elsewhere,
                 const std::function<bool()>& goes_on);

/// The statements that made a database, sorted: two of one schema give one text.
std::string schema_text(Database& database);

}  // namespace hallux::database
