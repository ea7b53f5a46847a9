/// user add, list, passwd, rename, disable, erase, recover. Passwords come from the terminal or as
/// lines of stdin, never from the command line, which others can see: first that of --as, then the
/// new one. In a directory without people the first to be added must be an administrator. A
/// recovery needs the owner of the files instead of a password.
#include "ui/app/verbs/verbs.h"

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>

#include "database/people/recovery.h"
#include "simulator/base/progress.h"
#include "ui/app/terminal/terminal_text.h"
#include "ui/app/verbs/access.h"

namespace hallux::ui {

namespace {

using nlohmann::ordered_json;

struct UserOptions {
  std::string login, display_name;
  bool is_administrator = false;
  bool enable = false;
  bool with_code = false;
  std::string reason;
  bool with_recordings = false;
};

AdministratorSession sign_in_to_manage(const VerbContext& context, database::Database& database) {
  return sign_in_administrator(context, database, "manage people");
}

void say(const VerbContext& context, const std::string& login, const std::string& what) {
  answer(context, {{"login", login}, {"done", what}},
         [&](std::ostream& out) { out << login << ": " << what << "\n"; });
}

/// Whether the first person may be added: nobody signs in to a data directory without people.
bool is_open_house(const VerbContext& context) {
  if (!context.login.empty()) return false;
  if (!has_database(context)) return true;
  database::Database database = open_kept(context);
  return database::OpenHouse::enter(database).has_value();
}

/// The database is made when all is there that the first person needs.
void add_first(const VerbContext& context, const database::NewPerson& person) {
  if (!person.is_administrator) {
    throw VerbError(ExitCode::BadInput,
                    "the first person must be an administrator; add --administrator");
  }
  const database::SecretText password = ask_password(context, "Password for " + person.login);
  database::Database database = open_to_record(context);
  auto house = database::OpenHouse::enter(database);
  if (!house) {
    throw VerbError(ExitCode::Refused,
                    "somebody was added in the meantime; say who you are with --as LOGIN");
  }
  house->add_first_administrator(person, password);
}

ExitCode add_on(const VerbContext& context, const UserOptions& options) {
  const database::NewPerson person{options.login, options.display_name, options.is_administrator};
  if (is_open_house(context)) {
    add_first(context, person);
  } else {
    database::Database database = open_kept(context);
    AdministratorSession administrator = sign_in_to_manage(context, database);
    administrator.desk.add_person(person, ask_password(context, "Password for " + options.login));
  }
  say(context, options.login, "added");
  return ExitCode::Done;
}

ordered_json person_json(const database::Person& person) {
  return {{"login", person.login},
          {"name", person.display_name},
          {"administrator", person.is_administrator},
          {"disabled", person.is_disabled},
          {"created", person.created_utc}};
}

void print_person(std::ostream& out, const database::Person& person) {
  out << person.login << "  " << terminal_text(person.display_name)
      << (person.is_administrator ? "  administrator" : "")
      << (person.is_disabled ? "  disabled" : "") << "\n";
}

ExitCode list_on(const VerbContext& context) {
  database::Database database = open_kept(context);
  std::vector<database::Person> people;
  if (!database::OpenHouse::enter(database))
    people = sign_in_to_manage(context, database).desk.people();
  return answer_with_list(context, people, person_json, print_person);
}

ExitCode redeem_on(const VerbContext& context, const std::string& login) {
  database::Database database = open_kept(context);
  if (login.empty()) {
    throw VerbError(ExitCode::BadInput, "name whose one-time code it is: user passwd LOGIN --code");
  }
  const database::SecretText code = ask_password(context, "One-time code of " + login);
  database::redeem_code(database, login, code, ask_password(context, "New password for " + login));
  say(context, login, "password changed");
  return ExitCode::Done;
}

ExitCode passwd_on(const VerbContext& context, const UserOptions& options) {
  const std::string login = options.login.empty() ? context.login : options.login;
  if (options.with_code) return redeem_on(context, login);
  database::Database database = open_kept(context);
  if (login == context.login || context.login.empty()) {
    VerbContext own = context;
    own.login = login;
    const database::SecretText old_password = ask_password(own, "Password of " + login);
    database::Session session = database::sign_in(database, login, old_password);
    session.change_password(old_password, ask_password(own, "New password for " + login));
  } else {
    AdministratorSession administrator = sign_in_to_manage(context, database);
    administrator.desk.set_password(login, ask_password(context, "New password for " + login));
  }
  say(context, login, "password changed");
  return ExitCode::Done;
}

ExitCode disable_on(const VerbContext& context, const UserOptions& options) {
  database::Database database = open_kept(context);
  AdministratorSession administrator = sign_in_to_manage(context, database);
  administrator.desk.set_disabled(options.login, !options.enable);
  say(context, options.login, options.enable ? "enabled" : "disabled");
  return ExitCode::Done;
}

ExitCode rename_on(const VerbContext& context, const UserOptions& options) {
  database::Database database = open_kept(context);
  AdministratorSession administrator = sign_in_to_manage(context, database);
  administrator.desk.correct_name(options.login, options.display_name);
  say(context, options.login, "renamed");
  return ExitCode::Done;
}

/// The password is asked for once: it signs in, and it proves that it is still the administrator
/// who erases.
ExitCode erase_on(const VerbContext& context, const UserOptions& options) {
  database::Database database = open_kept(context);
  if (context.login.empty()) {
    throw VerbError(ExitCode::Refused,
                    "only administrators erase people; say who you are with --as");
  }
  const database::SecretText password = ask_password(context, "Password of " + context.login);
  AdministratorSession administrator = administrator_in(
      context, database::sign_in(database, context.login, password), "manage people");
  const database::ErasedPieces erased = administrator.desk.erase_person(
      {options.login, options.reason, options.with_recordings},
      administrator.session.prove(password), progress_on(context, "Erasing"));
  answer(context,
         {{"login", options.login},
          {"done", "erased"},
          {"texts", erased.texts},
          {"recordings", erased.recordings},
          {"bytes", erased.recording_bytes},
          {"log_cleared", erased.is_log_cleared}},
         [&](std::ostream& out) { out << options.login << ": erased\n"; });
  if (!erased.is_log_cleared) {
    context.notes << "another program is reading: SQLite's log may hold the name until it ends\n";
  }
  context.notes << "backups from before hold the name until they are let go\n";
  return ExitCode::Done;
}

/// The code goes to stdout, for it is what was asked for; it is shown once.
ExitCode recover_on(const VerbContext& context, const UserOptions& options) {
  if (!context.login.empty()) {
    throw VerbError(ExitCode::Refused,
                    "recovering asks nobody's password: it is for the owner of the data directory; "
                    "leave --as out");
  }
  database::Database database = open_kept(context);
  const database::IssuedCode issued = database::recover_administrator(database, options.login);
  const std::string code{issued.code.view()};
  answer(context, {{"login", options.login}, {"code", code}, {"expires", issued.expires_utc}},
         [&](std::ostream& out) {
           out << code << "\n";
           context.notes << "Choose a password for " << options.login
                         << " with this one-time code before " << issued.expires_utc
                         << ", in the window or by `hallux user passwd " << options.login
                         << " --code`. Every administrator is told.\n";
         });
  return ExitCode::Done;
}

}  // namespace

void add_user_verb(CLI::App& app, VerbContext& context) {
  CLI::App* user = app.add_subcommand("user",
                                      "people and their passwords; a password comes from the "
                                      "terminal, or as a line of stdin: first that "
                                      "of --as, then the new one");
  user->require_subcommand(1);
  auto options = std::make_shared<UserOptions>();
  const auto offer = [&context, options](CLI::App* verb, auto run) {
    choose(*verb, context, [options, &context, run] { return run(context, *options); });
  };

  CLI::App* add =
      user->add_subcommand("add", "add a person; the first one must be an administrator");
  add->add_option("login", options->login, "2 to 64 of a-z 0-9 . _ -, beginning with a letter")
      ->required();
  add->add_option("--name", options->display_name, "the name that is shown");
  add->add_flag("--administrator", options->is_administrator, "may manage people and scenarios");
  offer(add, add_on);

  CLI::App* list = user->add_subcommand("list", "list people");
  offer(list, [](const VerbContext& chosen, const UserOptions&) { return list_on(chosen); });

  CLI::App* passwd =
      user->add_subcommand("passwd", "change your password, or set another person's");
  passwd->add_option("login", options->login, "whose; your own without it");
  passwd->add_flag("--code", options->with_code,
                   "with a one-time code in place of the old password");
  offer(passwd, passwd_on);

  CLI::App* disable =
      user->add_subcommand("disable", "keep a person from signing in; nothing is deleted");
  disable->add_option("login", options->login, "who")->required();
  disable->add_flag("--enable", options->enable, "let the person sign in again");
  offer(disable, disable_on);

  CLI::App* rename = user->add_subcommand(
      "rename", "correct the name that is shown; the person is told, the login stays");
  rename->add_option("login", options->login, "who")->required();
  rename->add_option("--name", options->display_name, "the right name; \"\" shows the login")
      ->required();
  offer(rename, rename_on);

  CLI::App* erase = user->add_subcommand(
      "erase", "take all that names a person away, for good; scores stay as a statistic");
  erase->add_option("login", options->login, "who")->required();
  erase->add_option("--reason", options->reason, "why; kept, and must not name them")->required();
  erase->add_flag("--with-recordings", options->with_recordings, "their recordings as well");
  offer(erase, erase_on);

  CLI::App* recover = user->add_subcommand(
      "recover",
      "a one-time code for an administrator who forgot the password; for the owner of the data "
      "directory, without --as");
  recover->add_option("login", options->login, "which administrator")->required();
  offer(recover, recover_on);
}

}  // namespace hallux::ui
