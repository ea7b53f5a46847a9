#include "ui/screens/parts/course_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <ctime>
#include <iterator>
#include <utility>

#include "ui/screens/parts/value_text.h"
#include "ui/times/local_time.h"

namespace hallux::ui {

namespace {

constexpr int days_shown = 31;

char small(char letter) noexcept {
  return static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
}

}  // namespace

std::string utc_now_text() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm fields{};
  gmtime_r(&now, &fields);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &fields);
  return text.data();
}

std::string ago_text(const Texts& texts, std::string_view utc, std::string_view now_utc) {
  if (utc.empty()) return std::string(texts.text("ago.never"));
  const int days = days_between(utc, now_utc);
  if (days <= 0) return std::string(texts.text("ago.today"));
  if (days == 1) return std::string(texts.text("ago.yesterday"));
  if (days <= days_shown) return texts.say_count("ago.days", days);
  return date_text(utc);
}

std::string operation_text(std::string_view scenario_name) {
  std::string name(scenario_name);
  std::replace(name.begin(), name.end(), '_', ' ');
  if (!name.empty())
    name.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(name.front())));
  return name;
}

std::string attempt_name(const Texts& texts, const database::AttemptHeader& attempt) {
  return texts.say("attempts.row", {{"operation", operation_text(attempt.scenario_name)},
                                    {"moment", moment_text(attempt.started_utc)}});
}

std::string notice_text(const Texts& texts, const database::Notice& notice) {
  using database::NoticeKind;
  if (notice.kind == NoticeKind::SignInsRefused)
    return texts.say_count("notice.sign_ins_refused", static_cast<long>(notice.count));
  constexpr std::pair<NoticeKind, const char*> ids[] = {
      {NoticeKind::Recovered, "notice.recovered"},
      {NoticeKind::AdministratorMade, "notice.administrator_made"},
      {NoticeKind::BackupSkipped, "notice.backup_skipped"},
      {NoticeKind::CodeIssued, "notice.code_issued"},
      {NoticeKind::PasswordSet, "notice.password_set"},
      {NoticeKind::NameCorrected, "notice.name_corrected"},
      {NoticeKind::ResultOverridden, "notice.result_overridden"},
      {NoticeKind::ResultVoided, "notice.result_voided"}};
  const auto* const found =
      std::ranges::find(ids, notice.kind, &std::pair<NoticeKind, const char*>::first);
  const std::string who =
      notice.login.empty() ? std::string(texts.text("notice.somebody")) : notice.login;
  return found == std::end(ids) ? std::string() : texts.say(found->second, {{"login", who}});
}

std::string shown_name_of(std::string_view login, std::string_view display_name) {
  return std::string(display_name.empty() ? login : display_name);
}

std::string person_name_of(const Texts& texts, std::string_view login,
                           std::string_view display_name) {
  const std::string name = shown_name_of(login, display_name);
  return name.empty() ? std::string(texts.text("notes.nobody")) : name;
}

bool contains_text(std::string_view words, std::string_view part) {
  return std::search(words.begin(), words.end(), part.begin(), part.end(),
                     [](char a, char b) { return small(a) == small(b); }) != words.end() ||
         part.empty();
}

}  // namespace hallux::ui
