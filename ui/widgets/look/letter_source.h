/// Letters drawn by FreeType, one at a time, from whichever font file has them.
/// Inside this corner only.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <vector>

namespace hallux::ui {

/// A letter's coverage, 0 to 255, by rows from its top; device pixels from the pen on the baseline.
struct LetterPicture {
  int left = 0, top = 0, width = 0, height = 0;
  /// Unrounded.
  float advance = 0.0F;
  std::vector<std::uint8_t> coverage;
};

class LetterSource {
 public:
  /// errors  std::runtime_error where FreeType does not start
  LetterSource();
  LetterSource(const LetterSource&) = delete;
  LetterSource& operator=(const LetterSource&) = delete;
  ~LetterSource();

  /// The first of the files that has the letter; null where none has, and for a file that is no
  /// font that can be drawn in any size.
  const std::filesystem::path* file_with(char32_t letter,
                                         std::span<const std::filesystem::path> files);

  /// Draws it so that an em has so many device pixels; without coverage where it has no ink.
  /// needs   the file has the letter
  LetterPicture draw(const std::filesystem::path& file, char32_t letter, float em);

 private:
  struct Faces;
  std::unique_ptr<Faces> faces_;
};

}  // namespace hallux::ui
