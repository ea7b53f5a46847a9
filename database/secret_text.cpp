#include "database/secret_text.h"

#include <sodium.h>

#include <algorithm>
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

SecretText::SecretText(std::string_view text)
    : bytes_(std::make_unique<char[]>(text.size() + 1)), size_(text.size()) {
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
  if (bytes_) sodium_memzero(bytes_.get(), size_);
  bytes_.reset();
  size_ = 0;
}

}  // namespace hallux::database
