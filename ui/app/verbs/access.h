/// How a verb gets at what is kept: opens the data directory, signs in where that is asked for,
/// asks for passwords. Inside this corner only.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "database/desks/administrator_desk.h"
#include "database/desks/desks.h"
#include "database/desks/session.h"
#include "database/people/secret_text.h"
#include "database/store/connection.h"
#include "ui/app/verbs/verb.h"

namespace hallux::ui {

/// Whether the data directory holds a database, or something in its place that opening will say.
bool has_database(const VerbContext& context);

/// The database of the data directory, for verbs that need what was kept before: makes nothing in a
/// directory whose name was mistyped. It is opened for writing, since a lost writer's attempt
/// becomes interrupted, and sign-ins and refusals are written to the audit.
/// errors  DatabaseError; VerbError BadInput where there is no database yet
database::Database open_kept(const VerbContext& context);

/// The same for verbs that only read: where the directory cannot be written, and nobody signs in,
/// it is read as it is.
/// errors  as open_kept; DatabaseError ReadOnly where somebody is to be signed in there
database::Database open_to_read(const VerbContext& context);

/// The same for verbs that record: makes the database where there is none, unless somebody signs in
/// with --as; nobody can be known to a database that does not exist.
database::Database open_to_record(const VerbContext& context);

/// Reads one password: from the terminal without showing it, else one line of stdin.
/// errors  VerbError Refused where there is none
database::SecretText ask_password(const VerbContext& context, const std::string& prompt);

/// Signs in as --as.
/// errors  DatabaseError Refused; VerbError Refused without --as
database::Session sign_in_as(const VerbContext& context, database::Database& database);

/// The desk together with the session that it depends on.
struct AdministratorSession {
  database::Session session;
  database::AdministratorDesk desk;
};

/// `task` ends the sentence "only administrators ...".
/// errors  DatabaseError Refused; VerbError Refused without --as, or where who signed in is no
///         administrator
AdministratorSession sign_in_administrator(const VerbContext& context, database::Database& database,
                                           std::string_view task);

/// The same where who signed in is known.
AdministratorSession administrator_in(const VerbContext& context, database::Session session,
                                      std::string_view task);

using AttemptWork = std::function<ExitCode(database::AttemptDesk&)>;

/// What a verb will do, and to which attempt.
struct AttemptAction {
  database::Action action;
  database::AttemptId attempt;
};

/// Runs `work` at the desk from which who signed in with --as may do what is wanted; where none of
/// theirs may, at their own, which refuses (Session::desk_for). Without --as at the house's desk:
/// the robot's attempts.
ExitCode at_attempt_desk(const VerbContext& context, database::Database& database,
                         const AttemptAction& wanted, const AttemptWork& work);

}  // namespace hallux::ui
