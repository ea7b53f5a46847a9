// Codes of the audit as people read them. The log keeps codes because its lines are never changed;
// what they are called may be. A code of a later version is shown as it stands: a line that cannot
// be read would be worse than one that reads badly.
#include "ui/screens/administrator/audit_text.h"

#include <algorithm>
#include <array>

#include "database/text/csv_text.h"

namespace hallux::ui {

namespace {

struct Deed {
  std::string_view code, text_id;
};

/// What was done.
constexpr auto deeds = std::to_array<Deed>({
    {"signed_in", "audit.signed_in"},
    {"signed_out", "audit.signed_out"},
    {"code_redeemed", "audit.code_redeemed"},
    {"password_changed", "audit.password_changed"},
    {"first_administrator_added", "audit.first_administrator_added"},
    {"marked_as_simulated", "audit.marked_as_simulated"},
    {"person_added", "audit.person_added"},
    {"code_issued", "audit.code_issued"},
    {"password_reset", "audit.password_reset"},
    {"password_set", "audit.password_set"},
    {"person_disabled", "audit.person_disabled"},
    {"person_enabled", "audit.person_enabled"},
    {"name_corrected", "audit.name_corrected"},
    {"administrator_made", "audit.administrator_made"},
    {"administrator_unmade", "audit.administrator_unmade"},
    {"cohort_added", "audit.cohort_added"},
    {"enrolled_as_trainee", "audit.enrolled_as_trainee"},
    {"enrolled_as_instructor", "audit.enrolled_as_instructor"},
    {"removed_from_cohort", "audit.removed_from_cohort"},
    {"scenario_imported", "audit.scenario_imported"},
    {"scenario_published", "audit.scenario_published"},
    {"scenario_retired", "audit.scenario_retired"},
    {"attempt_begun", "audit.attempt_begun"},
    {"attempt_sealed", "audit.attempt_sealed"},
    {"attempt_abandoned", "audit.attempt_abandoned"},
    {"attempt_viewed", "audit.attempt_viewed"},
    {"score_stored", "audit.score_stored"},
    {"measurements_stored", "audit.measurements_stored"},
    {"note_written", "audit.note_written"},
    {"note_replied", "audit.note_replied"},
    {"help_asked", "audit.help_asked"},
    {"help_answered", "audit.help_answered"},
    {"result_confirmed", "audit.result_confirmed"},
    {"result_overridden", "audit.result_overridden"},
    {"result_voided", "audit.result_voided"},
    {"backup_made", "audit.backup_made"},
    {"password_asked", "audit.password_asked"},
    {"administrator_recovered", "audit.administrator_recovered"},
    {"setting_changed", "audit.setting_changed"},
    {"backup_removed", "audit.backup_removed"},
    {"backup_restored", "audit.backup_restored"},
    {"person_erased", "audit.person_erased"},
    {"recording_erased", "audit.recording_erased"},
    {"person_exported", "audit.person_exported"},
    {"rotation_changed", "audit.rotation_changed"},
    {"retention_changed", "audit.retention_changed"},
    {"retention_applied", "audit.retention_applied"},
    {"report_run", "audit.report_run"},
    {"rows_changed", "audit.rows_changed"},
    {"baseline_taken", "audit.baseline_taken"},
    {"attempt_exported", "audit.attempt_exported"},
    {"attempt_imported", "audit.attempt_imported"},
    {"origin_accepted", "audit.origin_accepted"},
    {"origin_unaccepted", "audit.origin_unaccepted"},
    {"limit_set", "audit.limit_set"},
    {"limit_cleared", "audit.limit_cleared"},
    {"hand_chosen", "audit.hand_chosen"},
});

/// What may be refused: the names of the policy's actions.
constexpr auto tries = std::to_array<Deed>({
    {"begin_attempt", "audit.begin_attempt"},
    {"list_attempts", "audit.list_attempts"},
    {"view_attempt", "audit.view_attempt"},
    {"store_score", "audit.store_score"},
    {"list_operations", "audit.list_operations"},
    {"read_notes", "audit.read_notes"},
    {"read_private_notes", "audit.read_private_notes"},
    {"write_note", "audit.write_note"},
    {"reply_to_note", "audit.reply_to_note"},
    {"ask_for_help", "audit.ask_for_help"},
    {"read_help", "audit.read_help"},
    {"answer_help", "audit.answer_help"},
    {"decide_result", "audit.decide_result"},
    {"see_cohort", "audit.see_cohort"},
    {"change_password", "audit.change_password"},
    {"set_password", "audit.set_password"},
    {"issue_code", "audit.issue_code"},
    {"add_person", "audit.add_person"},
    {"list_people", "audit.list_people"},
    {"disable_person", "audit.disable_person"},
    {"correct_name", "audit.correct_name"},
    {"change_role", "audit.change_role"},
    {"add_cohort", "audit.add_cohort"},
    {"list_cohorts", "audit.list_cohorts"},
    {"enrol", "audit.enrol"},
    {"list_scenarios", "audit.list_scenarios"},
    {"import_scenario", "audit.import_scenario"},
    {"publish_scenario", "audit.publish_scenario"},
    {"retire_scenario", "audit.retire_scenario"},
    {"read_audit", "audit.read_audit"},
    {"back_up", "audit.back_up"},
    {"read_notices", "audit.read_notices"},
    {"change_settings", "audit.change_settings"},
    {"erase_person", "audit.erase_person"},
    {"export_person", "audit.export_person"},
    {"retain", "audit.retain"},
    {"run_report", "audit.run_report"},
    {"list_origins", "audit.list_origins"},
    {"accept_origin", "audit.accept_origin"},
    {"export_attempt", "audit.export_attempt"},
    {"import_attempt", "audit.import_attempt"},
    {"choose_hand", "audit.choose_hand"},
    {"limit_attempts", "audit.limit_attempts"},
    {"compare_with_cohort", "audit.compare_with_cohort"},
});

/// Kinds of subjects that have a number, not a name.
constexpr std::array<Deed, 9> kinds{{
    {"attempt", "audit.kind.attempt"},
    {"attempt_limit", "audit.kind.attempt_limit"},
    {"decision", "audit.kind.decision"},
    {"score", "audit.kind.score"},
    {"measurement_set", "audit.kind.measurement_set"},
    {"note", "audit.kind.note"},
    {"help_request", "audit.kind.help_request"},
    {"session", "audit.kind.session"},
    {"person", "audit.kind.person"},
}};

template <std::size_t count>
std::string_view text_id_in(const std::array<Deed, count>& table, std::string_view code) {
  const auto found =
      std::find_if(table.begin(), table.end(), [&](const Deed& deed) { return deed.code == code; });
  return found == table.end() ? std::string_view() : found->text_id;
}

/// An uuid is told apart by its beginning; a decision's id begins with its number.
std::string short_number(std::string_view id) {
  return std::string(id.substr(0, id.find_first_of("-/")));
}

std::string named_subject(const Texts& texts, const database::AuditLine& line) {
  if (!line.subject.empty()) return line.subject;
  const std::string_view kind = text_id_in(kinds, line.subject_kind);
  if (kind.empty() || line.subject_id.empty()) return {};
  return texts.say(kind, {{"number", short_number(line.subject_id)}});
}

}  // namespace

std::string deed_text(const Texts& texts, const database::AuditLine& line) {
  const std::string_view done = text_id_in(deeds, line.action);
  const std::string_view id = done.empty() ? text_id_in(tries, line.action) : done;
  if (!id.empty()) return std::string(texts.text(id));
  // Written by a version that knows more.
  std::string words = line.action;
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

std::string subject_text(const Texts& texts, const database::AuditLine& line) {
  std::string named = named_subject(texts, line);
  if (line.text.empty()) return named;
  if (named.empty()) return line.text;
  if (line.action == "name_corrected" && !line.was_refused)
    return texts.say("audit.name_before", {{"subject", named}, {"name", line.text}});
  return texts.say("audit.subject_and_text", {{"subject", named}, {"text", line.text}});
}

std::string audit_csv(const Texts& texts, const std::vector<database::AuditLine>& lines) {
  std::string csv = "entry,at_utc,by,code,did,outcome,to\n";
  for (const database::AuditLine& line : lines) {
    csv += std::to_string(line.number) + "," + line.at_utc;
    for (const std::string& cell :
         {line.actor, line.action, deed_text(texts, line),
          std::string(line.was_refused ? "refused" : "done"), subject_text(texts, line)})
      csv += "," + database::csv_cell(cell);
    csv += "\n";
  }
  return csv;
}

std::vector<std::string_view> known_deeds() {
  std::vector<std::string_view> codes;
  codes.reserve(std::size(deeds) + std::size(tries));
  for (const Deed& deed : deeds) codes.push_back(deed.code);
  for (const Deed& tried : tries) codes.push_back(tried.code);
  return codes;
}

}  // namespace hallux::ui
