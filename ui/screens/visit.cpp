#include "ui/screens/visit.h"

#include "database/people.h"
#include "simulator/base/check.h"

namespace hallux::ui {

bool is_without_people(const std::filesystem::path& data_directory) {
  database::Database opened = database::Database::open(data_directory);
  return !database::has_people(opened);
}

std::unique_ptr<Visit> sign_in(const std::filesystem::path& data_directory, const EntryWords& words,
                               const database::PasswordCost& cost) {
  CHECK(words.password.has_value());
  auto visit = std::make_unique<Visit>(database::Database::open(data_directory));
  visit->session = database::sign_in(visit->database, words.login, *words.password, cost);
  return visit;
}

std::unique_ptr<Visit> begin_course(const std::filesystem::path& data_directory,
                                    const EntryWords& words, const database::PasswordCost& cost) {
  CHECK(words.password.has_value());
  auto visit = std::make_unique<Visit>(database::Database::open(data_directory));
  std::optional<database::OpenHouse> house = database::OpenHouse::enter(visit->database);
  if (!house) {
    throw database::DatabaseError(database::DatabaseErrorKind::Refused,
                                  "somebody was added in the meantime; sign in instead");
  }
  house->add_first_administrator({words.login, words.display_name, true}, *words.password, cost);
  visit->session = database::sign_in(visit->database, words.login, *words.password, cost);
  return visit;
}

std::unique_ptr<Visit> redeem(const std::filesystem::path& data_directory, const EntryWords& words,
                              const database::PasswordCost& cost) {
  CHECK(words.password.has_value() && words.code.has_value());
  auto visit = std::make_unique<Visit>(database::Database::open(data_directory));
  visit->session =
      database::redeem_code(visit->database, words.login, *words.code, *words.password, cost);
  return visit;
}

}  // namespace hallux::ui
