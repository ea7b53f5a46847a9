#include "database/people/secret_text.h"

#include <sodium.h>

#include <algorithm>
#include <new>
#include <utility>

namespace hallux::database {

SecretText SecretText::take(std::string& source) {
  SecretText secret{source};
  // The whole capacity: a shorter text may have been longer before.
  source.resize(source.capacity());
  sodium_memzero(source.data(), source.size());
  source.clear();
  return secret;
}

namespace {

char* locked_bytes(std::size_t size) {
  // Once for the program; again it does nothing.
  if (sodium_init() < 0) throw std::bad_alloc{};
  auto* bytes = static_cast<char*>(sodium_malloc(size));
  if (bytes == nullptr) throw std::bad_alloc{};
  return bytes;
}

}  // namespace

/// Overwrites before it frees.
void SecretText::Freed::operator()(char* bytes) const noexcept { sodium_free(bytes); }

SecretText::SecretText(std::string_view text)
    : bytes_(locked_bytes(text.size() + 1)), size_(text.size()) {
  std::copy(text.begin(), text.end(), bytes_.get());
}

SecretText::SecretText(SecretText&& other) noexcept
    : bytes_(std::move(other.bytes_)), size_(std::exchange(other.size_, 0)) {}

SecretText& SecretText::operator=(SecretText&& other) noexcept {
  if (this != &other) {
    wipe();
    bytes_ = std::move(other.bytes_);
    size_ = std::exchange(other.size_, 0);
  }
  return *this;
}

SecretText::~SecretText() { wipe(); }

std::size_t SecretText::code_point_count() const noexcept {
  const std::string_view text = view();
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
  }));
}

void SecretText::wipe() noexcept {
  bytes_.reset();
  size_ = 0;
}

}  // namespace hallux::database
