#include "simulator/device/falcon/falcon_firmware.h"

#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/temporary_directory.h"

namespace hallux::simulator {
namespace {

/// A boot stream with blocks of so many words.
std::vector<std::uint8_t> image_of(std::initializer_list<std::size_t> blocks) {
  std::vector<std::uint8_t> image{0xAA, 0x08};
  image.resize(22, 0);
  for (const std::size_t words : blocks) {
    image.push_back(static_cast<std::uint8_t>(words & 0xFFU));
    image.push_back(static_cast<std::uint8_t>(words >> 8U));
    image.resize(image.size() + 4 + 2 * words, 0x5A);
  }
  image.resize(image.size() + 2, 0);
  return image;
}

std::size_t byte_of_fault(const std::vector<std::uint8_t>& image) {
  const std::optional<FirmwareFault> fault = fault_in(image);
  EXPECT_TRUE(fault);
  return fault ? fault->byte : 0;
}

TEST(FalconFirmware, ABootStreamHasNoFault) { EXPECT_FALSE(fault_in(image_of({3, 300, 1}))); }

TEST(FalconFirmware, AFaultIsNamedByItsByte) {
  EXPECT_EQ(byte_of_fault({}), 0U);
  EXPECT_EQ(byte_of_fault({0x7F, 'E', 'L', 'F'}), 0U);
  EXPECT_EQ(byte_of_fault({0xAA, 0x08, 0, 0}), 4U);
  EXPECT_EQ(byte_of_fault(image_of({})), 22U);
  std::vector<std::uint8_t> cut = image_of({3, 300});
  cut.resize(cut.size() - 3);
  EXPECT_EQ(byte_of_fault(cut), 34U);
  cut = image_of({3});
  cut.resize(cut.size() - 2);
  EXPECT_EQ(byte_of_fault(cut), 34U);
  std::vector<std::uint8_t> longer = image_of({3});
  longer.push_back(0);
  EXPECT_EQ(byte_of_fault(longer), 36U);
}

TEST(FalconFirmware, IsReadFromItsFile) {
  const tests::TemporaryDirectory folder;
  const std::filesystem::path file = folder.path() / "falcon.bin";
  const std::vector<std::uint8_t> image = image_of({100});
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(image.data()),
             static_cast<std::streamsize>(image.size()));
  const FalconFirmware firmware = read_falcon_firmware(file);
  EXPECT_FALSE(firmware.fault);
  EXPECT_EQ(firmware.image, image);
}

TEST(FalconFirmware, AFileThatCannotBeReadSaysWhy) {
  const tests::TemporaryDirectory folder;
  const FalconFirmware gone = read_falcon_firmware(folder.path() / "gone.bin");
  ASSERT_TRUE(gone.fault);
  EXPECT_EQ(gone.fault->what, "No such file or directory");
  EXPECT_TRUE(read_falcon_firmware(folder.path()).fault);
  EXPECT_EQ(read_falcon_firmware("/dev/zero").fault.value().byte, falcon_firmware_bytes_most);
}

}  // namespace
}  // namespace hallux::simulator
