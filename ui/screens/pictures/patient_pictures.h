/// The patients of the course's operations, built once for all screens: the first that asks starts
/// the work, and every screen shows them from then on. Nobody waits for it: until then there is no
/// picture.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "simulator/base/progress.h"
#include "ui/screens/pictures/patient_view.h"
#include "ui/window/shell/shell.h"

namespace hallux::ui {

class PatientPictures {
 public:
  /// Makes a view beside the window; see make_patient_view.
  using Build =
      std::function<PatientView(const scenarios::Scenario& scenario, const Progress& progress)>;

  PatientPictures();
  explicit PatientPictures(Build build);

  /// The scenario's patient; nothing while it is being built, or where it could not be.
  /// thread  the window's
  const PatientView* find(Shell& shell, const scenarios::Scenario& scenario);
  /// Why it could not be built, as a sentence; "" where it was, or is being built.
  std::string fault(const scenarios::Scenario& scenario) const;

 private:
  struct Entry {
    std::shared_ptr<const PatientView> view;
    std::string fault;
  };
  using Entries = std::map<std::string, Entry>;  // by the scenario's text

  Build build_;
  std::shared_ptr<Entries> entries_;
};

/// Draws the scene once, in twice the pixels of `rect` for smooth edges, and shows what was drawn
/// from then on. `name` is another for what looks another way.
Picture still_picture(Ui& ui, Shell& shell, const std::string& name, const Rect& rect,
                      const Scene& scene, const Camera& camera);
/// The ground that goes with the theme.
Ground ground_of(const Theme& theme) noexcept;
/// The part of a picture's name that says on which ground it lies.
std::string_view ground_word(const Theme& theme) noexcept;

}  // namespace hallux::ui
