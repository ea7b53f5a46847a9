// Somebody operates, in real time, and is looked at meanwhile.
#include "tests/screenshots/window/course_pictures.h"
#include "tests/screenshots/window/photographer.h"

namespace hallux::tests {

namespace {

using ui::Key;

void press(Photographer& photographer, Key key, int times, ui::Modifiers modifiers = {}) {
  for (int count = 0; count < times; ++count) photographer.key(key, modifiers);
}

/// From where the saw is held at first, seen from medial, to the planned plane, by what the panel
/// says of it.
void lay_on_plan(Photographer& photographer) {
  photographer.key(Key::Enter);  // the case is verified
  photographer.key(Key::Digit3);
  press(photographer, Key::Up, 5, {.control = true});
  press(photographer, Key::Left, 2, {.control = true});
  press(photographer, Key::Right, 9);
  press(photographer, Key::PageUp, 1);
  press(photographer, Key::PageDown, 2, {.shift = true});
}

/// Leads the running saw a millimetre a press, one after the other.
void saw(Photographer& photographer, Key key, int millimetres) {
  photographer.key(Key::I);  // the assistant rinses
  photographer.key(Key::Space);
  for (int step = 0; step < millimetres; ++step) {
    photographer.key(key);
    photographer.work_for(0.1);
  }
}

void begin(Photographer& photographer, const std::string& scenario) {
  ui::Driver& driver = photographer.driver();
  photographer.press("operations.card." + scenario);
  photographer.press("brief.begin");
  photographer.wait_until("the patient", [&] { return driver.has("operate.begin"); });
  photographer.key(Key::Enter);
  photographer.wait_until("the operation", [&] { return driver.has("operate.pause"); });
}

}  // namespace

void take_flight(const SimulatedCourse& course, const std::filesystem::path& folder) {
  Photographer photographer(course.data_directory, folder, ui::ThemeName::Dark);
  ui::Driver& driver = photographer.driver();
  photographer.sign_in("trainee-1", course.password);
  photographer.press("operations.fly");
  photographer.wait_until("the flight", [&] { return driver.has("flight.skip"); });
  photographer.key(Key::Digit1);
  photographer.wait_until("the next lesson", [&] { return driver.sees("ring on the block"); });
  photographer.key(Key::R);
  photographer.work_for(1.0);
  photographer.take_now("flight");
}

void take_operating(const SimulatedCourse& course, const std::filesystem::path& folder) {
  Photographer photographer(course.data_directory, folder, ui::ThemeName::Dark);
  photographer.sign_in("trainee-1", course.password);
  begin(photographer, "silver");
  lay_on_plan(photographer);
  saw(photographer, Key::Down, 36);
  photographer.key(Key::R);  // as one stood at first
  photographer.work_for(6.0);
  photographer.take_now("operating");
  photographer.key(Key::F9);
  photographer.take_now("side_by_side");
  photographer.key(Key::F9);
  photographer.take_now("anaglyph");
}

void take_tray(const SimulatedCourse& course, const std::filesystem::path& folder) {
  Photographer photographer(course.data_directory, folder, ui::ThemeName::Dark);
  photographer.sign_in("trainee-1", course.password);
  begin(photographer, "chevron");
  photographer.key(Key::Enter);  // the case is verified
  photographer.key(Key::B);
  photographer.work_for(1.0);
  photographer.take_now("tray");
}

void take_operating_in_light(const SimulatedCourse& course, const std::filesystem::path& folder) {
  Photographer photographer(course.data_directory, folder, ui::ThemeName::Light);
  photographer.sign_in("trainee-1", course.password);
  begin(photographer, "akin");
  photographer.key(Key::Enter);  // the case is verified
  saw(photographer, Key::PageUp, 26);
  photographer.work_for(6.0);
  photographer.take_now("operating_light");
}

}  // namespace hallux::tests
