#include "database/people/hand_settings.h"

#include <string>

#include "database/store/sql.h"

namespace hallux::database {

namespace {

constexpr std::int32_t whole_share_milli = 1000;

void check(const char* what, const std::optional<std::int32_t>& milli, std::int32_t least,
           std::int32_t most) {
  if (!milli || (*milli >= least && *milli <= most)) return;
  throw DatabaseError{DatabaseErrorKind::BadInput,
                      std::string{what} + " of " + std::to_string(*milli) +
                          " thousandths: give one from " + std::to_string(least) + " to " +
                          std::to_string(most)};
}

}  // namespace

HandSettings load_hand_settings(Database& database, PersonId person) {
  return translating(database, "read how somebody holds the saw", [&] {
    auto row = prepared(database,
                        "SELECT is_left_handed, motion_scale_milli, force_share_milli FROM "
                        "hand_setting WHERE person_id = ?",
                        person.number);
    HandSettings settings;
    if (row.executeStep()) {
      read_columns(row, 0, settings.is_left_handed, settings.motion_scale_milli,
                   settings.force_share_milli);
    }
    return settings;
  });
}

void store_hand_settings(Database& database, PersonId person, const HandSettings& settings) {
  check("a motion scale", settings.motion_scale_milli, motion_scale_milli_least,
        motion_scale_milli_most);
  check("a share of the force", settings.force_share_milli, 0, whole_share_milli);
  in_transaction_of_caller(database, "keep how somebody holds the saw", [&] {
    execute(database,
            "INSERT INTO hand_setting (person_id, is_left_handed, motion_scale_milli, "
            "force_share_milli, changed_utc) VALUES (?, ?, ?, ?, ?) ON CONFLICT (person_id) DO "
            "UPDATE SET is_left_handed = excluded.is_left_handed, motion_scale_milli = "
            "excluded.motion_scale_milli, force_share_milli = excluded.force_share_milli, "
            "changed_utc = excluded.changed_utc",
            person.number, settings.is_left_handed ? 1 : 0, settings.motion_scale_milli,
            settings.force_share_milli, utc_now(database));
  });
}

}  // namespace hallux::database
