// Passwords at the least price, for a program that is run hundreds of times: loaded before
// libsodium, whose functions these are. What they make is verified as ever, since a hash says what
// it cost.
#include <dlfcn.h>
#include <sodium.h>

namespace {

constexpr unsigned long long passes = crypto_pwhash_OPSLIMIT_MIN;
constexpr std::size_t memory_bytes = crypto_pwhash_MEMLIMIT_MIN;

/// The function of that name in the library itself.
template <typename Function>
Function* library(const char* name) {
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" {

int crypto_pwhash_str(char* out, const char* password, unsigned long long length,
                      unsigned long long /*passes*/, std::size_t /*memory_bytes*/) {
  static auto* const real = library<decltype(crypto_pwhash_str)>("crypto_pwhash_str");
  return real(out, password, length, passes, memory_bytes);
}

int crypto_pwhash_str_needs_rehash(const char* text, unsigned long long /*passes*/,
                                   std::size_t /*memory_bytes*/) {
  static auto* const real =
      library<decltype(crypto_pwhash_str_needs_rehash)>("crypto_pwhash_str_needs_rehash");
  return real(text, passes, memory_bytes);
}

int crypto_pwhash(unsigned char* out, unsigned long long out_length, const char* password,
                  unsigned long long length, const unsigned char* salt,
                  unsigned long long /*passes*/, std::size_t /*memory_bytes*/, int algorithm) {
  static auto* const real = library<decltype(crypto_pwhash)>("crypto_pwhash");
  return real(out, out_length, password, length, salt, passes, memory_bytes, algorithm);
}

}  // extern "C"
