/// Text of a password: never copied, not in the swap file or a core dump, wiped at the end.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

namespace hallux::database {

class SecretText {
 public:
  /// Takes the text and wipes where it came from.
  static SecretText take(std::string& source);

  SecretText(SecretText&& other) noexcept;
  SecretText& operator=(SecretText&& other) noexcept;
  ~SecretText();

  /// Valid as long as this object; copying it defeats the purpose.
  std::string_view view() const noexcept { return {bytes_.get(), size_}; }
  /// Unicode characters, counted in UTF-8.
  std::size_t code_point_count() const noexcept;

 private:
  explicit SecretText(std::string_view text);
  void wipe() noexcept;

  /// Memory of its own pages, locked where the system allows it.
  struct Freed {
    void operator()(char* bytes) const noexcept;
  };
  std::unique_ptr<char, Freed> bytes_;
  std::size_t size_ = 0;
};

}  // namespace hallux::database
