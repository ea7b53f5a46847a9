#include "ui/app/verbs/verbs.h"

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

#include "database/audit/anchors.h"
#include "database/maintenance/verify.h"
#include "ui/app/terminal/terminal_text.h"
#include "ui/app/verbs/access.h"
#include "ui/jobs/files/read_small_file.h"

namespace hallux::ui {

namespace {

constexpr std::size_t anchor_mebibytes_max = 16;

database::Database opened_for_reading(const VerbContext& context) {
  database::OpenOptions for_reading;
  for_reading.access = database::Access::ReadOnly;
  return database::Database::open(context.data_directory, for_reading);
}

std::vector<database::Anchor> anchors_of(const std::filesystem::path& file) {
  if (file.empty()) return {};
  return database::anchors_in(
      read_small_file(file, anchor_mebibytes_max, "give a file with a line of `hallux anchor`"));
}

/// The first anchor that the audit does not hold, as damage.
void check_anchors(database::Database& database, const std::vector<database::Anchor>& anchors,
                   database::Verification& found) {
  try {
    for (const database::Anchor& anchor : anchors) database::check_anchor(database, anchor);
  } catch (const database::DatabaseError& error) {
    if (error.kind() != database::DatabaseErrorKind::Damaged) throw;
    found.first_damage = error.what();
  }
}

ExitCode verify_on(const VerbContext& context, const std::filesystem::path& anchor_file) {
  const std::vector<database::Anchor> anchors = anchors_of(anchor_file);
  database::Database database = opened_for_reading(context);
  database::Verification found = verify(database, progress_on(context, "Verifying"));
  if (found.is_whole()) check_anchors(database, anchors, found);
  answer(context,
         {{"whole", found.is_whole()},
          {"first_damage", or_null(found.first_damage)},
          {"attempts", found.attempts},
          {"chunks", found.chunks},
          {"scores", found.scores},
          {"assets", found.assets},
          {"audit_rows", found.audit_rows},
          {"covered_since", or_null(found.covered_since_utc)},
          {"anchors", anchors.size()}},
         [&](std::ostream& out) {
           if (!found.is_whole()) {
             out << "damaged: " << terminal_text(*found.first_damage) << "\n";
             return;
           }
           out << "whole: " << found.attempts << " attempts, " << found.chunks << " chunks, "
               << found.scores << " scores, " << found.assets << " assets, " << found.audit_rows
               << " audit rows; every row covered since " << found.covered_since_utc.value_or("")
               << "; " << anchors.size() << " anchors held\n";
         });
  return found.is_whole() ? ExitCode::Done : ExitCode::CheckFailed;
}

ExitCode anchor_on(const VerbContext& context) {
  database::Database database = opened_for_reading(context);
  const database::Anchor anchor = database::take_anchor(database);
  answer(context,
         {{"anchor", text_of(anchor)},
          {"directory", anchor.directory.text},
          {"acts", anchor.acts},
          {"head", hex_from_digest(anchor.head)},
          {"at", anchor.at_utc}},
         [&](std::ostream& out) { out << text_of(anchor) << "\n"; });
  return ExitCode::Done;
}

}  // namespace

void add_verify_verbs(CLI::App& app, VerbContext& context) {
  auto anchor_file = std::make_shared<std::filesystem::path>();
  CLI::App* verify = app.add_subcommand(
      "verify", "check the file, every hash chain and every row; names the first that was altered");
  verify
      ->add_option("--anchor", *anchor_file,
                   "a file with lines of `hallux anchor` that were kept elsewhere: the audit must "
                   "hold them")
      ->check(fault_in_place);
  choose(*verify, context, [anchor_file, &context] { return verify_on(context, *anchor_file); });

  CLI::App* anchor = app.add_subcommand(
      "anchor",
      "one line about the audit as it is now, to be kept elsewhere for `verify --anchor`");
  choose(*anchor, context, [&context] { return anchor_on(context); });
}

}  // namespace hallux::ui
