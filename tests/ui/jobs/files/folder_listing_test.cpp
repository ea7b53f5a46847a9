#include "ui/jobs/files/folder_listing.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "ui/jobs/files/read_small_file.h"

namespace hallux::ui {
namespace {

namespace fs = std::filesystem;

class Folder : public testing::Test {
 protected:
  Folder() {
    std::string name = (fs::temp_directory_path() / "folder-XXXXXX").string();
    path_ = mkdtemp(name.data());
    for (const char* folder : {"Silver", "akin", ".kept"}) fs::create_directory(path_ / folder);
    for (const char* file : {"bad.json", "Base.JSON", "note.txt", ".hidden.json", "other.json"})
      std::ofstream(path_ / file) << "twelve bytes";
    fs::create_symlink("nowhere", path_ / "lost.json");
  }
  ~Folder() override { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string names(const ListingFilter& filter) const {
    std::string all;
    for (const FolderEntry& entry : list_folder(path_, filter).entries)
      all += entry.name + (entry.is_folder ? "/ " : " ");
    return all;
  }

  fs::path path_;
};

TEST_F(Folder, ListsFoldersFirstAndOfTheFilesTheKindThatIsAskedFor) {
  EXPECT_EQ(names({".json"}), "akin/ Silver/ bad.json Base.JSON other.json ");
  EXPECT_EQ(names({}), "akin/ Silver/ ") << "folders only";
  EXPECT_EQ(names({".json", true}),
            ".kept/ akin/ Silver/ .hidden.json bad.json Base.JSON other.json ");
}

TEST_F(Folder, SaysHowLargeAFileIsAndWhenItWasChanged) {
  const FolderListing listing = list_folder(path_ / "", {".json"});
  EXPECT_EQ(listing.folder, path_) << "without the slash";
  EXPECT_EQ(listing.entries[2].bytes, 12U);
  EXPECT_EQ(listing.entries[2].changed_utc.size(), std::string("2026-03-03T10:00:00Z").size());
  EXPECT_FALSE(listing.is_cut);
}

TEST_F(Folder, SaysWhyItCannotBeLookedInto) {
  for (const fs::path& wrong : {path_ / "not-there", path_ / "bad.json"}) {
    try {
      list_folder(wrong, {});
      ADD_FAILURE() << wrong;
    } catch (const FileRefused& error) {
      EXPECT_TRUE(std::string(error.what()).starts_with(wrong.string() + ": cannot be looked into"))
          << error.what();
    }
  }
}

TEST_F(Folder, CompletesWhatIsTypedAsFarAsItIsSure) {
  const FolderListing listing = list_folder(path_, {".json"});
  EXPECT_EQ(completed(listing, "o"), "other.json");
  EXPECT_EQ(completed(listing, "sil"), "Silver/") << "as it is written";
  EXPECT_EQ(completed(listing, "b"), "ba");
  EXPECT_EQ(completed(listing, "ba"), "ba") << "bad or base";
  EXPECT_EQ(completed(listing, "x"), "x");
  EXPECT_EQ(entries_from(listing, "BA").size(), 2U);
}

TEST(TypedPath, BeginsAtTheHomeUnlessItBeginsWithASlash) {
  EXPECT_EQ(typed_path("/a/b", "/srv/ada"), "/a/b");
  EXPECT_EQ(typed_path("b.json", "/srv/ada"), "/srv/ada/b.json");
  EXPECT_EQ(typed_path("~", "/srv/ada"), "/srv/ada");
  EXPECT_EQ(typed_path("~/b.json", "/srv/ada"), "/srv/ada/b.json");
}

}  // namespace
}  // namespace hallux::ui
