/// Coming in: a data directory is opened, and somebody signs in to it. Each of these takes a while
/// (a file may be migrated, a password is hashed) and runs beside the window.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "database/desks/session.h"

namespace hallux::ui {

/// A person who is signed in, on a connection of their own. Shared by the screens and by the work
/// they start, so that work which outlives its screen, or the session's end, still has it.
class SignedInSession {
 public:
  /// needs   opens signs in to the database it is given
  SignedInSession(database::Database opened,
                  const std::function<database::Session(database::Database&)>& come_in);
  /// Ends the session in what is kept, too.
  ~SignedInSession();
  SignedInSession(const SignedInSession&) = delete;
  SignedInSession& operator=(const SignedInSession&) = delete;

  // As they were at the sign-in.
  const database::Person& person() const noexcept { return person_; }
  const std::vector<database::Membership>& memberships() const noexcept { return memberships_; }
  const std::vector<database::Notice>& notices() const noexcept { return notices_; }
  const database::HandSettings& hand_settings() const noexcept { return hand_settings_; }
  double idle_lock_s() const noexcept { return idle_lock_s_; }
  /// The course, with all in it.
  bool is_simulated() const noexcept { return is_simulated_; }
  /// The cohorts that the person teaches.
  std::vector<database::Membership> taught() const;

  /// Uses the connection while nobody else does: `use(session, database)`. Waits for its turn, so
  /// not in a frame, and keeps others waiting, so for reading and writing only.
  template <typename Use>
  auto in_turn(Use&& use) {
    const std::scoped_lock turn(turn_);
    return use(session_, database_);
  }

 private:
  std::mutex turn_;
  database::Database database_;
  database::Session session_;
  database::Person person_;
  std::vector<database::Membership> memberships_;
  std::vector<database::Notice> notices_;
  database::HandSettings hand_settings_;
  double idle_lock_s_ = 0.0;
  bool is_simulated_ = false;
};

/// Whether nobody can sign in yet, so that the first administrator is asked for. Creates what is
/// missing.
/// errors  DatabaseError
bool is_without_people(const std::filesystem::path& data_directory);

/// What a person wrote to come in. The secrets are wiped when it goes.
struct SignInForm {
  std::string login, display_name;
  /// A one-time code.
  std::optional<database::SecretText> code;
  std::optional<database::SecretText> password;
};

/// errors  DatabaseError: Refused, BadInput, and as database/desks/session.h
/// thread  any
std::shared_ptr<SignedInSession> sign_in(const std::filesystem::path& data_directory,
                                         const SignInForm& words,
                                         const database::PasswordCost& cost = {});
/// Makes the first administrator and signs them in.
std::shared_ptr<SignedInSession> begin_course(const std::filesystem::path& data_directory,
                                              const SignInForm& words,
                                              const database::PasswordCost& cost = {});
/// Chooses a password with a one-time code, and signs in.
std::shared_ptr<SignedInSession> redeem(const std::filesystem::path& data_directory,
                                        const SignInForm& words,
                                        const database::PasswordCost& cost = {});

}  // namespace hallux::ui
