/// A buffer on the graphics card that grows and shrinks: vertices, or triangles of an index buffer.
///
///     memory   elements ............ removed .... appended     what the caller reads and writes
///                 |  changed ranges only, neighbours joined
///     card     ===========================================....  room to grow
///
/// Nothing goes to the card before upload(), and then only what changed since the last one. How
/// much room is taken when the room ends is a parameter. An element that leaves is overwritten by a
/// blank, which is drawn as nothing: nothing else moves (thesis 5.3.4, second method; the others
/// are measured in tests/benchmarks/display_buffers).
/// source  thesis 5.3
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "ui/render/gl/gl_objects.h"

namespace hallux::ui {

struct GrowthPolicy {
  /// New room over what is needed; 1: exactly what is needed.
  double factor = 1.5;
  /// Elements; no store is smaller.
  std::size_t least = 256;
};

/// The elements that a new store has room for.
/// needs   factor >= 1
std::size_t room_for(const GrowthPolicy& growth, std::size_t needed) noexcept;

struct BufferPolicy {
  GrowthPolicy growth{};
  /// Changed ranges that lie no further apart go to the card as one: a call costs more than these
  /// bytes.
  std::size_t join_bytes = 2048;
};

/// What a buffer has done since it was made.
struct BufferCounts {
  /// Made on the card.
  std::uint64_t stores = 0;
  /// Ranges sent.
  std::uint64_t uploads = 0;
  /// Sent from memory.
  std::uint64_t uploaded_bytes = 0;
};

/// Changed places of a row of bytes, as few ranges as may be.
class ChangedRanges {
 public:
  struct Range {
    /// [first, last).
    std::size_t first = 0, last = 0;
  };

  void add(std::size_t first, std::size_t last);
  /// Sorted and joined where the gap is at most `join`; cut at `end`. Empties this.
  std::vector<Range> take(std::size_t join, std::size_t end);
  bool is_empty() const noexcept { return ranges_.empty(); }
  void clear() noexcept { ranges_.clear(); }

 private:
  std::vector<Range> ranges_;
};

/// The bytes behind a DisplayBuffer; knows no elements.
class DisplayStore {
 public:
  explicit DisplayStore(const BufferPolicy& policy) : policy_(policy) {}

  void mark(std::size_t first_byte, std::size_t last_byte) { changed_.add(first_byte, last_byte); }
  /// Brings the card up to `bytes`.
  void upload(std::span<const std::byte> bytes, std::size_t element_bytes);
  unsigned name() const noexcept { return buffer_.name(); }
  std::size_t room_bytes() const noexcept { return room_bytes_; }
  const BufferCounts& counts() const noexcept { return counts_; }

 private:
  void grow(std::span<const std::byte> bytes, std::size_t element_bytes);
  void send(std::span<const std::byte> bytes, const ChangedRanges::Range& range);

  BufferPolicy policy_;
  GlBuffer buffer_;
  std::size_t room_bytes_ = 0;
  ChangedRanges changed_;
  BufferCounts counts_;
};

/// Elements are called by the number in which they were appended.
/// needs   Element is trivially copyable; `blank` is drawn as nothing
template <typename Element>
class DisplayBuffer {
 public:
  explicit DisplayBuffer(const Element& blank = {}, const BufferPolicy& policy = {})
      : blank_(blank), store_(policy) {}

  /// The elements as they stand on the card after upload(), blanks among them.
  std::span<const Element> elements() const noexcept { return elements_; }
  std::size_t size() const noexcept { return elements_.size(); }
  unsigned name() const noexcept { return store_.name(); }
  const BufferCounts& counts() const noexcept { return store_.counts(); }
  std::size_t room() const noexcept { return store_.room_bytes() / sizeof(Element); }

  /// Replaces everything; what is equal to what stood in its place is not sent again.
  void assign(std::span<const Element> elements) {
    const std::size_t common = std::min(elements_.size(), elements.size());
    for (std::size_t place = 0; place < common; ++place) write(place, elements[place]);
    elements_.resize(common);
    append(elements.subspan(common));
  }
  void append(std::span<const Element> elements) {
    const std::size_t first = elements_.size();
    elements_.insert(elements_.end(), elements.begin(), elements.end());
    store_.mark(first * sizeof(Element), elements_.size() * sizeof(Element));
  }
  /// An element that was removed comes back.
  void write(std::size_t element, const Element& value) {
    // By their bytes: those are what the card has.
    const void *before = &elements_[element], *now = &value;
    if (std::memcmp(before, now, sizeof(Element)) == 0) return;
    elements_[element] = value;
    store_.mark(element * sizeof(Element), (element + 1) * sizeof(Element));
  }
  void remove(std::span<const std::uint32_t> removed) {
    for (const std::uint32_t element : removed) write(element, blank_);
  }

  /// Brings the card up to date.
  /// needs   the context in which it was made
  void upload() { store_.upload(std::as_bytes(std::span(elements_)), sizeof(Element)); }

 private:
  Element blank_;
  std::vector<Element> elements_;
  DisplayStore store_;
};

}  // namespace hallux::ui
