#include "ui/screens/guide/guides.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>

#include "ui/screens/guide/guide_pictures.h"

namespace hallux::ui {
namespace {

using testing::IsEmpty;

/// The pages of docs/guides come first; the others are those that they lead to.
constexpr std::size_t guide_count = 4;

std::string source_of(const GuidePage& page) {
  for (const char* folder : {"guides", ".", "how_to"}) {
    const auto file = std::filesystem::path(HALLUX_DOCS) / folder / page.name;
    // docs has a page of that name, too.
    if (page.name == "README.md" && std::string(folder) != "guides") continue;
    std::ifstream stream(file);
    if (stream) return {std::istreambuf_iterator<char>(stream), {}};
  }
  return {};
}

void add_targets(const MarkdownRuns& runs, std::vector<std::string>& targets) {
  for (const MarkdownRun& run : runs)
    if (!run.target.empty()) targets.push_back(run.target);
}

std::vector<std::string> targets_of(const GuidePage& page) {
  std::vector<std::string> targets;
  for (const MarkdownBlock& block : page.blocks) {
    add_targets(block.runs, targets);
    for (const auto& row : block.rows)
      for (const MarkdownRuns& cell : row) add_targets(cell, targets);
  }
  return targets;
}

TEST(Guides, ArePartOfTheProgramWithEveryWord) {
  const Guides guides;
  ASSERT_GT(guides.pages().size(), guide_count);
  for (const GuidePage& page : guides.pages()) {
    const std::string source = source_of(page);
    ASSERT_FALSE(source.empty()) << page.name;
    std::string shown;
    for (const MarkdownBlock& block : page.blocks)
      shown += block.mark + " " + plain_text(block) + " " + block.source + " ";
    for (const std::string& target : targets_of(page)) shown += target + " ";
    const std::regex word("[A-Za-z0-9]+");
    for (std::sregex_iterator found(source.begin(), source.end(), word), end; found != end; ++found)
      EXPECT_NE(shown.find(found->str()), std::string::npos) << page.name << ": " << found->str();
    EXPECT_FALSE(page.title.empty()) << page.name;
  }
}

TEST(Guides, HaveThePlaceThatEachScreenNames) {
  const Guides guides;
  for (int section = 0; section < guide_section_count; ++section) {
    const GuideHeading heading = heading_of(static_cast<GuideSection>(section));
    const std::string target = std::string(heading.page) + "#" + std::string(heading.anchor);
    const auto place = guides.followed(0, target);
    ASSERT_TRUE(place.has_value()) << target;
    EXPECT_EQ(guides.pages()[place->page].name, heading.page);
    EXPECT_EQ(guides.place_of(static_cast<GuideSection>(section)), *place);
  }
}

TEST(Guides, LeadSomewhereByEachOfTheirLinks) {
  const Guides guides;
  for (std::size_t page = 0; page < guide_count; ++page)
    for (const std::string& target : targets_of(guides.pages()[page]))
      EXPECT_TRUE(guides.followed(page, target).has_value())
          << guides.pages()[page].name << ": " << target;
  EXPECT_FALSE(guides.followed(0, "trainee.md#nowhere").has_value());
  EXPECT_FALSE(guides.followed(0, "nothing.md").has_value());
  EXPECT_FALSE(guides.followed(0, "https://example.org/trainee.md").has_value());
}

TEST(Guides, HaveTheirPictures) {
  const Guides guides;
  std::size_t pictures = 0;
  for (const GuidePage& page : guides.pages())
    for (const MarkdownBlock& block : page.blocks) {
      if (block.kind != MarkdownKind::Picture) continue;
      ++pictures;
      const auto size = GuidePictures::size_of(block.source);
      ASSERT_TRUE(size.has_value()) << block.source;
      EXPECT_GT(size->width, 400) << block.source;
      EXPECT_FALSE(plain_text(block).empty()) << block.source << " says what it shows";
    }
  EXPECT_GE(pictures, 15U);
  EXPECT_FALSE(GuidePictures::size_of("../pictures/window/none.png").has_value());
}

TEST(Guides, AreSearchedFromThePageThatIsRead) {
  const Guides guides;
  const auto hits = guides.found("ONE-TIME code", 1);
  ASSERT_GE(hits.size(), 2U);
  EXPECT_EQ(hits.front().place.page, 1U) << "the page that is read comes first";
  EXPECT_NE(hits.front().words.find("one-time code"), std::string::npos);
  EXPECT_THAT(guides.found("", 0), IsEmpty());
  EXPECT_THAT(guides.found("no such words anywhere", 0), IsEmpty());
}

}  // namespace
}  // namespace hallux::ui
