/// Coming in: a data directory is opened, and somebody signs in to it. Each of these takes a while (a file may be migrated,
/// a password is hashed) and runs beside the window.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "database/session.h"

namespace hallux::ui {

/// A person who is signed in, on a connection of their own.
struct Visit {
  explicit Visit(database::Database opened) : database(std::move(opened)) {}
  Visit(const Visit&) = delete;
  Visit& operator=(const Visit&) = delete;

  database::Database database;
  std::optional<database::Session> session;  ///< has a value once somebody came in
};

/// Whether nobody can sign in yet, so that the first administrator is asked for. Creates what is missing.
/// errors  DatabaseError
bool is_without_people(const std::filesystem::path& data_directory);

/// What a person wrote to come in. The secrets are wiped when it goes.
struct EntryWords {
  std::string login, display_name;
  std::optional<database::SecretText> code;  ///< a one-time code
  std::optional<database::SecretText> password;
};

/// errors  DatabaseError: Refused, BadInput, and as database/session.h
/// thread  any, on which the visit is not used meanwhile
std::unique_ptr<Visit> sign_in(const std::filesystem::path& data_directory, const EntryWords& words,
                               const database::PasswordCost& cost = {});
/// Makes the first administrator and signs them in.
std::unique_ptr<Visit> begin_course(const std::filesystem::path& data_directory,
                                    const EntryWords& words,
                                    const database::PasswordCost& cost = {});
/// Chooses a password with a one-time code, and signs in.
std::unique_ptr<Visit> redeem(const std::filesystem::path& data_directory, const EntryWords& words,
                              const database::PasswordCost& cost = {});

}  // namespace hallux::ui
