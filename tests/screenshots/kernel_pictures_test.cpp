// The committed pictures are what the kernel makes today: a picture that is out of date, or was
// changed by hand, fails here.
#include "tests/screenshots/kernel_pictures.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

namespace hallux::tests {
namespace {

const std::filesystem::path docs = HALLUX_DOCS;

std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// Whether every element is closed in turn, of a text whose attributes hold no brackets.
bool has_matching_tags(const std::string& svg) {
  std::vector<std::string> open;
  for (std::size_t at = svg.find('<'); at != std::string::npos; at = svg.find('<', at + 1)) {
    const std::size_t end = svg.find('>', at);
    if (end == std::string::npos) return false;
    const bool closes = svg[at + 1] == '/';
    const std::size_t first = at + (closes ? 2 : 1);
    const std::string name = svg.substr(first, svg.find_first_of(" />", first) - first);
    if (closes) {
      if (open.empty() || open.back() != name) return false;
      open.pop_back();
    } else if (svg[end - 1] != '/') {
      open.push_back(name);
    }
  }
  return open.empty();
}

TEST(KernelPictures, AreTheCommittedOnesToTheLastByte) {
  std::set<std::string> made;
  for (const Picture& picture : kernel_pictures()) {
    const std::string file = picture.name + ".svg";
    made.insert(file);
    // Not EXPECT_EQ: it would print both.
    EXPECT_TRUE(text_of(docs / "pictures" / file) == picture.svg)
        << file << " is out of date: build the target `screenshots`, look at it, commit it";
  }
  for (const auto& entry : std::filesystem::directory_iterator(docs / "pictures")) {
    if (entry.is_directory()) continue;  // the window's pictures
    EXPECT_TRUE(made.contains(entry.path().filename().string()))
        << entry.path() << " is made by nothing";
  }
}

// They show dates and somebody's hand, so their bytes are not compared; a picture that nobody sees
// is not kept.
TEST(WindowPictures, AreAllShownInTheGuides) {
  std::string text;
  for (const auto& guide : std::filesystem::directory_iterator(docs / "guides"))
    text += text_of(guide.path());
  int pictures = 0;
  for (const auto& entry : std::filesystem::directory_iterator(docs / "pictures" / "window")) {
    const std::string file = entry.path().filename().string();
    EXPECT_NE(text.find("](../pictures/window/" + file + ")"), std::string::npos) << file;
    ++pictures;
  }
  EXPECT_GT(pictures, 12);
}

TEST(KernelPictures, AreAllShownInTheText) {
  const std::string text = text_of(docs / "cutting.md");
  for (const Picture& picture : kernel_pictures()) {
    EXPECT_NE(text.find("](pictures/" + picture.name + ".svg)"), std::string::npos) << picture.name;
  }
}

TEST(KernelPictures, AreWholeAndSmall) {
  std::size_t bytes = 0;
  for (const Picture& picture : kernel_pictures()) {
    EXPECT_TRUE(has_matching_tags(picture.svg)) << picture.name;
    EXPECT_EQ(picture.svg.find("not a number"), std::string::npos) << picture.name;
    EXPECT_EQ(picture.svg.find("infinity"), std::string::npos) << picture.name;
    EXPECT_LT(picture.svg.size(), 250U * 1024U) << picture.name;
    bytes += picture.svg.size();
  }
  EXPECT_LT(bytes, 1536U * 1024U);
}

}  // namespace
}  // namespace hallux::tests
