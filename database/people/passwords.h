/// Password rules and Argon2id hashes.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "database/people/secret_text.h"

namespace hallux::database {

/// The cost of one Argon2id hash: 64 MiB and three passes, 67 ms measured. Tests take less.
struct PasswordCost {
  unsigned long long passes = 3;
  std::size_t memory_bytes = 64ULL << 20U;
};

inline constexpr std::size_t password_code_points_min = 12;
inline constexpr std::size_t password_code_points_max = 128;

/// errors  DatabaseError BadInput: shorter than 12 or longer than 128 characters, one character
///         repeated, one of the passwords that everybody tries first, or nothing but the login
void check_password_rules(const SecretText& password, std::string_view login = {});

/// The Argon2id text of libsodium, with its own salt and cost inside.
std::string hash_password(const SecretText& password, const PasswordCost& cost);

/// Whether `argon2id` was made from this password.
bool is_password(const std::string& argon2id, const SecretText& password) noexcept;
/// Whether `argon2id` was made at another cost than this.
bool needs_rehash(const std::string& argon2id, const PasswordCost& cost) noexcept;

/// The work of is_password for a name that does not exist, so that the time tells nothing.
void spend_same_work(const SecretText& password, const PasswordCost& cost) noexcept;

}  // namespace hallux::database
