#include "tests/ui/screens/every_size.h"

#include <gtest/gtest.h>

#include <array>
#include <regex>
#include <utility>

namespace hallux::ui {

namespace {

Visitor somebody() {
  Visitor visitor;
  visitor.name = "Somebody";
  visitor.role = "Administrator";
  visitor.initials = "S";
  visitor.places = {{"nav.people", "People", Icon::People, 0}};
  return visitor;
}

}  // namespace

std::vector<std::string> faults_at_every_size(const std::function<std::unique_ptr<Screen>()>& make,
                                              const std::function<void(SomeVisitor&)>& prepare) {
  constexpr std::array<std::pair<float, float>, 3> windows{
      {{1280.0F, 720.0F}, {1920.0F, 1080.0F}, {3840.0F, 2160.0F}}};
  std::vector<std::string> faults;
  for (const float scale : {0.8F, 1.0F, 1.5F, 2.0F}) {
    SomeVisitor visitor(make(), scale);
    visitor.shell().set_visitor(somebody());
    if (prepare) prepare(visitor);
    for (const ThemeName theme : {ThemeName::Dark, ThemeName::Light}) {
      visitor.shell().preferences().theme = theme;
      for (const auto& [width, height] : windows) {
        visitor.driver().resize(width, height);
        visitor.finish_work();
        for (const std::string& fault : visitor.driver().faults())
          faults.push_back(std::to_string(scale) + ", " + std::to_string(width) + ": " + fault);
      }
    }
  }
  return faults;
}

bool shows_word(const Driver& driver, const std::string& word) {
  const std::regex wanted("\\b" + word + "\\b");
  for (const std::string& text : driver.texts())
    if (std::regex_search(text, wanted)) return true;
  return false;
}

std::string all_text(const Driver& driver) {
  std::string words;
  for (const std::string& text : driver.texts()) words += text + " ";
  return words;
}

void press_by_keyboard(SomeVisitor& visitor, const std::string& id) {
  for (int tab = 0; tab < 80 && visitor.driver().focused() != id; ++tab)
    visitor.driver().press(Key::Tab);
  ASSERT_EQ(visitor.driver().focused(), id) << "Tab does not come there";
  visitor.driver().press(Key::Enter);
  visitor.finish_work();
}

}  // namespace hallux::ui
