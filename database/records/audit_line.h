/// Lines of the audit as an administrator reads them, with the logins that can still be named.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace hallux::database {

struct AuditLine {
  std::int64_t number = 0;
  std::string at_utc;
  /// Login; "" for nobody and for erased people.
  std::string actor;
  /// "signed_in".
  std::string action;
  /// "attempt".
  std::string subject_kind;
  std::string subject_id;
  /// The login or the cohort's name, where the subject is one that can be named.
  std::string subject;
  bool was_refused = false;
  /// "" where there is none or it was erased.
  std::string text;
};

struct AuditPage {
  /// Newest first.
  std::vector<AuditLine> lines;
  /// Lines that fit what was asked for.
  std::int64_t total = 0;
  /// Ask for lines before this number; nothing: no older ones.
  std::optional<std::int64_t> older;
};

struct AuditRequest {
  /// Nothing: the newest.
  std::optional<std::int64_t> before;
  /// At most 500.
  std::int32_t lines = 50;
  bool refused_only = false;
  /// Only lines by or about people in whose login or name this stands (small and capital letters of
  /// a-z are the same), or whose words hold it; "" for all.
  std::string search = {};
};

}  // namespace hallux::database
