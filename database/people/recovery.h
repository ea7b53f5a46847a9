/// Recovery of an administrator who forgot the password: the owner of the directory makes a code.
///
/// The owner could alter the file anyhow; this way it is written to the audit, and every
/// administrator is told.
#pragma once

#include <string_view>

#include "database/people/one_time_codes.h"

namespace hallux::database {

/// A one-time code for an administrator. Their old password stays until the code is redeemed.
/// errors  DatabaseError: Refused where this process does not run as the owner of the directory and
///         its file; NotFound naming the login; BadInput where the person is no administrator, or
///         disabled
IssuedCode recover_administrator(Database& database, std::string_view login,
                                 const PasswordCost& cost = {});

}  // namespace hallux::database
