#include "database/people/passwords.h"

#include <sodium.h>

#include <algorithm>
#include <array>
#include <new>
#include <string_view>

#include "database/store/database_error.h"

namespace hallux::database {

namespace {

/// Twelve characters or more, because shorter ones are refused anyway.
// clang-format off
constexpr std::array<std::string_view, 78> common_passwords{
    "123456789012", "1234567890123", "012345678901", "987654321098", "password1234",
    "passwordpassword", "password12345", "passwort1234", "passwortpasswort", "qwertyuiop12",
    "qwertyuiop123", "qwertyuiopasdf", "qwertyuiopas", "qwertzuiop12", "1q2w3e4r5t6y",
    "1qaz2wsx3edc", "abcdefghijkl", "abcdefghijklm", "administrator", "administrator1",
    "letmeinletmein", "iloveyou1234", "welcome12345", "trustno1trustno1", "changemechangeme",
    "correcthorsebatterystaple", "correct horse battery staple", "correct-horse-battery-staple",
    "123123123123", "121212121212", "112233445566", "111222333444", "123456123456",
    "abc123abc123", "abcd1234abcd", "abcdefgh1234", "password2024", "password2025",
    "password2026", "password!234", "password123!", "adminadmin12", "adminadminadmin",
    "administrator123", "administrateur", "letmein12345", "letmeinplease", "welcomewelcome",
    "willkommen123", "iloveyouiloveyou", "sunshine1234", "footballfootball", "qwertyqwerty",
    "qwerty123456", "asdfghjkl123", "asdfasdfasdf", "zxcvbnm12345", "zaq12wsxcde3",
    "secretsecret", "geheimgeheim", "passphrase12", "thisismypassword", "mypassword12",
    "newpassword1", "changeme1234", "default12345", "testtesttest", "trainee12345",
    "instructor12", "hallux valgus", "halluxvalgus", "halluxhallux", "osteotomy123",
    "podiatry1234", "orthopaedics", "footsurgery1", "student12345", "university12"};
// clang-format on

[[noreturn]] void refuse(const std::string& sentence) {
  throw DatabaseError{DatabaseErrorKind::BadInput, sentence};
}

constexpr char lower_case(char letter) noexcept {
  return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}

bool is_same_but_for_case(std::string_view a, std::string_view b) noexcept {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return lower_case(x) == lower_case(y); });
}

/// The login once, or again and again.
bool is_only(std::string_view text, std::string_view login) noexcept {
  if (login.empty() || text.size() % login.size() != 0) return false;
  for (std::size_t place = 0; place < text.size(); place += login.size()) {
    if (!is_same_but_for_case(text.substr(place, login.size()), login)) return false;
  }
  return true;
}

}  // namespace

void check_password_rules(const SecretText& password, std::string_view login) {
  const std::size_t count = password.code_point_count();
  if (count < password_code_points_min) {
    refuse("the password has " + std::to_string(count) + " characters; it must have at least 12");
  }
  if (count > password_code_points_max) {
    refuse("the password has " + std::to_string(count) + " characters; it may have at most 128");
  }
  const std::string_view text = password.view();
  if (text.find_first_not_of(text.front()) == std::string_view::npos) {
    refuse("the password is one character repeated; choose another");
  }
  const bool is_common =
      std::any_of(common_passwords.begin(), common_passwords.end(),
                  [text](std::string_view common) { return is_same_but_for_case(text, common); });
  if (is_common) refuse("the password is one that everybody tries first; choose another");
  if (is_only(text, login)) refuse("the password is the login; choose another");
}

std::string hash_password(const SecretText& password, const PasswordCost& cost) {
  std::array<char, crypto_pwhash_STRBYTES> text{};
  const std::string_view secret = password.view();
  // Fails only where the memory cannot be had.
  if (crypto_pwhash_str(text.data(), secret.data(), secret.size(), cost.passes,
                        cost.memory_bytes) != 0) {
    throw std::bad_alloc{};
  }
  return text.data();
}

bool is_password(const std::string& argon2id, const SecretText& password) noexcept {
  const std::string_view secret = password.view();
  return crypto_pwhash_str_verify(argon2id.c_str(), secret.data(), secret.size()) == 0;
}

bool needs_rehash(const std::string& argon2id, const PasswordCost& cost) noexcept {
  return crypto_pwhash_str_needs_rehash(argon2id.c_str(), cost.passes, cost.memory_bytes) != 0;
}

void spend_same_work(const SecretText& password, const PasswordCost& cost) noexcept {
  std::array<unsigned char, 32> unused{};
  constexpr std::array<unsigned char, crypto_pwhash_SALTBYTES> salt{};
  const std::string_view secret = password.view();
  [[maybe_unused]] const int ignored =
      crypto_pwhash(unused.data(), unused.size(), secret.data(), secret.size(), salt.data(),
                    cost.passes, cost.memory_bytes, crypto_pwhash_ALG_ARGON2ID13);
}

}  // namespace hallux::database
