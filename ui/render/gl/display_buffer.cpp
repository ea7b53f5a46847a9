#include "ui/render/gl/display_buffer.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "simulator/base/check.h"

namespace hallux::ui {

namespace {

// A binding point that no vertex array remembers: binding here disturbs nobody.
constexpr unsigned binding = GL_COPY_WRITE_BUFFER;

/// Ranges kept before neighbours are joined: beyond this, keeping them apart would cost more than
/// sending what lies between.
constexpr std::size_t ranges_at_most = 4096;

}  // namespace

std::size_t room_for(const GrowthPolicy& growth, std::size_t needed) noexcept {
  CHECK(growth.factor >= 1.0);
  const double wanted = std::ceil(growth.factor * static_cast<double>(needed));
  return std::max({growth.least, needed, static_cast<std::size_t>(wanted)});
}

void ChangedRanges::add(std::size_t first, std::size_t last) {
  if (first >= last) return;
  if (!ranges_.empty() && first <= ranges_.back().last && last >= ranges_.back().first) {
    ranges_.back() = {std::min(first, ranges_.back().first), std::max(last, ranges_.back().last)};
    return;
  }
  for (std::size_t join = 64; ranges_.size() >= ranges_at_most; join *= 4) {
    ranges_ = take(join, static_cast<std::size_t>(-1));
  }
  ranges_.push_back({first, last});
}

std::vector<ChangedRanges::Range> ChangedRanges::take(std::size_t join, std::size_t end) {
  std::sort(ranges_.begin(), ranges_.end(),
            [](const Range& a, const Range& b) { return a.first < b.first; });
  std::vector<Range> joined;
  for (Range range : ranges_) {
    range.last = std::min(range.last, end);
    if (range.first >= range.last) continue;
    if (!joined.empty() && range.first <= joined.back().last + join) {
      joined.back().last = std::max(joined.back().last, range.last);
    } else {
      joined.push_back(range);
    }
  }
  ranges_.clear();
  return joined;
}

void DisplayStore::upload(std::span<const std::byte> bytes, std::size_t element_bytes) {
  if (bytes.size() > room_bytes_) grow(bytes, element_bytes);
  if (!changed_.is_empty()) {
    glBindBuffer(binding, buffer_.name());
    for (const ChangedRanges::Range& range : changed_.take(policy_.join_bytes, bytes.size())) {
      send(bytes, range);
    }
  }
}

void DisplayStore::grow(std::span<const std::byte> bytes, std::size_t element_bytes) {
  room_bytes_ = element_bytes * room_for(policy_.growth, bytes.size() / element_bytes);
  ++counts_.stores;
  GlBuffer grown;
  glBindBuffer(binding, grown.name());
  glBufferData(binding, static_cast<GLsizeiptr>(room_bytes_), nullptr, GL_DYNAMIC_DRAW);
  changed_.clear();
  changed_.add(0, bytes.size());
  buffer_ = std::move(grown);
}

void DisplayStore::send(std::span<const std::byte> bytes, const ChangedRanges::Range& range) {
  glBufferSubData(binding, static_cast<GLintptr>(range.first),
                  static_cast<GLsizeiptr>(range.last - range.first), bytes.data() + range.first);
  ++counts_.uploads;
  counts_.uploaded_bytes += range.last - range.first;
}

}  // namespace hallux::ui
