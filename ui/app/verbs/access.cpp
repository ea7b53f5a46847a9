#include "ui/app/verbs/access.h"

#include <termios.h>
#include <unistd.h>

#include <istream>
#include <ostream>
#include <system_error>

namespace hallux::ui {

namespace {

constexpr std::size_t line_bytes = 4096;

/// Keeps the terminal from showing what is typed while it lives.
class SilentTerminal {
 public:
  SilentTerminal() {
    is_silent_ = tcgetattr(STDIN_FILENO, &before_) == 0;
    if (!is_silent_) return;
    termios silent = before_;
    silent.c_lflag &= ~static_cast<tcflag_t>(ECHO);
    tcsetattr(STDIN_FILENO, TCSAFLUSH, &silent);
  }
  ~SilentTerminal() {
    if (is_silent_) tcsetattr(STDIN_FILENO, TCSAFLUSH, &before_);
  }
  SilentTerminal(const SilentTerminal&) = delete;
  SilentTerminal& operator=(const SilentTerminal&) = delete;

 private:
  termios before_{};
  bool is_silent_ = false;
};

database::Database open_or_make(const VerbContext& context) {
  database::OpenOptions options;
  options.backs_up_before_migration = context.backs_up_before_migration;
  return database::Database::open(context.data_directory, options);
}

}  // namespace

bool has_database(const VerbContext& context) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const fs::file_status directory = fs::status(context.data_directory, ignored);
  const fs::file_status file = fs::status(context.data_directory / "hallux.db", ignored);
  // A file where the directory should be is said by the database itself.
  return file.type() != fs::file_type::not_found ||
         (directory.type() != fs::file_type::not_found && !is_directory(directory));
}

database::Database open_kept(const VerbContext& context) {
  if (!has_database(context)) {
    throw VerbError(ExitCode::BadInput,
                    "there is no database in " + context.data_directory.string() +
                        "; `hallux attempt` and `hallux user add` make one, or name another "
                        "directory with --data");
  }
  return open_or_make(context);
}

database::Database open_to_read(const VerbContext& context) {
  try {
    return open_kept(context);
  } catch (const database::DatabaseError& error) {
    const bool is_read_only = error.kind() == database::DatabaseErrorKind::ReadOnly &&
                              ::access(context.data_directory.c_str(), W_OK) != 0 &&
                              ::access((context.data_directory / "hallux.db").c_str(), R_OK) == 0;
    if (!is_read_only || !context.login.empty()) throw;
  }
  context.notes << "the directory cannot be written; it is read as it is\n";
  database::OpenOptions for_reading;
  for_reading.access = database::Access::ReadOnly;
  return database::Database::open(context.data_directory, for_reading);
}

database::Database open_to_record(const VerbContext& context) {
  return context.login.empty() ? open_or_make(context) : open_kept(context);
}

database::SecretText ask_password(const VerbContext& context, const std::string& prompt) {
  const bool is_terminal = isatty(STDIN_FILENO) != 0;
  std::string line;
  line.reserve(line_bytes);  // so that it stays where it is, and nothing is left where it was
  if (is_terminal) {
    context.notes << prompt << ": " << std::flush;
    const SilentTerminal silent;
    std::getline(context.in, line);
    context.notes << "\n";
  } else {
    std::getline(context.in, line);
  }
  if (!context.in && line.empty()) {
    throw VerbError(ExitCode::Refused,
                    prompt + ": none came; type it at a terminal, or send it as a line of stdin");
  }
  if (!line.empty() && line.back() == '\r') line.pop_back();
  return database::SecretText::take(line);
}

database::Session sign_in_as(const VerbContext& context, database::Database& database) {
  if (context.login.empty()) {
    throw VerbError(ExitCode::Refused,
                    "this data directory has people; say who you are with --as LOGIN");
  }
  return database::sign_in(database, context.login,
                           ask_password(context, "Password of " + context.login));
}

AdministratorSession sign_in_administrator(const VerbContext& context, database::Database& database,
                                           std::string_view task) {
  return administrator_in(context, sign_in_as(context, database), task);
}

AdministratorSession administrator_in(const VerbContext& context, database::Session session,
                                      std::string_view task) {
  std::optional<database::AdministratorDesk> desk = session.administrator();
  if (!desk) {
    throw VerbError(
        ExitCode::Refused,
        context.login + " is not an administrator; only administrators " + std::string(task));
  }
  return {std::move(session), *desk};
}

ExitCode at_attempt_desk(const VerbContext& context, database::Database& database,
                         const AttemptAction& wanted, const AttemptWork& work) {
  if (context.login.empty()) {
    database::HouseDesk desk(database);
    return work(desk);
  }
  database::Session session = sign_in_as(context, database);
  std::optional<database::AttemptDesk> desk = session.desk_for(wanted.action, wanted.attempt);
  if (!desk) throw VerbError(ExitCode::Refused, context.login + " has no desk here");
  return work(*desk);
}

}  // namespace hallux::ui
