/// The audit as an administrator reads it: rows with the logins that can still be named.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace hallux::database {

struct AuditLine {
  std::int64_t number = 0;
  std::string at_utc;
  std::string actor;         ///< login; "" for nobody and for erased people
  std::string action;        ///< "signed_in"
  std::string subject_kind;  ///< "attempt"
  std::string subject_id;
  std::string
      subject;  ///< the login or the cohort's name, where the subject is one that can be named
  bool was_refused = false;
  std::string text;  ///< "" where there is none or it was erased
};

struct AuditPage {
  std::vector<AuditLine> lines;       ///< newest first
  std::int64_t total = 0;             ///< lines that fit what was asked for
  std::optional<std::int64_t> older;  ///< ask for lines before this number; nothing: no older ones
};

struct AuditRequest {
  std::optional<std::int64_t> before;  ///< nothing: the newest
  std::int32_t lines = 50;             ///< at most 500
  bool refused_only = false;
};

}  // namespace hallux::database
