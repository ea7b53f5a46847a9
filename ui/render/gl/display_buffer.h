/// A buffer on the graphics card that grows and shrinks: vertices, or triangles of an index buffer.
///
///     memory   elements ............ removed .... appended     what the caller reads and writes
///                 |  changed ranges only, neighbours joined
///     card     ===========================================....  room to grow
///
/// Nothing goes to the card before upload(), and then only what changed since the last one. How much room is taken when the
/// room ends, and how elements leave, are parameters.
/// source  thesis 5.3
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "ui/render/gl/gl_objects.h"

namespace hallux::ui {

/// Where the elements of a new, larger store come from.
enum class Refill : std::uint8_t {
  FromMemory,  ///< all are sent again
  OnCard       ///< the card copies the old store; only what changed is sent
};

struct GrowthPolicy {
  double factor = 1.5;      ///< new room over what is needed; 1: exactly what is needed
  std::size_t least = 256;  ///< elements; no store is smaller
  Refill refill = Refill::FromMemory;
};

/// The elements that a new store has room for.
/// needs   factor >= 1
std::size_t room_for(const GrowthPolicy& growth, std::size_t needed) noexcept;

enum class RemovalPolicy : std::uint8_t {
  Overwrite,  ///< a blank takes the place: nothing else moves, the blank is drawn as nothing (thesis 5.3.4, second method)
  MoveLast,  ///< the last element takes the place (thesis 5.3.4, first method); costs 8 bytes of memory an element
  Rebuild  ///< all that stands is packed again and sent: the thesis's unoptimised method; as much memory
};

struct BufferPolicy {
  GrowthPolicy growth{};
  RemovalPolicy removal = RemovalPolicy::Overwrite;
  /// Changed ranges that lie no further apart go to the card as one: a call costs more than these bytes.
  std::size_t join_bytes = 2048;
};

/// What a buffer has done since it was made.
struct BufferCounts {
  std::uint64_t stores = 0;          ///< made on the card
  std::uint64_t uploads = 0;         ///< ranges sent
  std::uint64_t uploaded_bytes = 0;  ///< sent from memory
  std::uint64_t copied_bytes = 0;    ///< by the card, from store to store
};

/// Changed places of a row of bytes, as few ranges as may be.
class ChangedRanges {
 public:
  struct Range {
    std::size_t first = 0, last = 0;  ///< [first, last)
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
  std::size_t room_bytes_ = 0, sent_bytes_ = 0;
  ChangedRanges changed_;
  BufferCounts counts_;
};

/// Which elements stand where, when elements may move.
class ElementPlaces {
 public:
  static constexpr std::uint32_t nowhere = 0xffffffffU;

  void append(std::size_t count);
  void clear() noexcept { place_of_.clear(), element_at_.clear(); }
  std::uint32_t place_of(std::uint32_t element) const noexcept { return place_of_[element]; }
  std::uint32_t element_at(std::size_t place) const noexcept { return element_at_[place]; }
  /// The last place's element moves to `place`, whose own goes nowhere.
  void move_last_to(std::uint32_t place);
  /// Elements that are `gone` go nowhere, the others close up.
  void pack(const std::vector<std::uint8_t>& is_gone_at);

 private:
  std::vector<std::uint32_t> place_of_, element_at_;
};

/// Elements are called by the number in which they were appended; a number stays theirs wherever they move.
/// needs   Element is trivially copyable; `blank` is drawn as nothing
template <typename Element>
class DisplayBuffer {
 public:
  explicit DisplayBuffer(const Element& blank = {}, const BufferPolicy& policy = {})
      : blank_(blank), policy_(policy), store_(policy) {}

  /// The elements as they stand on the card after upload(), blanks among them.
  std::span<const Element> elements() const noexcept { return elements_; }
  std::size_t size() const noexcept { return elements_.size(); }
  unsigned name() const noexcept { return store_.name(); }
  const BufferCounts& counts() const noexcept { return store_.counts(); }
  std::size_t room() const noexcept { return store_.room_bytes() / sizeof(Element); }

  /// Replaces everything; what is equal to what stood in its place is not sent again.
  void assign(std::span<const Element> elements);
  void append(std::span<const Element> elements);
  /// needs   the element was not removed, or the policy is Overwrite: then it comes back
  void write(std::uint32_t element, const Element& value);
  /// needs   none of them was removed before, but under Overwrite
  void remove(std::span<const std::uint32_t> removed);

  /// Brings the card up to date.
  /// needs   the context in which it was made
  void upload() { store_.upload(std::as_bytes(std::span(elements_)), sizeof(Element)); }

 private:
  bool has_places() const noexcept { return policy_.removal != RemovalPolicy::Overwrite; }
  void set(std::size_t place, const Element& value);
  void rebuild_without(std::span<const std::uint32_t> removed);

  Element blank_;
  BufferPolicy policy_;
  std::vector<Element> elements_;
  ElementPlaces places_;
  DisplayStore store_;
};

}  // namespace hallux::ui

#include "ui/render/gl/display_buffer_elements.h"
