/// Waiting times against guessed passwords, without letting anybody keep another person out.
///
/// Each try is counted as refused before the password is looked at and forgotten where it was
/// right, so that a hundred tries at once count as a hundred. The next one waits for the longest of
/// three times:
///
///     one account at one station               0 0 0 1 2 4 8 16 32 60 60 ... s
///                                              after 0, 1, 2, ... refusals
///     one account, at all the other stations   nothing for 10 refusals in an hour,
///                                              then 1 2 4 8 8 ... s
///     one station, for all the other accounts  the same
///
/// So somebody at another station costs a person at most 8 seconds, and never the account. Rows
/// hold digests keyed by the directory's uuid: what was typed as a login, known or not, is not
/// kept. A row goes a day after its last refusal, and where the clock was set back it counts from
/// the new now, so that no wait is ever longer than its time.
/// source  docs/security.md; OWASP ASVS 4.0.3, 2.2.1: no more than 100 refusals an hour for an
///         account
#pragma once

#include <cstdint>
#include <string_view>

#include "database/store/connection.h"

namespace hallux::database {

/// Refused because it came too soon; the same for every login, known or not.
class TooSoon : public DatabaseError {
 public:
  TooSoon(std::string_view login, int wait_s);
  int wait_s() const noexcept { return wait_s_; }

 private:
  int wait_s_;
};

/// How long one account waits at one station after so many refusals in a row.
int wait_of_pair_s(std::int64_t refusals) noexcept;
/// How long it waits for refusals at other stations, or of other accounts.
int wait_of_others_s(std::int64_t refusals) noexcept;

/// Counts a try that begins now as refused.
/// errors  TooSoon, which does not count
void count_try(Database& database, std::string_view login);

/// The try was right: this account is known at this station.
void forget_tries(Database& database, std::string_view login);

}  // namespace hallux::database
