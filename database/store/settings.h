/// Settings of the whole directory; one without a row is as the program ships it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "database/store/connection.h"

namespace hallux::database {

/// Minutes without a touch after which the window locks.
inline constexpr std::int32_t idle_lock_min_default = 10, idle_lock_min_least = 5,
                              idle_lock_min_most = 60;

/// Nothing where nobody set it.
/// errors  DatabaseError
std::optional<std::string> read_setting(Database& database, std::string_view name);
/// Inside the caller's transaction, or in one of its own.
/// errors  DatabaseError
void store_setting(Database& database, std::string_view name, const std::string& value);

/// Within its bounds, whatever is stored.
/// errors  DatabaseError
std::int32_t read_idle_lock_min(Database& database);
/// errors  DatabaseError BadInput outside 5 to 60
void store_idle_lock_min(Database& database, std::int32_t minutes);

}  // namespace hallux::database
