/// The guides that the program carries with it, and the places in them that screens and links name.
/// Inside this corner only.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ui/screens/guide/markdown.h"
#include "ui/window/shell/guide_section.h"

namespace hallux::ui {

struct GuidePage {
  /// Its file: "trainee.md".
  std::string_view name;
  /// Of its first heading.
  std::string title;
  MarkdownPage blocks;
};

/// A heading of a page, as indices; block 0 is the page's beginning.
struct GuidePlace {
  std::size_t page = 0, block = 0;

  friend bool operator==(const GuidePlace&, const GuidePlace&) = default;
};

/// What was found of some words: a block that has them, and the part of its text around them.
struct GuideHit {
  GuidePlace place;
  std::string words;
};

class Guides {
 public:
  /// Those that the program carries.
  Guides();

  std::span<const GuidePage> pages() const noexcept { return pages_; }
  /// needs   the guides have the section's heading; a test holds each to it
  GuidePlace place_of(GuideSection section) const;
  /// Where a link on a page leads; nothing where that is not part of the program.
  std::optional<GuidePlace> followed(std::size_t page, std::string_view target) const;
  /// The blocks in which the words stand, capitals or not, on `first` and then on the others.
  std::vector<GuideHit> found(std::string_view words, std::size_t first) const;

 private:
  std::vector<GuidePage> pages_;
};

/// The page and the heading of a section: "trainee.md", "operate".
struct GuideHeading {
  std::string_view page, anchor;
};
GuideHeading heading_of(GuideSection section) noexcept;

}  // namespace hallux::ui
