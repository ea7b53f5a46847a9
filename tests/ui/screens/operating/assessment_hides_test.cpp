// A half-sawn assessment of each operation: nothing in the picture and nothing on the panels tells
// what a surgeon would not have. Practice, sawn alike, shows that there was something to hide.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "tests/ui/screens/operating/some_operation.h"
#include "ui/widgets/ui_map.h"

namespace hallux::ui {
namespace {

using database::AttemptKind;
using testing::Contains;
using testing::IsSupersetOf;

/// Names what any picture of the operation showed beside bone, saw and chips.
class WatchedScenes : public NotedScenes {
 public:
  void draw_behind(const Scene& scene, const Camera& seen_from,
                   const StereoSetting& setting) override {
    NotedScenes::draw_behind(scene, seen_from, setting);
    note("planned face", !scene.planes.empty());
    note("line of the blade", !scene.lines.empty());
    note("danger zones", !scene.zones.empty());
    note("bone that holds", !scene.held.empty());
    note("mark", !scene.marks.empty());
    note("outline of a free piece", !scene.free_pieces.empty());
    note("another's blade", !scene.blade_ghosts.empty());
    if (!scene.halo) return;
    note("way to the bone", scene.halo->kind == HaloKind::Before || scene.halo->distance_mm > 0.0);
    note("teeth behind bone", scene.halo->kind == HaloKind::Behind);
    note("teeth on bone", scene.halo->kind == HaloKind::On);
  }

  std::set<std::string> shown;

 private:
  void note(const char* what, bool is_there) {
    if (is_there) shown.insert(what);
  }
};

class HalfSawn : public testing::TestWithParam<const char*> {
 protected:
  /// Pushes the saw on from where an operation begins, until some of the bone is open and the
  /// geometry has had time to say what it knows.
  void saw(AttemptKind kind) {
    OperableCourse course(GetParam());
    Operator person(course, kind, 1.0F, {1440.0F, 900.0F}, &scenes_);
    person.begin();
    look(person);
    // In both, the keys that show help are pressed: off and on again.
    for (const Key key : {Key::G, Key::T, Key::V, Key::G, Key::T, Key::V}) person.press(key);
    person.press(Key::Space);
    for (int step = 0; step < 60 && scenes_.patch_triangles <= 100; ++step) {
      person.press(Key::PageUp);
      look(person);
      person.until([&] { return scenes_.patch_triangles > 100; }, 0.3);
    }
    ASSERT_GT(scenes_.patch_triangles, 100U) << "nothing was cut";
    person.until(
        [&] {
          look(person);
          return kind == AttemptKind::Practice && scenes_.shown.contains("bone that holds") &&
                 read_outs_.contains("operate.hint");
        },
        kind == AttemptKind::Practice ? 30.0 : 3.0);
  }

  /// What the map of the screen tells whoever reads it.
  void look(Operator& person) {
    const auto map = nlohmann::json::parse(ui_map_json(person.driver().content(), 1.0F));
    for (const auto& each : map["read_outs"]) {
      read_outs_.insert(each["id"].get<std::string>());
      if (each["id"] == "operate.ahead") at_teeth_.insert(each["text"].get<std::string>());
      if (each["id"] == "operate.reason") reasons_.insert(each["text"].get<std::string>());
    }
    for (const auto& each : map["widgets"]) widgets_.insert(each["id"].get<std::string>());
  }

  static void expect_within(const std::set<std::string>& found,
                            const std::set<std::string>& allowed) {
    for (const std::string& each : found) EXPECT_TRUE(allowed.contains(each)) << each;
  }

  WatchedScenes scenes_;
  std::set<std::string> read_outs_, at_teeth_, reasons_, widgets_;
};

TEST_P(HalfSawn, AnAssessmentShowsOnlyWhatASurgeonWouldHave) {
  saw(AttemptKind::Assessment);
  expect_within(scenes_.shown, {"teeth on bone"});
  expect_within(at_teeth_, {"Clear of the bone", "On the bone", "In the bone"});
  EXPECT_THAT(at_teeth_, Contains("Clear of the bone"));
  expect_within(read_outs_, {"operate.time", "operate.step", "operate.reason", "operate.foot",
                             "operate.saw.state", "operate.force", "operate.force.tip",
                             "operate.ahead", "operate.tool"});
  expect_within(reasons_, {"The piece is still held."});
  for (const char* hidden : {"operate.panel.plan", "operate.panel.inset", "operate.hint"})
    EXPECT_FALSE(widgets_.contains(hidden)) << hidden;
}

TEST_P(HalfSawn, PracticeShowsWhatAnAssessmentHides) {
  saw(AttemptKind::Practice);
  EXPECT_THAT(scenes_.shown, IsSupersetOf({"planned face", "line of the blade", "danger zones",
                                           "bone that holds", "mark", "way to the bone"}));
  EXPECT_THAT(read_outs_, IsSupersetOf({"operate.plan.roll", "operate.plan.distance",
                                        "operate.heat", "operate.hint", "operate.ahead"}));
  EXPECT_THAT(widgets_, IsSupersetOf({"operate.panel.plan", "operate.panel.inset"}));
}

INSTANTIATE_TEST_SUITE_P(BothOperations, HalfSawn, testing::Values("silver", "akin"));

}  // namespace
}  // namespace hallux::ui
