#include "database/people/recovery.h"

#include <sys/stat.h>
#include <unistd.h>

#include "database/audit/audit.h"
#include "database/people/notices.h"
#include "database/people/people.h"
#include "database/store/sql.h"

namespace hallux::database {

namespace {

void check_is_owned(const std::filesystem::path& path) {
  struct stat state {};
  if (stat(path.c_str(), &state) == 0 && state.st_uid == geteuid()) return;
  throw DatabaseError{DatabaseErrorKind::Refused,
                      "only the owner of " + path.string() +
                          " may recover an administrator; run this as the user whom it belongs to"};
}

Person administrator_of(Database& database, std::string_view login) {
  Person person = find_person(database, login);
  if (person.is_administrator && !person.is_disabled) return person;
  throw DatabaseError{DatabaseErrorKind::BadInput,
                      "'" + person.login +
                          "' is not an administrator who may sign in; recover one who is, and let "
                          "them make a code for others"};
}

}  // namespace

IssuedCode recover_administrator(Database& database, std::string_view login,
                                 const PasswordCost& cost) {
  check_is_owned(database.directory());
  check_is_owned(database.file());
  const Person person = administrator_of(database, login);
  return in_transaction(database, "recover an administrator", [&] {
    IssuedCode issued = issue_code(database, person.id, person.id, cost);
    tell_administrators(database, NoticeKind::Recovered, {person.id, {}});
    append_audit(database, {std::nullopt, "administrator_recovered", "person",
                            std::to_string(person.id.number)});
    return issued;
  });
}

}  // namespace hallux::database
