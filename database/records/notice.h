/// Notices shown to people at sign-in.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "database/records/ids.h"
#include "database/records/names.h"

namespace hallux::database {

enum class NoticeKind {
  /// To administrators: the owner of the directory made a code for one of them.
  Recovered,
  /// To administrators: somebody became one.
  AdministratorMade,
  /// To administrators: for want of space.
  BackupSkipped,
  /// An administrator took the password away and made a one-time code.
  CodeIssued,
  /// By an administrator.
  PasswordSet,
  /// As this person, since they were told last; `count` says how many.
  SignInsRefused,
  /// Of an attempt of theirs.
  ResultOverridden,
  ResultVoided,
  /// By an administrator: how this person is called.
  NameCorrected
};

struct Notice {
  NoticeId id;
  NoticeKind kind = NoticeKind::Recovered;
  std::string at_utc;
  bool is_for_administrators = false;
  /// Of whom it is about, of a result who decided; "" where there is nobody, or nobody to be named.
  std::string login;
  std::optional<AttemptId> attempt;
  std::int64_t count = 0;
};

template <>
inline constexpr std::array<std::string_view, 9> stored_names<NoticeKind>{
    "recovered",        "administrator_made", "backup_skipped", "code_issued",   "password_set",
    "sign_ins_refused", "result_overridden",  "result_voided",  "name_corrected"};

}  // namespace hallux::database
