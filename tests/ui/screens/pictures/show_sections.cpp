// Draws the sections in a blade's plane into a folder, for eyes: show_blade_sections FOLDER. No
// test compares these files.
#include <cstdio>
#include <filesystem>
#include <string>

#include "scenarios/plan.h"
#include "simulator/cutting/field/region_outline.h"
#include "tests/ui/widgets/driver.h"
#include "ui/render/gl/headless_context.h"
#include "ui/render/imgui_painter.h"
#include "ui/render/picture.h"
#include "ui/screens/pictures/blade_section_view.h"
#include "ui/screens/pictures/planned_frame.h"
#include "ui/screens/pictures/planned_passes_picture.h"
#include "ui/widgets/shapes.h"

namespace {

using namespace hallux;
using namespace hallux::ui;

constexpr float side = 260.0F, gap = 20.0F;

/// A scenario's bone, with the blade in the plane of its first cut.
struct Site {
  scenarios::Scenario scenario;
  simulator::Bone bone = make_patient_bones(scenario).front();
  scenarios::Plan plan = plan_on(scenario, bone);
  simulator::CutSolid solid = simulator::uncut_solid(solid_of(bone));
  simulator::Bvh tree{solid.mesh};

  explicit Site(const char* name) : scenario(scenarios::load_shipped_scenario(name)) {}

  simulator::KerfPlane plane() const {
    const scenarios::PlannedCut& cut = plan.cuts.front();
    Vec3 feed = name() == "silver" ? Vec3(0.0, -1.0, 0.0) : Vec3(0.0, 0.0, 1.0);
    feed = glm::normalize(feed - glm::dot(feed, cut.face.normal) * cut.face.normal);
    return {{rotation_from_axes(feed, glm::cross(cut.face.normal, feed)),
             planned_face(solid, tree, bone_from_planned(cut), cut.depth_point_in_bone_mm)
                 .bone_from_face.translation_mm},
            0.5};
  }
  const std::string& name() const { return scenario.name; }

  /// After the strokes at these places along the teeth, so deep, with the blade at the last.
  BladeSection section(const std::vector<Vec2>& strokes) const {
    const simulator::KerfPlane at = plane();
    simulator::KerfField field{{.origin_mm = Vec2(-40.0, -40.0)}};
    simulator::FieldWindow changed;
    for (const Vec2& stroke : strokes) {
      field.stamp(scenario.saw.blade, {Vec2(-30.0, stroke.y), Vec2(1.0, 0.0)},
                  {stroke, Vec2(1.0, 0.0)}, changed);
    }
    const KerfSection made =
        kerf_section(solid, tree, {at, loops_of(simulator::outline_of(field))});
    const RigidTransform bone_from_tool =
        at.bone_from_kerf * RigidTransform{Quat(1.0, 0.0, 0.0, 0.0), Vec3(strokes.back(), 0.0)};
    return blade_section(made, bone_from_tool, scenario.saw.blade, &plan);
  }
};

struct Shown {
  std::vector<BladeSection> sections;
  /// As a briefing lays them out.
  std::vector<PassesInView> passes;
};

Rect place_of(std::size_t index) {
  const std::size_t row = index / 4;
  return {gap + static_cast<float>(index % 4) * (side + gap),
          gap + static_cast<float>(row) * (side + gap), side, side};
}

void draw_sections(Ui& ui, const Shown& shown) {
  ui.canvas().fill(ui.display(), ui.theme().page);
  for (std::size_t i = 0; i < shown.sections.size(); ++i) {
    draw_hud_panel(ui.canvas(), ui.theme(), place_of(i));
    draw_blade_section(ui, inset(place_of(i), 8.0F), shown.sections[i]);
  }
  for (std::size_t i = 0; i < shown.passes.size(); ++i) {
    const Rect place = place_of(shown.sections.size() + i);
    draw_hud_panel(ui.canvas(), ui.theme(), place);
    draw_passes(ui, inset(place, 8.0F), shown.passes[i]);
  }
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) {
    std::fprintf(stderr, "usage: show_blade_sections FOLDER\n");
    return 2;
  }
  const std::filesystem::path folder = arguments[1];
  std::filesystem::create_directories(folder);
  Shown shown;
  std::vector<BladeSection>& sections = shown.sections;
  for (const char* name : {"silver", "akin"}) {
    const Site site(name);
    sections.push_back(site.section({{-22.0, 0.0}}));
    sections.push_back(site.section({{-4.0, -5.0}}));
    sections.push_back(site.section({{5.0, -5.0}, {1.0, 4.0}}));
    sections.push_back(site.section({{20.0, -9.0}, {20.0, 0.0}, {7.0, 9.0}}));
    for (std::size_t cut = 0; cut < site.plan.cuts.size(); ++cut)
      shown.passes.push_back(passes_in_view(site.scenario, site.plan, cut, site.solid, site.tree));
  }
  const Texts texts = english_texts();
  for (const ThemeName theme : {ThemeName::Dark, ThemeName::Light}) {
    const HeadlessContext context;
    const RenderTarget target({1140, 860});
    Driver driver(texts, [&](Ui& ui) { draw_sections(ui, shown); }, {1140.0F, 860.0F, 1.0F, theme});
    driver.wait(1.0);
    ImguiPainter painter;
    const BoundFramebuffer bound(target.target().framebuffer);
    painter.draw(driver.ui().draw_data(), driver.ui().fonts_version());
    write_png(folder / (theme == ThemeName::Dark ? "sections-dark.png" : "sections-light.png"),
              target.read());
  }
  return 0;
}
