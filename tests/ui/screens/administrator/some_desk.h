/// An administrator in front of one of their screens.
#pragma once

#include "tests/ui/screens/every_size.h"

namespace hallux::ui {

template <typename Shown>
struct Desk {
  explicit Desk(database::SomeCourse& of, const std::string& login = "root")
      : course(of), visitor(std::make_unique<Shown>(visit_of(of, login))) {}
  Driver& driver() { return visitor.driver(); }
  void press(std::string_view id) {
    driver().click(id);
    visitor.finish_work();
  }
  void type(std::string_view words) { driver().type(words); }

  database::SomeCourse& course;
  SomeVisitor visitor;
};

}  // namespace hallux::ui
