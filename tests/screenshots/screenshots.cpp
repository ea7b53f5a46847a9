// Writes the pictures of docs/cutting.md, docs/haptics.md and docs/metrics.md into a folder: the
// program behind the target `screenshots`.
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "tests/screenshots/haptics/haptic_pictures.h"
#include "tests/screenshots/kernel_pictures.h"
#include "tests/screenshots/metrics/metric_pictures.h"

namespace {

void write(const std::filesystem::path& file, const std::string& text) {
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) throw std::runtime_error(file.string() + ": cannot be written");
}

void write_all(const std::filesystem::path& folder,
               const std::vector<hallux::tests::Picture>& pictures) {
  std::filesystem::create_directories(folder);
  for (const hallux::tests::Picture& picture : pictures) {
    const std::filesystem::path file = folder / (picture.name + ".svg");
    write(file, picture.svg);
    std::cout << file.string() << ": " << picture.svg.size() / 1024 << " KiB\n";
  }
}

}  // namespace

int main(int count, char** words) {
  if (count != 2) {
    std::cerr << "usage: hallux_screenshots DIR\n";
    return 2;
  }
  try {
    const std::filesystem::path folder = words[1];
    write_all(folder, hallux::tests::kernel_pictures());
    write_all(folder / "haptics", hallux::tests::haptic_pictures());
    write_all(folder / "metrics", hallux::tests::metric_pictures());
  } catch (const std::exception& error) {
    std::cerr << "hallux_screenshots: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
