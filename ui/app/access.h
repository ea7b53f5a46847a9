/// How a verb gets at what is kept: opens the data directory, signs in where that is asked for, asks for passwords.
#pragma once

#include <functional>
#include <string>

#include "database/connection.h"
#include "database/desks.h"
#include "database/secret_text.h"
#include "database/session.h"
#include "ui/app/verb.h"

namespace hallux::ui {

/// The database of the data directory.
/// errors  DatabaseError; NotFound with the mend where it is opened for reading and there is none yet
database::Database open_data(const VerbContext& context, database::Access access);

/// Whether the data directory holds a database, or something in its place that opening will say.
bool has_database(const VerbContext& context);

/// The same for verbs that need what was kept before: makes nothing in a directory whose name was mistyped. It is opened for
/// writing, since a lost writer's attempt becomes interrupted, and sign-ins and refusals are written to the audit.
/// errors  DatabaseError; NotFound where there is no database yet
database::Database open_kept(const VerbContext& context);

/// Reads one password: from the terminal without showing it, else one line of stdin.
/// errors  DatabaseError Refused where there is none
database::SecretText ask_password(const VerbContext& context, const std::string& prompt);

/// Signs in as --as.
/// errors  DatabaseError Refused
database::Session sign_in_as(const VerbContext& context, database::Database& database);

/// Runs `work` at the desk of whoever signed in with --as, or at the house's desk (the robot's attempts) without it.
ExitCode at_attempt_desk(const VerbContext& context, database::Database& database,
                         const std::function<ExitCode(database::AttemptDesk&)>& work);

}  // namespace hallux::ui
