#include "database/records/person.h"

namespace hallux::database {

namespace {

constexpr std::size_t shortest = 2, longest = 64;
constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyz";
constexpr std::string_view allowed = "abcdefghijklmnopqrstuvwxyz0123456789._-";

}  // namespace

bool may_become_login(std::string_view typed) noexcept {
  if (typed.empty()) return true;
  return typed.size() <= longest && letters.find(typed.front()) != std::string_view::npos &&
         typed.find_first_not_of(allowed) == std::string_view::npos;
}

bool is_login(std::string_view login) noexcept {
  return login.size() >= shortest && may_become_login(login);
}

}  // namespace hallux::database
