#include "tests/screenshots/window/course_pictures.h"
#include "tests/screenshots/window/photographer.h"

namespace hallux::tests {

void take_first_start(const std::filesystem::path& empty_directory,
                      const std::filesystem::path& folder) {
  Photographer photographer(empty_directory, folder, ui::ThemeName::Dark);
  photographer.take("first_start");
}

void take_trainee(const SimulatedCourse& course, const std::filesystem::path& folder) {
  Photographer photographer(course.data_directory, folder, ui::ThemeName::Dark);
  photographer.take("sign_in");
  photographer.sign_in("trainee-1", course.password);
  photographer.take("operations");
  photographer.press("operations.card.silver");
  photographer.take("briefing");
  photographer.press("nav.history");
  photographer.take("history");
  photographer.sign_in("trainee-2", course.password);
  photographer.press("nav.history");
  photographer.press(photographer.first("history.list."));
  photographer.take("result");
  photographer.press("result.take.0.action");
  photographer.take("replay");
  photographer.press("nav.questions");
  photographer.take("questions");
}

void take_chevron_replay(const SimulatedCourse& course, const std::filesystem::path& folder) {
  Photographer photographer(course.data_directory, folder, ui::ThemeName::Light);
  photographer.sign_in("trainee-1", course.password);
  photographer.press("nav.history");
  // What was operated last comes first: the chevron is the third.
  photographer.press("history.operation.2");
  photographer.press(photographer.first("history.list."));
  photographer.press("result.replay");
  photographer.key(ui::Key::End);
  photographer.take("replay_chevron");
}

}  // namespace hallux::tests
