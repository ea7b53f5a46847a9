#include "ui/widgets/texts/wipe.h"

namespace hallux::ui {

void wipe(std::string& text) noexcept {
  text.resize(text.capacity());
  // Volatile: a compiler may leave out what is overwritten and never read.
  volatile char* bytes = text.data();
  for (std::size_t i = 0; i < text.size(); ++i) bytes[i] = '\0';
  text.clear();
}

void make_room_for_secret(std::string& text, std::size_t max_bytes) {
  if (text.capacity() >= max_bytes) return;
  std::string roomy;
  roomy.reserve(max_bytes);
  roomy.assign(text);
  text.swap(roomy);
  wipe(roomy);
}

}  // namespace hallux::ui
