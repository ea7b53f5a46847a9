#include "database/course/simulated_course.h"

#include "database/audit/audit.h"
#include "database/store/sql.h"

namespace hallux::database {

bool is_simulated_course(Database& database) {
  return translating(database, "look whether the course is simulated", [&] {
    return single<bool>(database, "SELECT EXISTS (SELECT 1 FROM simulated_course)");
  });
}

void check_may_be_simulated(Database& database) {
  translating(database, "look for people and attempts", [&] {
    if (single<std::int32_t>(
            database, "SELECT EXISTS (SELECT 1 FROM person) OR EXISTS (SELECT 1 FROM attempt)") ==
        0)
      return;
    throw DatabaseError{DatabaseErrorKind::Refused,
                        database.file().string() +
                            " holds people or attempts; a simulated course needs an empty "
                            "directory, name one with --data"};
  });
}

void mark_as_simulated_course(Database& database) {
  in_transaction(database, "mark the course as simulated", [&] {
    check_may_be_simulated(database);
    if (execute(database,
                "INSERT INTO simulated_course (simulated_course_id, marked_utc) "
                "VALUES (1, ?) ON CONFLICT DO NOTHING",
                utc_now(database)) == 1) {
      append_audit(database, {std::nullopt, "marked_as_simulated", "course", "1"});
    }
  });
}

}  // namespace hallux::database
