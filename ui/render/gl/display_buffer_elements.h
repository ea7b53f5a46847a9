/// The bodies of DisplayBuffer's functions; include display_buffer.h.
#pragma once

#include <cstring>

#include "ui/render/gl/display_buffer.h"

namespace hallux::ui {

template <typename Element>
void DisplayBuffer<Element>::set(std::size_t place, const Element& value) {
  // By their bytes: those are what the card has.
  const void *before = &elements_[place], *now = &value;
  if (std::memcmp(before, now, sizeof(Element)) == 0) return;
  elements_[place] = value;
  store_.mark(place * sizeof(Element), (place + 1) * sizeof(Element));
}

template <typename Element>
void DisplayBuffer<Element>::assign(std::span<const Element> elements) {
  const std::size_t common =
      elements_.size() < elements.size() ? elements_.size() : elements.size();
  for (std::size_t place = 0; place < common; ++place) set(place, elements[place]);
  elements_.resize(common);
  places_.clear();
  if (has_places()) places_.append(common);
  append(elements.subspan(common));
}

template <typename Element>
void DisplayBuffer<Element>::append(std::span<const Element> elements) {
  if (elements.empty()) return;
  const std::size_t first = elements_.size();
  elements_.insert(elements_.end(), elements.begin(), elements.end());
  store_.mark(first * sizeof(Element), elements_.size() * sizeof(Element));
  if (has_places()) places_.append(elements.size());
}

template <typename Element>
void DisplayBuffer<Element>::write(std::uint32_t element, const Element& value) {
  set(has_places() ? places_.place_of(element) : element, value);
}

template <typename Element>
void DisplayBuffer<Element>::remove(std::span<const std::uint32_t> removed) {
  if (policy_.removal == RemovalPolicy::Rebuild) return rebuild_without(removed);
  for (const std::uint32_t element : removed) {
    if (policy_.removal == RemovalPolicy::Overwrite) {
      set(element, blank_);
      continue;
    }
    const std::uint32_t place = places_.place_of(element);
    set(place, elements_.back());
    elements_.pop_back();
    places_.move_last_to(place);
  }
}

template <typename Element>
void DisplayBuffer<Element>::rebuild_without(std::span<const std::uint32_t> removed) {
  if (removed.empty()) return;
  std::vector<std::uint8_t> is_gone_at(elements_.size());
  for (const std::uint32_t element : removed) is_gone_at[places_.place_of(element)] = 1;
  std::size_t kept = 0;
  for (std::size_t place = 0; place < elements_.size(); ++place) {
    if (is_gone_at[place] == 0) elements_[kept++] = elements_[place];
  }
  elements_.resize(kept);
  places_.pack(is_gone_at);
  store_.mark(0, kept * sizeof(Element));
}

}  // namespace hallux::ui
