/// What is in a folder, as somebody looks through it who chooses a file or a place for one.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace hallux::ui {

struct FolderEntry {
  std::string name;
  bool is_folder = false;
  /// Of a file.
  std::uintmax_t bytes = 0;
  /// ISO 8601; "" where the file system does not say.
  std::string changed_utc;
};

struct FolderListing {
  /// Absolute, without a slash at its end but for the root.
  std::filesystem::path folder;
  /// Folders first, then files, each by name whatever the case.
  std::vector<FolderEntry> entries;
  /// There are more than are listed.
  bool is_cut = false;
};

struct ListingFilter {
  /// Of the files, ".json"; "": folders only.
  std::string ending = {};
  /// What begins with a dot as well.
  bool with_hidden = false;
};

/// At most five thousand entries.
/// errors  FileRefused: the folder is not there, is none, or may not be read
/// thread  any; a folder on a network may take long
FolderListing list_folder(const std::filesystem::path& folder, const ListingFilter& filter);

/// A path as somebody types it: `~` is their home, one that does not begin with a slash begins
/// there.
std::filesystem::path typed_path(std::string_view typed, const std::filesystem::path& home);
/// The home of whoever sits at this machine; "/" where nobody says.
std::filesystem::path home_folder();

/// The entries whose name begins with `start`, whatever the case.
std::vector<const FolderEntry*> entries_from(const FolderListing& listing, std::string_view start);
/// How far those entries go on alike from `start`, with a slash behind a folder that is the only
/// one;
/// `start` itself where there is nothing to go on with.
std::string completed(const FolderListing& listing, std::string_view start);

}  // namespace hallux::ui
