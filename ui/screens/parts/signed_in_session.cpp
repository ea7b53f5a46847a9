#include "ui/screens/parts/signed_in_session.h"

#include <algorithm>
#include <utility>

#include "database/course/simulated_course.h"
#include "database/people/people.h"
#include "database/store/settings.h"
#include "simulator/base/check.h"
#include "ui/jobs/course/course_jobs.h"

namespace hallux::ui {

namespace {

/// Of somebody who may not sit at any desk: the usual.
database::HandSettings hand_settings_of(database::Session& session) {
  std::optional<database::TraineeDesk> desk = session.trainee();
  return desk ? desk->hand_settings() : database::HandSettings{};
}

}  // namespace

SignedInSession::SignedInSession(
    database::Database opened, const std::function<database::Session(database::Database&)>& come_in)
    : database_(std::move(opened)),
      session_(come_in(database_)),
      person_(session_.person()),
      memberships_(session_.memberships()),
      notices_(session_.notices()),
      hand_settings_(hand_settings_of(session_)),
      idle_lock_s_(60.0 * database::read_idle_lock_min(database_)),
      is_simulated_(database::is_simulated_course(database_)) {}

SignedInSession::~SignedInSession() {
  try {
    session_.sign_out();
  } catch (const std::exception&) {
    // The disk is gone or full: the session stays open in what is kept, which grants nothing.
  }
}

std::vector<database::Membership> SignedInSession::taught() const {
  std::vector<database::Membership> taught;
  std::copy_if(memberships_.begin(), memberships_.end(), std::back_inserter(taught),
               [](const auto& each) { return each.role == database::CohortRole::Instructor; });
  return taught;
}

bool is_without_people(const std::filesystem::path& data_directory) {
  database::Database opened = database::Database::open(data_directory);
  return !database::has_people(opened);
}

std::shared_ptr<SignedInSession> sign_in(const std::filesystem::path& data_directory,
                                         const SignInForm& words,
                                         const database::PasswordCost& cost) {
  CHECK(words.password.has_value());
  return std::make_shared<SignedInSession>(
      database::Database::open(data_directory), [&](database::Database& database) {
        return database::sign_in(database, words.login, *words.password, cost);
      });
}

namespace {

database::Session make_first_administrator(database::Database& database, const SignInForm& words,
                                           const database::PasswordCost& cost) {
  std::optional<database::OpenHouse> house = database::OpenHouse::enter(database);
  if (!house) {
    throw database::DatabaseError(database::DatabaseErrorKind::Refused,
                                  "somebody was added in the meantime; sign in instead");
  }
  house->add_first_administrator({words.login, words.display_name, true}, *words.password, cost);
  database::Session session = database::sign_in(database, words.login, *words.password, cost);
  // A course without operations would be an empty room.
  std::optional<database::AdministratorDesk> desk = session.administrator();
  CHECK(desk.has_value());
  publish_shipped_scenarios(*desk);
  return session;
}

}  // namespace

std::shared_ptr<SignedInSession> begin_course(const std::filesystem::path& data_directory,
                                              const SignInForm& words,
                                              const database::PasswordCost& cost) {
  CHECK(words.password.has_value());
  return std::make_shared<SignedInSession>(database::Database::open(data_directory),
                                           [&](database::Database& database) {
                                             return make_first_administrator(database, words, cost);
                                           });
}

std::shared_ptr<SignedInSession> redeem(const std::filesystem::path& data_directory,
                                        const SignInForm& words,
                                        const database::PasswordCost& cost) {
  CHECK(words.password.has_value() && words.code.has_value());
  return std::make_shared<SignedInSession>(
      database::Database::open(data_directory), [&](database::Database& database) {
        return database::redeem_code(database, words.login, *words.code, *words.password, cost);
      });
}

}  // namespace hallux::ui
