#include "database/records/notice.h"

#include "database/records/names.h"

namespace hallux::database {

namespace {

constexpr std::array<std::string_view, 8> kind_names{
    "recovered",    "administrator_made", "backup_skipped",    "code_issued",
    "password_set", "sign_ins_refused",   "result_overridden", "result_voided"};

}  // namespace

std::string_view name_of(NoticeKind kind) noexcept { return name_in(kind_names, kind); }

std::optional<NoticeKind> notice_kind_from(std::string_view name) noexcept {
  return named_in<NoticeKind>(kind_names, name);
}

}  // namespace hallux::database
