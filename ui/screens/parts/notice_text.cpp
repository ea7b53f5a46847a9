#include "ui/screens/parts/notice_text.h"

namespace hallux::ui {

std::string notice_text(const Texts& texts, const database::Notice& notice) {
  using database::NoticeKind;
  const TextValues who{
      {"login", notice.login.empty() ? std::string(texts.text("notice.somebody")) : notice.login}};
  switch (notice.kind) {
    case NoticeKind::Recovered:
      return texts.say("notice.recovered", who);
    case NoticeKind::AdministratorMade:
      return texts.say("notice.administrator_made", who);
    case NoticeKind::BackupSkipped:
      return std::string(texts.text("notice.backup_skipped"));
    case NoticeKind::CodeIssued:
      return texts.say("notice.code_issued", who);
    case NoticeKind::PasswordSet:
      return texts.say("notice.password_set", who);
    case NoticeKind::SignInsRefused:
      return texts.say_count("notice.sign_ins_refused", static_cast<long>(notice.count));
    case NoticeKind::ResultOverridden:
      return std::string(texts.text("notice.result_overridden"));
    case NoticeKind::ResultVoided:
      return std::string(texts.text("notice.result_voided"));
  }
  return {};
}

}  // namespace hallux::ui
