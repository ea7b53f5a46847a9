// Takes the pictures of the window into a folder: the second program behind the target
// `screenshots`.
#include <exception>
#include <filesystem>
#include <iostream>
#include <string_view>

#include "tests/database/some_database.h"
#include "tests/screenshots/window/course_pictures.h"
#include "ui/jobs/demo/demo_course.h"

namespace {

using hallux::tests::SimulatedCourse;

SimulatedCourse make_course(const std::filesystem::path& directory) {
  const hallux::ui::StageProgress progress = [](const std::string& stage) {
    std::cout << stage << std::endl;
    return [](double) { return true; };
  };
  return {directory, hallux::ui::make_demo_course(directory, {}, progress).password};
}

}  // namespace

int main(int count, char** words) {
  if (count != 2 && count != 4) {
    std::cerr
        << "usage: hallux_window_screenshots DIR [COURSE PASSWORD]\n"
           "COURSE is a directory that `hallux demo` filled: a copy, for attempts are made in it; "
           "without one it is filled here.\n";
    return 2;
  }
  try {
    const std::filesystem::path folder = words[1];
    std::filesystem::create_directories(folder);
    const hallux::database::TemporaryDirectory empty, made;
    const SimulatedCourse course =
        count == 4 ? SimulatedCourse{words[2], words[3]} : make_course(made.data());
    hallux::tests::take_first_start(empty.data(), folder);
    hallux::tests::take_trainee(course, folder);
    hallux::tests::take_chevron_replay(course, folder);
    hallux::tests::take_instructor(course, folder);
    hallux::tests::take_administrator(course, folder);
    hallux::tests::take_devices(course, folder);
    hallux::tests::take_flight(course, folder);
    hallux::tests::take_operating(course, folder);
    hallux::tests::take_operating_in_light(course, folder);
    hallux::tests::take_tray(course, folder);
  } catch (const std::exception& error) {
    std::cerr << "hallux_window_screenshots: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
