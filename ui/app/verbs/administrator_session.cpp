#include "ui/app/verbs/administrator_session.h"

#include <optional>
#include <string>

#include "ui/app/verbs/verb_error.h"

namespace hallux::ui {

AdministratorSession sign_in_administrator(const VerbContext& context, database::Database& database,
                                           std::string_view task) {
  database::Session session = sign_in_as(context, database);
  std::optional<database::AdministratorDesk> desk = session.administrator();
  if (!desk) {
    throw VerbError(
        ExitCode::Refused,
        context.login + " is not an administrator; only administrators " + std::string(task));
  }
  return {std::move(session), *desk};
}

}  // namespace hallux::ui
