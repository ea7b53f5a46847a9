#include "ui/screens/guide/guides.h"

#include <algorithm>
#include <array>

#include "simulator/base/check.h"
#include "simulator/base/embedded.h"

namespace hallux::ui {

/// docs/guides and the pages that they lead to, in the order in which they are listed.
std::span<const EmbeddedText> guide_files() noexcept;

namespace {

constexpr std::size_t words_before = 24, words_around = 100;

std::string title_of(const MarkdownPage& blocks) {
  const auto heading = std::ranges::find(blocks, MarkdownKind::Heading, &MarkdownBlock::kind);
  return heading == blocks.end() ? std::string() : plain_text(heading->runs);
}

std::string in_small_letters(std::string_view text) {
  std::string small(text);
  for (char& letter : small)
    if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
  return small;
}

// The first heading is the page itself.
std::optional<std::size_t> block_of(const MarkdownPage& blocks, std::string_view anchor) {
  if (anchor.empty()) return 0;
  for (std::size_t block = 0; block < blocks.size(); ++block)
    if (blocks[block].kind == MarkdownKind::Heading && blocks[block].anchor == anchor) return block;
  return std::nullopt;
}

// Whole words, with an ellipsis where more stands.
std::string part_around(const std::string& text, std::size_t at) {
  std::size_t begin = at > words_before ? text.find(' ', at - words_before) : 0;
  begin = begin == 0 || begin >= at ? (begin == 0 ? 0 : at) : begin + 1;
  std::size_t end = text.size();
  if (end - begin > words_around) {
    end = text.rfind(' ', begin + words_around);
    if (end == std::string::npos || end <= at) end = text.find(' ', at);
    end = std::min(end, text.size());
  }
  constexpr const char* ellipsis = "\xE2\x80\xA6";
  return (begin > 0 ? ellipsis : "") + text.substr(begin, end - begin) +
         (end < text.size() ? ellipsis : "");
}

}  // namespace

GuideHeading heading_of(GuideSection section) noexcept {
  static constexpr std::array<GuideHeading, guide_section_count> headings{{
      {"README.md", ""},
      {"trainee.md", "sign-in"},
      {"trainee.md", "choose-an-operation"},
      {"trainee.md", "fly-once"},
      {"trainee.md", "read-the-briefing"},
      {"trainee.md", "operate"},
      {"trainee.md", "see-what-it-was-worth"},
      {"trainee.md", "watch-it-again"},
      {"trainee.md", "watch-it-again"},
      {"trainee.md", "follow-yourself"},
      {"trainee.md", "what-is-kept-of-you"},
      {"instructor.md", "your-cohort"},
      {"instructor.md", "decide-about-a-result"},
      {"instructor.md", "answer-questions"},
      {"administrator.md", "begin"},
      {"administrator.md", "people"},
      {"administrator.md", "cohorts"},
      {"administrator.md", "scenarios"},
      {"administrator.md", "records"},
      {"administrator.md", "a-window-left-open"},
      {"trainee.md", "choose-a-device"},
  }};
  return headings[static_cast<std::size_t>(section)];
}

Guides::Guides() {
  for (const EmbeddedText& file : guide_files()) {
    GuidePage& page = pages_.emplace_back();
    page.name = file.name;
    page.blocks = read_markdown(file.text);
    page.title = title_of(page.blocks);
  }
}

GuidePlace Guides::place_of(GuideSection section) const {
  const GuideHeading heading = heading_of(section);
  const std::optional<GuidePlace> place =
      followed(0, std::string(heading.page) + "#" + std::string(heading.anchor));
  CHECK(place.has_value());
  return *place;
}

std::optional<GuidePlace> Guides::followed(std::size_t page, std::string_view target) const {
  const std::size_t hash = target.find('#');
  std::string_view file = target.substr(0, hash);
  const std::string_view anchor =
      hash == std::string_view::npos ? std::string_view() : target.substr(hash + 1);
  // A folder is told by its page; the pages' own names are enough: no two have the same.
  file.remove_prefix(file.find_last_of('/') + 1);
  const auto found = file.empty() ? pages_.begin() + static_cast<std::ptrdiff_t>(page)
                                  : std::ranges::find(pages_, file, &GuidePage::name);
  if (found == pages_.end() || target.find("://") != std::string_view::npos) return std::nullopt;
  const std::optional<std::size_t> block = block_of(found->blocks, anchor);
  if (!block) return std::nullopt;
  return GuidePlace{static_cast<std::size_t>(found - pages_.begin()), *block};
}

std::vector<GuideHit> Guides::found(std::string_view words, std::size_t first) const {
  std::vector<GuideHit> hits;
  const std::string wanted = in_small_letters(words);
  if (wanted.empty()) return hits;
  for (std::size_t count = 0; count < pages_.size(); ++count) {
    // The page that is read, then the others in their order.
    const std::size_t page = count == 0 ? first : count - (count <= first ? 1 : 0);
    for (std::size_t block = 0; block < pages_[page].blocks.size(); ++block) {
      const std::string text = plain_text(pages_[page].blocks[block]);
      const std::size_t at = in_small_letters(text).find(wanted);
      if (at != std::string::npos) hits.push_back({{page, block}, part_around(text, at)});
    }
  }
  return hits;
}

}  // namespace hallux::ui
