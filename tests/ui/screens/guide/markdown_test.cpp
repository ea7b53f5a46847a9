#include "ui/screens/guide/markdown.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hallux::ui {
namespace {

using testing::ElementsAre;

std::vector<std::string> words_of(const MarkdownPage& page) {
  std::vector<std::string> words;
  for (const MarkdownBlock& block : page) words.push_back(plain_text(block));
  return words;
}

TEST(Markdown, WordsKeepTheirLooksAndWhereTheyLead) {
  const MarkdownPage page = read_markdown(
      "Press **Tab** or *see* `hallux verify`,\nthen [read on](trainee.md#operate).\n");
  ASSERT_EQ(page.size(), 1U);
  EXPECT_EQ(plain_text(page[0]), "Press Tab or see hallux verify, then read on.");
  const MarkdownRuns& runs = page[0].runs;
  ASSERT_EQ(runs.size(), 9U);
  EXPECT_TRUE(runs[1].is_strong);
  EXPECT_TRUE(runs[3].is_emphasised);
  EXPECT_TRUE(runs[5].is_code);
  EXPECT_EQ(runs[7].target, "trainee.md#operate");
  EXPECT_EQ(runs[8].target, "");
}

TEST(Markdown, HeadingsHaveTheAnchorsThatLinksName) {
  const MarkdownPage page = read_markdown("# Who is *kept* from what?\n## A-b\n## A-b\n");
  ASSERT_EQ(page.size(), 3U);
  EXPECT_EQ(page[0].anchor, "who-is-kept-from-what");
  EXPECT_EQ(page[0].level, 1);
  EXPECT_EQ(page[1].anchor, "a-b");
  EXPECT_EQ(page[2].anchor, "a-b-1") << "the second of a name";
}

TEST(Markdown, ListsKeepTheirDepthAndTheirNumbers) {
  const MarkdownPage page = read_markdown("- a\n  - b\n- c\n\n3. d\n4. e\n\n   f\n");
  ASSERT_THAT(words_of(page), ElementsAre("a", "b", "c", "d", "e", "f"));
  EXPECT_EQ(page[0].depth, 1);
  EXPECT_EQ(page[1].depth, 2);
  EXPECT_EQ(page[3].mark, "3.");
  EXPECT_EQ(page[4].mark, "4.");
  EXPECT_EQ(page[5].mark, "") << "the item goes on";
}

TEST(Markdown, TablesHaveTheirCellsAndHowTheyStand) {
  const MarkdownPage page =
      read_markdown("| what | keys |\n|---|--:|\n| lead | `I` |\n| push | Page up |\n");
  ASSERT_EQ(page.size(), 1U);
  ASSERT_EQ(page[0].kind, MarkdownKind::Table);
  ASSERT_EQ(page[0].rows.size(), 3U);
  EXPECT_EQ(plain_text(page[0].rows[2][1]), "Page up");
  EXPECT_THAT(page[0].aligns, ElementsAre(Align::Left, Align::Right));
}

TEST(Markdown, APictureByItselfIsABlock) {
  const MarkdownPage page =
      read_markdown("![One](a/one.png)\n![Two](two.png)\n\nAn ![eye](e.png).\n");
  ASSERT_EQ(page.size(), 3U);
  EXPECT_EQ(page[0].kind, MarkdownKind::Picture);
  EXPECT_EQ(page[0].source, "a/one.png");
  EXPECT_EQ(plain_text(page[1]), "Two");
  EXPECT_EQ(plain_text(page[2]), "An eye.");
}

TEST(Markdown, WhatIsNotKnownIsItsText) {
  const MarkdownPage page = read_markdown(
      "<div>\nkept\n</div>\n\na <b>bold</b> word\n\n> said\n\n---\n\n    code  two\n");
  const std::vector<std::string> words = words_of(page);
  ASSERT_EQ(words.size(), 5U);
  EXPECT_EQ(words[0], "<div>\nkept\n</div>\n");
  EXPECT_EQ(words[1], "a <b>bold</b> word");
  EXPECT_EQ(words[2], "said");
  EXPECT_EQ(page[2].depth, 1);
  EXPECT_EQ(page[3].kind, MarkdownKind::Rule);
  EXPECT_EQ(words[4], "code  two\n");
}

}  // namespace
}  // namespace hallux::ui
