/// The pictures of the window in docs/pictures/window: what people see in a simulated course.
///
/// Each group signs in as one of the course, goes where a person would go, and takes pictures on
/// the way.
/// errors  std::runtime_error where a screen is not as it was: a control that is gone, work that
///         does not end
#pragma once

#include <filesystem>
#include <string>

namespace hallux::tests {

struct SimulatedCourse {
  std::filesystem::path data_directory;
  /// Of every account.
  std::string password;
};

/// A course that nobody has begun.
void take_first_start(const std::filesystem::path& empty_directory,
                      const std::filesystem::path& folder);
void take_trainee(const SimulatedCourse& course, const std::filesystem::path& folder);
/// A chevron at its end, in light.
void take_chevron_replay(const SimulatedCourse& course, const std::filesystem::path& folder);
/// Needs a bus with a Falcon that runs.
void take_devices(const SimulatedCourse& course, const std::filesystem::path& folder);
void take_flight(const SimulatedCourse& course, const std::filesystem::path& folder);
void take_operating(const SimulatedCourse& course, const std::filesystem::path& folder);
void take_operating_in_light(const SimulatedCourse& course, const std::filesystem::path& folder);
/// The tray of a chevron.
void take_tray(const SimulatedCourse& course, const std::filesystem::path& folder);
void take_instructor(const SimulatedCourse& course, const std::filesystem::path& folder);
void take_administrator(const SimulatedCourse& course, const std::filesystem::path& folder);

}  // namespace hallux::tests
