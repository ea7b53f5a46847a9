#include "tests/support/own_memory.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <random>
#include <sstream>

namespace hallux {

namespace {

struct Region {
  std::uint64_t begin = 0, end = 0;
};

std::vector<Region> writable_regions() {
  std::vector<Region> regions;
  std::ifstream maps{"/proc/self/maps"};
  for (std::string line; std::getline(maps, line);) {
    std::istringstream words{line};
    Region region;
    char dash = 0;
    std::string rights;
    words >> std::hex >> region.begin >> dash >> region.end >> rights;
    // The sanitizers' shadow is terabytes of nothing.
    const bool is_shadow = region.end - region.begin > (1ULL << 33U);
    if (rights.rfind("rw", 0) == 0 && !is_shadow) regions.push_back(region);
  }
  return regions;
}

}  // namespace

PlantedSecret::PlantedSecret() {
  std::random_device random;
  while (backwards_.size() < 24) backwards_.push_back(static_cast<char>('a' + random() % 26));
}

std::string PlantedSecret::spelled() const {
  std::string text;
  text.reserve(64);  // on the heap, and in one place
  for (auto letter = backwards_.rbegin(); letter != backwards_.rend(); ++letter) {
    text.push_back(*letter);
  }
  return text;
}

std::size_t PlantedSecret::places_in_memory() const {
  const int memory = open("/proc/self/mem", O_RDONLY | O_CLOEXEC);
  std::vector<char> bytes(1U << 20U);
  std::size_t places = 0;
  for (const Region& region : writable_regions()) {
    std::uint64_t at = region.begin;
    while (at < region.end) {
      const std::size_t wanted = std::min<std::uint64_t>(bytes.size(), region.end - at);
      const ssize_t got = pread(memory, bytes.data(), wanted, static_cast<off_t>(at));
      if (got <= 0) break;
      const auto own = reinterpret_cast<std::uint64_t>(bytes.data());
      const bool is_own = at < own + bytes.size() && own < at + static_cast<std::uint64_t>(got);
      const auto end = bytes.begin() + got;
      for (auto place = bytes.begin(); !is_own; ++place) {
        place = std::search(place, end, backwards_.rbegin(), backwards_.rend());
        if (place == end) break;
        ++places;
      }
      // The next piece overlaps, so that nothing hides across the seam.
      if (static_cast<std::uint64_t>(got) <= size()) break;
      at += static_cast<std::uint64_t>(got) == wanted && at + wanted < region.end ? wanted - size()
                                                                                  : wanted;
    }
  }
  close(memory);
  return places;
}

}  // namespace hallux
