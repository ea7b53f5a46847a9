#include "ui/widgets/texts/texts.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <stdexcept>

namespace hallux::ui {
namespace {

std::string message_of(const std::string& catalogue) {
  try {
    const Texts texts(catalogue);
  } catch (const std::runtime_error& fault) {
    return fault.what();
  }
  return "no fault";
}

TEST(Texts, FillsNamedPlacesInWholeSentences) {
  const Texts texts(
      "score.of = {score} of {most} points\n# a comment\n\nempty.line = two\\nlines\n");
  EXPECT_EQ(texts.say("score.of", {{"score", "76.8"}, {"most", "100"}}), "76.8 of 100 points");
  EXPECT_EQ(texts.text("empty.line"), "two\nlines");
  EXPECT_EQ(texts.say("score.of", {{"score", "{most}"}}), "{most} of {most} points")
      << "what has no value stays in braces";
}

TEST(Texts, ChooseBetweenOneAndMany) {
  const Texts texts("people.one = {count} person\npeople.other = {count} people\n");
  EXPECT_EQ(texts.say_count("people", 1), "1 person");
  EXPECT_EQ(texts.say_count("people", 0), "0 people");
  EXPECT_EQ(texts.say_count("people", 14000),
            "14\xE2\x80\x89"
            "000 people");
}

TEST(Texts, GroupsDigitsInThrees) {
  EXPECT_EQ(grouped(0), "0");
  EXPECT_EQ(grouped(999), "999");
  EXPECT_EQ(grouped(-1234567),
            "\xE2\x88\x92"
            "1\xE2\x80\x89"
            "234\xE2\x80\x89"
            "567");
}

TEST(Texts, NameLineAndFaultOfABadCatalogue) {
  EXPECT_NE(message_of("a = b\nc\n").find("line 2: has no '='"), std::string::npos);
  EXPECT_NE(message_of("a =\n").find("no id or no text"), std::string::npos);
  EXPECT_NE(message_of("a = b\n\na = c\n").find("line 3: 'a' is there twice"), std::string::npos);
  EXPECT_NE(message_of("a = {b\n").find("left open"), std::string::npos);
  EXPECT_NE(message_of("a = b}\n").find("was not opened"), std::string::npos);
}

TEST(Texts, AMissingTextIsSeen) { EXPECT_EQ(Texts("a = b\n").text("c"), "[missing text]"); }

std::vector<std::string> sources_of_the_window() {
  std::vector<std::string> sources;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(HALLUX_SOURCE_UI)) {
    if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h") continue;
    std::ifstream stream(entry.path());
    sources.emplace_back(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  }
  return sources;
}

using Ids = std::set<std::string>;

void add_matches(const std::string& source, const char* pattern, Ids& ids) {
  const std::regex wanted(pattern);
  for (std::sregex_iterator found(source.begin(), source.end(), wanted), end; found != end; ++found)
    for (std::size_t group = 1; group < found->size(); ++group) ids.insert((*found)[group].str());
}

void add_counted(const Ids& counted, Ids& ids) {
  for (const std::string& id : counted) ids.insert({id + ".one", id + ".other"});
}

// Every id that the sources ask for, "x" for text("x") and "x.one", "x.other" for say_count("x").
Ids asked_ids() {
  Ids asked, counted;
  for (const std::string& source : sources_of_the_window()) {
    add_matches(source, R"(\b(?:text|say)\(\s*"([a-z0-9_.]+)\")", asked);
    add_matches(source, R"(\bsay_count\(\s*"([a-z0-9_.]+)\")", counted);
    add_matches(source, R"re(text\(\s*[a-z_.]+\s*\?\s*"([a-z0-9_.]+)"\s*:\s*"([a-z0-9_.]+)")re",
                asked);
  }
  add_counted(counted, asked);
  return asked;
}

// The same and every id that stands in them as a word of its own, as in a table of ids.
Ids named_ids() {
  Ids named = asked_ids();
  for (const std::string& source : sources_of_the_window())
    add_matches(source, R"re("([a-z0-9_]+(?:\.[a-z0-9_]+)+)")re", named);
  return named;
}

TEST(EnglishTexts, EveryTextThatIsAskedForIsThere) {
  const std::vector<std::string> ids = english_texts().ids();
  const std::set<std::string> known(ids.begin(), ids.end()), used = asked_ids();
  EXPECT_GE(used.size(), 8U) << "the sources were not found";
  for (const std::string& id : used)
    EXPECT_TRUE(known.contains(id)) << id << " is asked for and missing";
}

TEST(EnglishTexts, EveryTextIsUsed) {
  const Ids used = named_ids();
  for (const std::string& id : english_texts().ids())
    EXPECT_TRUE(used.contains(id)) << id << " is used nowhere";
}

TEST(EnglishTexts, SpeakCalmly) {
  const Texts texts = english_texts();
  for (const std::string& id : texts.ids()) {
    const std::string_view text = texts.text(id);
    EXPECT_EQ(text.find('!'), std::string_view::npos) << id;
    EXPECT_EQ(text.find("  "), std::string_view::npos) << id;
  }
}

}  // namespace
}  // namespace hallux::ui
