#include "database/store/settings.h"

#include <algorithm>
#include <charconv>

#include "database/store/sql.h"

namespace hallux::database {

namespace {

constexpr std::string_view idle_lock = "idle_lock_min";

}  // namespace

std::optional<std::string> read_setting(Database& database, std::string_view name) {
  return translating(database, "read a setting", [&]() -> std::optional<std::string> {
    return found<std::string>(database, "SELECT value FROM setting WHERE name = ?", name);
  });
}

void store_setting(Database& database, std::string_view name, const std::string& value) {
  in_transaction_of_caller(database, "store a setting", [&] {
    execute(database,
            "INSERT INTO setting (name, value, set_utc) VALUES (?, ?, ?) "
            "ON CONFLICT (name) DO UPDATE SET value = excluded.value, set_utc = excluded.set_utc",
            name, value, utc_now(database));
  });
}

std::int32_t read_idle_lock_min(Database& database) {
  const std::string text = read_setting(database, idle_lock).value_or("");
  std::int32_t minutes = idle_lock_min_default;
  std::from_chars(text.data(), text.data() + text.size(), minutes);
  return std::clamp(minutes, idle_lock_min_least, idle_lock_min_most);
}

void store_idle_lock_min(Database& database, std::int32_t minutes) {
  if (minutes < idle_lock_min_least || minutes > idle_lock_min_most) {
    throw DatabaseError{DatabaseErrorKind::BadInput,
                        "the window can lock after " + std::to_string(idle_lock_min_least) +
                            " to " + std::to_string(idle_lock_min_most) + " minutes, not after " +
                            std::to_string(minutes)};
  }
  store_setting(database, idle_lock, std::to_string(minutes));
}

}  // namespace hallux::database
