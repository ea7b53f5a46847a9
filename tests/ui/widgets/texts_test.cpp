#include "ui/widgets/texts.h"

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

// Every id that the sources of the window ask for, "x" for text("x") and "x.one", "x.other" for say_count("x").
std::set<std::string> used_ids() {
  std::set<std::string> used;
  const std::regex asked(R"((text|say|say_count)\(\s*"([a-z0-9_.]+)\")");
  const std::regex either(R"re(text\(\s*[a-z_.]+\s*\?\s*"([a-z0-9_.]+)"\s*:\s*"([a-z0-9_.]+)")re");
  for (const auto& entry : std::filesystem::recursive_directory_iterator(HALLUX_SOURCE_UI)) {
    if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h") continue;
    std::ifstream stream(entry.path());
    const std::string source{std::istreambuf_iterator<char>(stream), {}};
    for (std::sregex_iterator found(source.begin(), source.end(), asked), end; found != end;
         ++found) {
      if ((*found)[1] == "say_count") {
        used.insert((*found)[2].str() + ".one");
        used.insert((*found)[2].str() + ".other");
      } else {
        used.insert((*found)[2].str());
      }
    }
    for (std::sregex_iterator found(source.begin(), source.end(), either), end; found != end;
         ++found) {
      used.insert((*found)[1].str());
      used.insert((*found)[2].str());
    }
  }
  return used;
}

TEST(EnglishTexts, EveryTextThatIsAskedForIsThere) {
  const std::vector<std::string> ids = english_texts().ids();
  const std::set<std::string> known(ids.begin(), ids.end()), used = used_ids();
  EXPECT_GE(used.size(), 8U) << "the sources were not found";
  for (const std::string& id : used)
    EXPECT_TRUE(known.contains(id)) << id << " is asked for and missing";
}

TEST(EnglishTexts, EveryTextIsUsed) {
  const std::set<std::string> used = used_ids();
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
