// A folder is read once and sorted; what cannot be asked about an entry (a link to nowhere) leaves
// it out or without its date, because one bad entry must not hide the others.
#include "ui/jobs/files/folder_listing.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <chrono>
#include <cstdlib>
#include <ctime>

#include "ui/jobs/files/read_small_file.h"

namespace hallux::ui {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t listed_most = 5000;

char small(char letter) noexcept {
  return static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
}

bool is_same_letter(char a, char b) noexcept { return small(a) == small(b); }

bool begins_with(std::string_view name, std::string_view start) noexcept {
  return name.size() >= start.size() &&
         std::equal(start.begin(), start.end(), name.begin(), is_same_letter);
}

bool ends_with(std::string_view name, std::string_view ending) noexcept {
  return name.size() > ending.size() &&
         std::equal(ending.rbegin(), ending.rend(), name.rbegin(), is_same_letter);
}

std::string utc_of(fs::file_time_type changed) {
  const auto system = std::chrono::file_clock::to_sys(changed);
  const std::time_t second = std::chrono::system_clock::to_time_t(
      std::chrono::time_point_cast<std::chrono::system_clock::duration>(system));
  std::tm fields{};
  if (gmtime_r(&second, &fields) == nullptr) return {};
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &fields);
  return text.data();
}

/// False where the entry is not asked for.
bool read_entry(const fs::directory_entry& found, const ListingFilter& filter, FolderEntry& entry) {
  std::error_code fault;
  entry.name = found.path().filename().string();
  if (!filter.with_hidden && entry.name.starts_with('.')) return false;
  entry.is_folder = found.is_directory(fault);
  if (!entry.is_folder) {
    const bool is_wanted = !filter.ending.empty() && ends_with(entry.name, filter.ending) &&
                           found.is_regular_file(fault);
    if (!is_wanted) return false;
    const std::uintmax_t bytes = found.file_size(fault);
    entry.bytes = fault ? 0 : bytes;
  }
  const fs::file_time_type changed = found.last_write_time(fault);
  if (!fault) entry.changed_utc = utc_of(changed);
  return true;
}

bool comes_before(const FolderEntry& a, const FolderEntry& b) {
  if (a.is_folder != b.is_folder) return a.is_folder;
  const bool is_same = a.name.size() == b.name.size() && begins_with(a.name, b.name);
  if (is_same) return a.name < b.name;
  return std::lexicographical_compare(a.name.begin(), a.name.end(), b.name.begin(), b.name.end(),
                                      [](char x, char y) { return small(x) < small(y); });
}

}  // namespace

FolderListing list_folder(const fs::path& folder, const ListingFilter& filter) {
  FolderListing listing;
  listing.folder = folder.has_filename() ? folder : folder.parent_path();
  std::error_code fault;
  fs::directory_iterator next(listing.folder, fault);
  const auto refuse = [&](const std::string& what) {
    throw FileRefused(listing.folder.string() + ": " + what + "; choose another folder");
  };
  if (fault) refuse("cannot be looked into (" + fault.message() + ")");
  for (; next != fs::directory_iterator() && !listing.is_cut; next.increment(fault)) {
    if (fault) refuse("could be read in part only (" + fault.message() + ")");
    FolderEntry entry;
    if (read_entry(*next, filter, entry)) listing.entries.push_back(std::move(entry));
    listing.is_cut = listing.entries.size() == listed_most;
  }
  std::sort(listing.entries.begin(), listing.entries.end(), comes_before);
  return listing;
}

fs::path typed_path(std::string_view typed, const fs::path& home) {
  if (typed == "~") return home;
  if (typed.starts_with("~/")) return home / typed.substr(2);
  const fs::path path(typed);
  return path.is_absolute() ? path : home / path;
}

fs::path home_folder() {
  const char* home = std::getenv("HOME");
  return home != nullptr && home[0] == '/' ? home : "/";
}

std::vector<const FolderEntry*> entries_from(const FolderListing& listing, std::string_view start) {
  std::vector<const FolderEntry*> found;
  for (const FolderEntry& entry : listing.entries)
    if (begins_with(entry.name, start)) found.push_back(&entry);
  return found;
}

std::string completed(const FolderListing& listing, std::string_view start) {
  const std::vector<const FolderEntry*> found = entries_from(listing, start);
  if (found.empty()) return std::string(start);
  if (found.size() == 1) return found.front()->name + (found.front()->is_folder ? "/" : "");
  std::string common = found.front()->name;
  for (const FolderEntry* entry : found) {
    const auto differs = std::mismatch(common.begin(), common.end(), entry->name.begin(),
                                       entry->name.end(), is_same_letter);
    common.erase(differs.first, common.end());
  }
  // Where only the case differs, what was typed stays.
  return common.size() > start.size() ? common : std::string(start);
}

}  // namespace hallux::ui
