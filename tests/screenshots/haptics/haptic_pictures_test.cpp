// The committed pictures are what the modelled arm and the hands do today: one that is out of date,
// or was changed by hand, fails here.
#include "tests/screenshots/haptics/haptic_pictures.h"

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

TEST(HapticPictures, AreTheCommittedOnesToTheLastByte) {
  std::set<std::string> made;
  for (const Picture& picture : haptic_pictures()) {
    const std::string file = picture.name + ".svg";
    made.insert(file);
    EXPECT_TRUE(text_of(docs / "pictures" / "haptics" / file) == picture.svg)
        << file << " is out of date: build the target `screenshots`, look at it, commit it";
    EXPECT_LT(picture.svg.size(), 250U * 1024U) << picture.name;
    EXPECT_EQ(picture.svg.find("not a number"), std::string::npos) << picture.name;
  }
  for (const auto& entry : std::filesystem::directory_iterator(docs / "pictures" / "haptics")) {
    EXPECT_TRUE(made.contains(entry.path().filename().string()))
        << entry.path() << " is made by nothing";
  }
}

TEST(HapticPictures, AreAllShownInTheText) {
  const std::string text = text_of(docs / "haptics.md");
  for (const Picture& picture : haptic_pictures()) {
    EXPECT_NE(text.find("](pictures/haptics/" + picture.name + ".svg)"), std::string::npos)
        << picture.name;
  }
}

}  // namespace
}  // namespace hallux::tests
