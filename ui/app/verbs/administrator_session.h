/// An administrator who signed in with --as, for verbs that only administrators run.
/// Inside this corner only.
#pragma once

#include <string_view>

#include "database/desks/administrator_desk.h"
#include "ui/app/verbs/access.h"

namespace hallux::ui {

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

}  // namespace hallux::ui
