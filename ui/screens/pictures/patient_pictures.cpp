#include "ui/screens/pictures/patient_pictures.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "simulator/base/progress.h"
#include "ui/render/scene_painter.h"
#include "ui/screens/parts/value_text.h"

namespace hallux::ui {

namespace {

constexpr int largest_side = 4096;  // beyond it one pixel drawn is one shown

PixelSize pixels_of(const Ui& ui, const Rect& rect, float factor) {
  const float scale = ui.scale() * factor;
  return {static_cast<int>(std::lround(rect.w * scale)),
          static_cast<int>(std::lround(rect.h * scale))};
}

/// Lines are as wide as they are in the window, whatever the pixels.
Scene with_lines(const Scene& scene, float factor) {
  Scene scaled = scene;
  for (CuttingLine& line : scaled.lines) line.width_pixels *= static_cast<double>(factor);
  for (PlaneGhost& plane : scaled.planes) plane.line_pixels *= static_cast<double>(factor);
  return scaled;
}

}  // namespace

PatientPictures::PatientPictures()
    : PatientPictures([](const scenarios::Scenario& scenario, const Progress& progress) {
        return make_patient_view(scenario, progress);
      }) {}

PatientPictures::PatientPictures(Build build)
    : build_(std::move(build)), entries_(std::make_shared<Entries>()) {}

const PatientView* PatientPictures::find(Shell& shell, const scenarios::Scenario& scenario) {
  const auto known = entries_->find(scenario.text);
  if (known != entries_->end()) return known->second.view.get();
  entries_->emplace(scenario.text, Entry{});
  auto built = std::make_shared<std::shared_ptr<const PatientView>>();
  // Without a label, since nobody waits for it.
  shell.background().start(
      {},
      [built, scenario, build = build_](WorkReport& report) {
        const auto go_on = [&](double share) { return report.reached(share); };
        *built = std::make_shared<const PatientView>(build(scenario, go_on));
      },
      [built, entries = entries_, text = scenario.text](WorkEnd end, const std::string& reason) {
        if (end == WorkEnd::Failed) (*entries)[text].fault = sentence_of(reason);
        if (end == WorkEnd::Done) (*entries)[text].view = std::move(*built);
      });
  return nullptr;
}

std::string PatientPictures::fault(const scenarios::Scenario& scenario) const {
  const auto known = entries_->find(scenario.text);
  return known == entries_->end() ? std::string() : known->second.fault;
}

Picture still_picture(Ui& ui, Shell& shell, const std::string& name, const Rect& rect,
                      const Scene& scene, const Camera& camera) {
  float factor = 2.0F;
  PixelSize size = pixels_of(ui, rect, factor);
  if (std::max(size.width, size.height) > largest_side) {
    factor = 1.0F;
    size = pixels_of(ui, rect, factor);
  }
  std::uint64_t texture = shell.scenes().drawn(name, size);
  if (texture == 0) {
    texture = shell.scenes().draw(name, with_lines(scene, ui.scale() * factor), camera, size);
  }
  return {texture};
}

Ground ground_of(const Theme& theme) noexcept {
  return theme.is_dark() ? Ground::Dark : Ground::Light;
}

std::string_view ground_word(const Theme& theme) noexcept {
  return theme.is_dark() ? "dark" : "light";
}

}  // namespace hallux::ui
