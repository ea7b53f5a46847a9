/// A fuzz target without a fuzzer: feeds it every file of a corpus folder, what is left when each
/// is cut short, and each with a byte altered. The same bytes in every run; for ordinary builds,
/// where there is no libFuzzer.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size);

namespace {

constexpr std::size_t cuts = 16, alterations = 64;

std::vector<std::uint8_t> content_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

void feed(const std::vector<std::uint8_t>& bytes, std::size_t size) {
  // A copy of its own size, so that a sanitizer sees a byte read too far.
  const std::vector<std::uint8_t> exact(bytes.begin(),
                                        bytes.begin() + static_cast<std::ptrdiff_t>(size));
  LLVMFuzzerTestOneInput(exact.data(), exact.size());
}

void feed_variants(std::vector<std::uint8_t> bytes) {
  for (std::size_t i = 0; i <= cuts; ++i) feed(bytes, bytes.size() * i / cuts);
  for (std::size_t i = 0; i < alterations && !bytes.empty(); ++i) {
    std::uint8_t& altered = bytes[bytes.size() * i / alterations];
    const std::uint8_t before = altered;
    altered = static_cast<std::uint8_t>(before ^ (1U << (i % 8)));
    feed(bytes, bytes.size());
    altered = before;
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: %s CORPUS_FOLDER\n", argv[0]);
    return 2;
  }
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(argv[1])) {
    feed_variants(content_of(entry.path()));
    ++files;
  }
  std::printf("%zu files\n", files);
  return files > 0 ? 0 : 1;
}
