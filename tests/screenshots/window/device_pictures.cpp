// A device that is tried in the hand. It is served on a bus of modelled ones, which the target
// starts around the program (tests/support/served_bus).
#include <algorithm>
#include <array>
#include <fstream>

#include "tests/screenshots/window/course_pictures.h"
#include "tests/screenshots/window/photographer.h"
#include "ui/jobs/devices/devices_file.h"

namespace hallux::tests {

namespace {

/// Any boot stream: whatever it is sent makes the modelled Falcon run, and this one runs already.
std::filesystem::path write_firmware(const std::filesystem::path& folder) {
  constexpr std::size_t words = 3900, head_bytes = 28;
  std::array<char, head_bytes + 2 * words + 2> bytes{};
  bytes[0] = static_cast<char>(0xAA);
  bytes[1] = 0x08;
  bytes[22] = static_cast<char>(words & 0xFFU);
  bytes[23] = static_cast<char>(words >> 8U);
  std::filesystem::path file = folder / "falcon.bin";
  std::ofstream(file, std::ios::binary).write(bytes.data(), bytes.size());
  return file;
}

}  // namespace

void take_devices(const SimulatedCourse& course, const std::filesystem::path& folder) {
  ui::set_device(course.data_directory, "falcon", "firmware",
                 write_firmware(course.data_directory).string());
  Photographer photographer(course.data_directory, folder, ui::ThemeName::Dark);
  photographer.sign_in("administrator", course.password);
  photographer.press("nav.devices");
  photographer.press("devices.row.falcon");
  photographer.press("devices.feel");
  photographer.wait_until("the Falcon at home", [&] {
    const auto& told = photographer.driver().content().read_outs;
    return std::ranges::any_of(told, [](const ui::ReadOut& each) {
      return each.id == "devices.felt" && !each.text.starts_with("x 0.0   y 0.0   z 0.0");
    });
  });
  photographer.work_for(1.0);
  photographer.take_now("devices");
}

}  // namespace hallux::tests
