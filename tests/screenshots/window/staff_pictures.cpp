// What those see who teach a cohort and who administer the course.
#include "tests/screenshots/window/course_pictures.h"
#include "tests/screenshots/window/photographer.h"

namespace hallux::tests {

void take_instructor(const SimulatedCourse& course, const std::filesystem::path& folder) {
  Photographer photographer(course.data_directory, folder, ui::ThemeName::Light);
  photographer.sign_in("instructor-1", course.password);
  photographer.take("cohort");
  photographer.press("cohort.row.trainee-1");
  photographer.take("trainee");
  photographer.press(photographer.first("trainee.row."));
  photographer.press("result.decide");
  photographer.take("decide");
  photographer.press("decide.keep");
  photographer.press("result.replay");
  photographer.press("replay.next");
  photographer.press("replay.pin");
  photographer.driver().type("Here the blade leans on the head. Let the teeth do the work.");
  photographer.take("note");
  photographer.driver().press(ui::Key::Escape);
  photographer.press("nav.inbox");
  photographer.take("inbox");
}

void take_administrator(const SimulatedCourse& course, const std::filesystem::path& folder) {
  Photographer photographer(course.data_directory, folder, ui::ThemeName::Light);
  photographer.sign_in("administrator", course.password);
  photographer.press("people.row.trainee-1");
  photographer.take("people");
  photographer.press("people.add");
  photographer.press("people.add.login");
  photographer.driver().type("trainee-9");
  photographer.press("people.add.act");
  photographer.take("one_time_code");
  photographer.press("people.code.done");
  photographer.press("nav.cohorts");
  photographer.take("cohorts");
  photographer.press("nav.scenarios");
  photographer.take("scenarios");
  photographer.press("nav.records");
  photographer.take("records");
}

}  // namespace hallux::tests
