/// backup, restore, retention. In a directory without people whoever owns it keeps it, else an
/// administrator at a desk that asks the policy table: the templates take either, so that both do
/// the same. Restoring makes a new directory, where nobody is yet, and so takes no --as.
#include "ui/app/verbs/verbs.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>

#include "database/maintenance/restore.h"
#include "simulator/base/progress.h"
#include "ui/app/terminal/terminal_text.h"
#include "ui/app/verbs/access.h"

namespace hallux::ui {

namespace {

using nlohmann::ordered_json;

/// Runs `work` at the desk of the administrator of --as, or in a directory without people at no
/// desk.
template <typename Work>
ExitCode keeping(const VerbContext& context, const char* task, Work&& work) {
  database::Database database = open_kept(context);
  if (context.login.empty()) {
    if (auto open = database::OpenHouse::enter(database)) return work(*open);
  }
  AdministratorSession administrator = sign_in_administrator(context, database, task);
  return work(administrator.desk);
}

ordered_json backup_json(const database::Backup& backup) {
  return {{"backup", backup.file.string()},
          {"made", backup.made_utc},
          {"bytes", backup.bytes},
          {"recordings", backup.recordings},
          {"damaged", backup.damaged}};
}

void print_backup(std::ostream& out, const database::Backup& backup) {
  out << terminal_text(backup.file.string()) << "  " << backup.bytes << " bytes  "
      << backup.recordings << " recordings\n";
}

template <typename Desk>
ExitCode back_up_on(const VerbContext& context, Desk& desk, const std::filesystem::path& folder) {
  const std::filesystem::path place =
      folder.empty() ? folder : std::filesystem::absolute(folder).lexically_normal();
  const database::Backup backup = desk.back_up(place, progress_on(context, "Backing up"));
  ordered_json row = backup_json(backup);
  row["new_bytes"] = backup.new_bytes;
  row["anchor"] = backup.anchor;
  answer(context, row, [&](std::ostream& out) {
    print_backup(out, backup);
    out << backup.anchor << "\n";
  });
  if (backup.damaged == 0) return ExitCode::Done;
  context.notes << backup.damaged
                << " attempts were altered before this backup; `hallux verify` names the first\n";
  return ExitCode::CheckFailed;
}

ordered_json json_of(const database::Restored& restored) {
  return {
      {"backup", restored.backup.string()},     {"made", restored.made_utc},
      {"attempts", restored.attempts},          {"recordings", restored.recordings},
      {"erased_again", restored.erased_people}, {"first_damage", or_null(restored.first_damage)}};
}

ExitCode restore_on(const VerbContext& context, database::RestoreOrder order) {
  if (!context.login.empty()) {
    throw VerbError(ExitCode::Refused,
                    "restoring makes a new directory, where nobody is yet; leave --as out");
  }
  order.directory = context.data_directory;
  const database::Restored restored = database::restore(order, progress_on(context, "Restoring"));
  answer(context, json_of(restored), [&](std::ostream& out) {
    out << "restored " << terminal_text(restored.backup.string()) << " of "
        << terminal_text(restored.made_utc) << ": " << restored.attempts << " attempts, "
        << restored.erased_people << " people erased once more\n";
    if (restored.first_damage) {
      out << "damaged: " << terminal_text(*restored.first_damage) << "\n";
    }
  });
  return restored.first_damage ? ExitCode::CheckFailed : ExitCode::Done;
}

struct RetentionOptions {
  bool is_dry_run = false;
  std::string practice, assessment, account, cache;  ///< days, "ever", or "" where it stays
  bool changes_rules() const {
    return !practice.empty() || !assessment.empty() || !account.empty() || !cache.empty();
  }
};

void change(std::optional<std::int32_t>& days, const std::string& text) {
  if (text.empty()) return;
  days.reset();
  if (text != "ever") days = std::stoi(text);
}

/// A number of days or "ever".
std::string fault_in_days(const std::string& text) {
  const bool is_number = !text.empty() && text.size() <= 5 &&
                         text.find_first_not_of("0123456789") == std::string::npos;
  return is_number || text == "ever" ? "" : "must be a number of days, or ever";
}

ordered_json json_of(const database::RetentionRules& rules) {
  return {{"practice_days", or_null(rules.practice_days)},
          {"assessment_days", or_null(rules.assessment_days)},
          {"account_days", or_null(rules.account_days)},
          {"cache_days", or_null(rules.cache_days)}};
}

void print_plan(const VerbContext& context, const database::RetentionRules& rules,
                const std::vector<database::RetentionPiece>& pieces) {
  ordered_json rows = ordered_json::array();
  std::int64_t bytes = 0;
  for (const database::RetentionPiece& piece : pieces) {
    bytes += piece.bytes;
    rows.push_back({{"kind", database::name_of(piece.kind)},
                    {"name", piece.name},
                    {"person", piece.login.empty() ? ordered_json() : ordered_json(piece.login)},
                    {"since", piece.since_utc},
                    {"bytes", piece.bytes}});
    if (context.json) continue;
    context.out << database::name_of(piece.kind) << "  " << terminal_text(piece.name) << "  "
                << terminal_text(piece.login) << "  " << terminal_text(piece.since_utc) << "  "
                << piece.bytes << " bytes\n";
  }
  answer(context, {{"rules", json_of(rules)}, {"pieces", rows}, {"bytes", bytes}},
         [&](std::ostream& out) {
           out << pieces.size() << " pieces, " << bytes << " bytes would go\n";
         });
}

template <typename Desk>
ExitCode retain_on(const VerbContext& context, Desk& desk, const RetentionOptions& options) {
  if (options.changes_rules()) {
    database::RetentionRules rules = desk.retention();
    change(rules.practice_days, options.practice);
    change(rules.assessment_days, options.assessment);
    change(rules.account_days, options.account);
    change(rules.cache_days, options.cache);
    desk.set_retention(rules);
  }
  if (options.is_dry_run || options.changes_rules()) {
    print_plan(context, desk.retention(), desk.retention_plan());
    return ExitCode::Done;
  }
  const database::RetentionDone done = desk.retain(progress_on(context, "Letting go"));
  answer(context,
         {{"recordings", done.recordings},
          {"accounts", done.accounts},
          {"cached", done.cached},
          {"bytes", done.bytes}},
         [&](std::ostream& out) {
           out << done.recordings << " recordings, " << done.accounts << " accounts, "
               << done.cached << " cached files, " << done.bytes << " bytes went\n";
         });
  return ExitCode::Done;
}

}  // namespace

void add_backup_verb(CLI::App& app, VerbContext& context) {
  struct Options {
    std::filesystem::path folder;
    bool is_list = false;
  };
  auto options = std::make_shared<Options>();
  CLI::App* backup = app.add_subcommand(
      "backup", "copy all that is kept, also while it is used; recordings are written once");
  backup->add_option("--to", options->folder, "folder of backups; without it DIR/backups")
      ->check(fault_in_place);
  backup->add_flag("--list", options->is_list, "list the backups in DIR/backups instead");
  choose(*backup, context, [options, &context] {
    return keeping(context, "back up", [&](auto& desk) {
      if (!options->is_list) return back_up_on(context, desk, options->folder);
      return answer_with_list(context, desk.backups(), backup_json, print_backup);
    });
  });
}

void add_restore_verb(CLI::App& app, VerbContext& context) {
  auto order = std::make_shared<database::RestoreOrder>();
  CLI::App* restore = app.add_subcommand(
      "restore", "make the data directory from a backup; it must be new or empty");
  restore
      ->add_option("backup", order->backup,
                   "a manifest (.json), a whole database (.db), or a folder: its newest backup")
      ->required();
  restore->add_option("--erasures", order->journal,
                      "a newer journal of erasures than the one beside the backup");
  restore->add_flag("--even-damaged", order->even_damaged,
                    "give back what is whole although a recording or a row is not");
  choose(*restore, context, [order, &context] { return restore_on(context, *order); });
}

void add_retention_verb(CLI::App& app, VerbContext& context) {
  auto options = std::make_shared<RetentionOptions>();
  CLI::App* retention = app.add_subcommand(
      "retention", "let go of what need not be kept any longer; nothing goes until days were set");
  retention->add_flag("--dry-run", options->is_dry_run, "only say what would go");
  const auto add = [&](const char* name, std::string& days, const char* what) {
    retention->add_option(name, days, what)->check(fault_in_days);
  };
  add("--practice-days", options->practice, "keep recordings of practices so long, or ever");
  add("--assessment-days", options->assessment, "of assessments, from the last decision");
  add("--account-days", options->account, "keep disabled accounts so long, or ever");
  add("--cache-days", options->cache, "keep what can be made again so long, or ever");
  choose(*retention, context, [options, &context] {
    return keeping(context, "decide what is kept",
                   [&](auto& desk) { return retain_on(context, desk, *options); });
  });
}

}  // namespace hallux::ui
