/// What people are told at their next sign-in.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "database/records/ids.h"

namespace hallux::database {

enum class NoticeKind {
  Recovered,          ///< to administrators: the owner of the directory made a code for one of them
  AdministratorMade,  ///< to administrators: somebody became one
  BackupSkipped,      ///< to administrators: for want of space
  CodeIssued,         ///< an administrator took the password away and made a one-time code
  PasswordSet,        ///< by an administrator
  SignInsRefused,     ///< as this person, since they were told last; `count` says how many
  ResultOverridden,   ///< of an attempt of theirs
  ResultVoided
};

struct Notice {
  NoticeId id;
  NoticeKind kind = NoticeKind::Recovered;
  std::string at_utc;
  bool is_for_administrators = false;
  std::string login;  ///< of whom it is about; "" where there is nobody, or nobody to be named
  std::optional<AttemptId> attempt;
  std::int64_t count = 0;
};

/// As it is kept: "result_voided".
std::string_view name_of(NoticeKind kind) noexcept;
std::optional<NoticeKind> notice_kind_from(std::string_view name) noexcept;

}  // namespace hallux::database
