/// Output files that somebody names: what is kept and what belongs to others is never replaced.
#pragma once

#include <filesystem>
#include <string_view>

namespace hallux::ui {

/// What an output holds. A file with its name that begins otherwise is somebody else's and stays.
struct OutputKind {
  /// With its article: "a report".
  std::string_view name;
  std::string_view beginning;
  /// Only its owner may read it: 0600.
  bool is_of_people = false;
};

inline constexpr OutputKind report_page{"a report", "<!DOCTYPE html>\n<html lang=\"en\"><head>",
                                        true};
inline constexpr OutputKind ui_map_page{"a map of the window", "{\n \"focus\": ", true};
inline constexpr OutputKind piece_mesh{
    "a piece of a cut", "ply\nformat binary_little_endian 1.0\ncomment millimetres\n"};

/// Whether the file is empty or begins as an output of this kind does.
bool may_be_replaced(const std::filesystem::path& file, const OutputKind& kind);

/// Where an output may go: outside the data directory, and in the place of nothing, of an empty
/// file, or of an older one of its kind.
/// errors  OutputError Name; database::DatabaseError BadInput
void check_output(const std::filesystem::path& file, const OutputKind& kind,
                  const std::filesystem::path& data_directory);

/// Writes it where it may go, whole or not at all.
/// errors  as check_output; OutputError naming the file; nothing is left behind
void write_output(const std::filesystem::path& file, std::string_view bytes, const OutputKind& kind,
                  const std::filesystem::path& data_directory);

/// Writes a file that is ours as a whole, 0600: what was there before stays until the new one is
/// complete.
/// errors  OutputError naming the file; nothing is left behind, and no other file is touched
void replace_own_file(const std::filesystem::path& file, std::string_view bytes);

}  // namespace hallux::ui
