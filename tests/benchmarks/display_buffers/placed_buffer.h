/// The ways to remove elements that the program does not take (thesis 5.3.4), to be measured beside
/// the one that it does.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ui/render/gl/display_buffer.h"

namespace hallux::benchmarks {

enum class RemovalPolicy : std::uint8_t {
  /// A blank takes the place: what ui::DisplayBuffer does.
  Overwrite,
  /// The last element takes the place (the thesis's first method); costs 8 bytes of memory an
  /// element.
  MoveLast,
  /// All that stands is packed again and sent: the thesis's unoptimised method; as much memory.
  Rebuild
};

/// Elements are called by the number in which they were appended; a number stays theirs wherever
/// they move.
template <typename Element>
class PlacedBuffer {
 public:
  PlacedBuffer(const Element& blank, RemovalPolicy removal)
      : blank_(blank), removal_(removal), store_(ui::BufferPolicy{}) {}

  std::span<const Element> elements() const noexcept { return elements_; }
  std::size_t size() const noexcept { return elements_.size(); }
  unsigned name() const noexcept { return store_.name(); }
  void upload() { store_.upload(std::as_bytes(std::span(elements_)), sizeof(Element)); }

  void append(std::span<const Element> elements) {
    const std::size_t first = elements_.size();
    elements_.insert(elements_.end(), elements.begin(), elements.end());
    store_.mark(first * sizeof(Element), elements_.size() * sizeof(Element));
    for (std::size_t place = first; place < elements_.size(); ++place) {
      element_at_.push_back(static_cast<std::uint32_t>(place_of_.size()));
      place_of_.push_back(static_cast<std::uint32_t>(place));
    }
  }
  /// needs   the element was not removed, or the policy is Overwrite: then it comes back
  void write(std::uint32_t element, const Element& value) { set(place_of_[element], value); }
  /// needs   none of them was removed before, but under Overwrite
  void remove(std::span<const std::uint32_t> removed) {
    if (removal_ == RemovalPolicy::Rebuild) return rebuild_without(removed);
    for (const std::uint32_t element : removed) {
      if (removal_ == RemovalPolicy::Overwrite) {
        write(element, blank_);
      } else {
        move_last_to(place_of_[element]);
      }
    }
  }

 private:
  void set(std::size_t place, const Element& value) {
    if (elements_[place] == value) return;
    elements_[place] = value;
    store_.mark(place * sizeof(Element), (place + 1) * sizeof(Element));
  }
  void move_last_to(std::uint32_t place) {
    set(place, elements_.back());
    elements_.pop_back();
    element_at_[place] = element_at_.back();
    place_of_[element_at_[place]] = place;
    element_at_.pop_back();
  }
  void rebuild_without(std::span<const std::uint32_t> removed) {
    if (removed.empty()) return;
    std::vector<std::uint8_t> is_gone_at(elements_.size());
    for (const std::uint32_t element : removed) is_gone_at[place_of_[element]] = 1;
    std::uint32_t kept = 0;
    for (std::size_t place = 0; place < elements_.size(); ++place) {
      if (is_gone_at[place] != 0) continue;
      elements_[kept] = elements_[place];
      element_at_[kept] = element_at_[place];
      place_of_[element_at_[kept]] = kept;
      ++kept;
    }
    elements_.resize(kept);
    element_at_.resize(kept);
    store_.mark(0, kept * sizeof(Element));
  }

  Element blank_;
  RemovalPolicy removal_;
  std::vector<Element> elements_;
  std::vector<std::uint32_t> place_of_, element_at_;
  ui::DisplayStore store_;
};

}  // namespace hallux::benchmarks
