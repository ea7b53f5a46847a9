#include "database/people/sign_in_guard.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>

#include "database/store/sql.h"

namespace hallux::database {

namespace {

constexpr int wait_of_pair_max_s = 60, wait_of_others_max_s = 8;
constexpr std::int64_t free_tries_of_pair = 3, free_tries_of_others = 10;

int doubled_s(std::int64_t times, int max_s) noexcept {
  return times >= 6 ? max_s : std::min(1 << times, max_s);
}

std::string sentence_of(std::string_view login, int wait_s) {
  return "could not sign in as '" + std::string{login} +
         "': after wrong passwords the next try has to wait; try again in " +
         std::to_string(wait_s) + (wait_s == 1 ? " second" : " seconds");
}

/// This machine and who uses it: the same after a restart.
std::string this_station() {
  std::string machine;
  std::getline(std::ifstream{"/etc/machine-id"}, machine);
  if (machine.empty()) {
    std::array<char, 256> name{};
    if (gethostname(name.data(), name.size() - 1) == 0) machine = name.data();
  }
  return machine + "/" + std::to_string(geteuid());
}

struct Keys {
  Digest account, station;
};

Digest keyed(std::string_view purpose, std::string_view key, std::string_view text) {
  Digester digester;
  digester.add_text(purpose);
  digester.add_text(key);
  digester.add_text(text);
  return digester.finish();
}

Keys keys_of(Database& database, std::string_view login) {
  const auto key = single<std::string>(database, "SELECT uuid FROM directory");
  const std::string& pretended = database.pretended_station();
  return {keyed("account", key, login),
          keyed("station", key, pretended.empty() ? this_station() : pretended)};
}

/// What is old goes; what a clock set back left in the future happened now.
void tidy(Database& database, const std::string& now) {
  execute(database,
          "DELETE FROM sign_in_guard WHERE "
          "failed_utc < strftime('%Y-%m-%dT%H:%M:%fZ', ?, '-1 day')",
          now);
  execute(database, "UPDATE sign_in_guard SET failed_utc = ?1 WHERE failed_utc > ?1", now);
}

/// What is left of the wait that `wait_of` asks for after the refusals of `rows`.
template <typename WaitOf>
int wait_left_s(SQLite::Statement rows, const Keys& keys, const std::string& now, WaitOf wait_of) {
  bind_all(rows, keys.account, keys.station, now);
  rows.executeStep();
  const int whole_s = wait_of(rows.getColumn(0).getInt64());
  // A julian day is exact to some tens of microseconds.
  const double left_s = whole_s - rows.getColumn(1).getDouble() - 0.001;
  return std::clamp(static_cast<int>(std::ceil(left_s)), 0, whole_s);
}

int wait_now_s(Database& database, const Keys& keys, const std::string& now) {
  const auto rows = [&](const std::string& where) {
    return SQLite::Statement{database.connection(),
                             "SELECT coalesce(sum(failures), 0), coalesce((julianday(?3) - "
                             "julianday(max(failed_utc))) * 86400.0, 0.0) "
                             "FROM sign_in_guard WHERE " +
                                 where};
  };
  const std::string in_an_hour = " AND failed_utc > strftime('%Y-%m-%dT%H:%M:%fZ', ?3, '-1 hour')";
  return std::max({wait_left_s(rows("account = ?1 AND station = ?2"), keys, now, wait_of_pair_s),
                   wait_left_s(rows("account = ?1 AND station <> ?2" + in_an_hour), keys, now,
                               wait_of_others_s),
                   wait_left_s(rows("station = ?2 AND account <> ?1" + in_an_hour), keys, now,
                               wait_of_others_s)});
}

void add_refusal(Database& database, const Keys& keys, const std::string& now) {
  execute(database,
          "INSERT INTO sign_in_guard (account, station, failures, failed_utc) "
          "VALUES (?, ?, 1, ?) ON CONFLICT (account, station) DO UPDATE SET "
          "failures = failures + 1, failed_utc = excluded.failed_utc",
          keys.account, keys.station, now);
}

}  // namespace

TooSoon::TooSoon(std::string_view login, int wait_s)
    : DatabaseError(DatabaseErrorKind::Refused, sentence_of(login, wait_s)), wait_s_(wait_s) {}

int wait_of_pair_s(std::int64_t refusals) noexcept {
  return refusals < free_tries_of_pair
             ? 0
             : doubled_s(refusals - free_tries_of_pair, wait_of_pair_max_s);
}

int wait_of_others_s(std::int64_t refusals) noexcept {
  return refusals < free_tries_of_others
             ? 0
             : doubled_s(refusals - free_tries_of_others, wait_of_others_max_s);
}

void count_try(Database& database, std::string_view login) {
  const int wait_s = in_transaction(database, "begin a sign-in", [&] {
    const std::string now = utc_now(database);
    const Keys keys = keys_of(database, login);
    tidy(database, now);
    const int left_s = wait_now_s(database, keys, now);
    if (left_s == 0) add_refusal(database, keys, now);
    return left_s;
  });
  if (wait_s > 0) throw TooSoon{login, wait_s};
}

void forget_tries(Database& database, std::string_view login) {
  in_transaction_of_caller(database, "end a sign-in", [&] {
    const Keys keys = keys_of(database, login);
    execute(database, "DELETE FROM sign_in_guard WHERE account = ? AND station = ?", keys.account,
            keys.station);
  });
}

}  // namespace hallux::database
