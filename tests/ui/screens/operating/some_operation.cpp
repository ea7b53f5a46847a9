#include "tests/ui/screens/operating/some_operation.h"

#include <algorithm>
#include <chrono>
#include <thread>

#include "simulator/base/progress.h"
#include "tests/ui/screens/some_visitor.h"

namespace hallux::ui {

namespace {

/// Of a clock by which an instrumented program on a busy machine is in time too.
#ifdef __SANITIZE_THREAD__
constexpr double patience = 8.0;
#else
constexpr double patience = 1.0;
#endif

/// Below the operating screen, as a briefing is.
class ScreenBelow : public Screen {
 public:
  GuideSection guide_section() const override { return GuideSection::Overview; }
  void draw(Ui&, const Rect&, Shell&) override {}
};

std::string coarse_text(const std::string& scenario, double edge_mm) {
  std::string text = scenarios::load_shipped_scenario(scenario).text;
  const std::string fine = "\"edge_mm\": 0.3";
  const std::size_t at = text.find(fine);
  EXPECT_NE(at, std::string::npos);
  return text.replace(at, fine.size(), "\"edge_mm\": " + std::to_string(edge_mm));
}

}  // namespace

void NotedScenes::draw_behind(const Scene& scene, const Camera& seen_from,
                              const StereoSetting& setting) {
  ++pictures;
  bones = scene.bones.size();
  planes = scene.planes.size();
  lines = scene.lines.size();
  chips = scene.chips.size();
  patch_triangles = 0;
  for (const BoneInScene& bone : scene.bones) {
    ASSERT_NE(bone.mesh, nullptr);
    if (bone.patch == nullptr) continue;
    patch_triangles += bone.patch->triangles.size();
    // A patch lies on the mesh that it was built on, whenever it is drawn.
    for (const std::uint32_t hidden : bone.patch->hidden) {
      ASSERT_LT(hidden, bone.mesh->solid.mesh.triangles.size());
    }
  }
  saw = scene.saw;
  camera = seen_from;
  stereo = setting;
}

OperableCourse::OperableCourse(const std::string& scenario, double edge_mm, std::string vfs_name)
    : vfs_name_(std::move(vfs_name)) {
  database::AdministratorDesk desk = course_.administrator();
  version_ = desk.import_scenario({scenario + "_coarse", 1, coarse_text(scenario, edge_mm), false});
  desk.publish_scenario(version_);
}

std::shared_ptr<SignedInSession> OperableCourse::visit_of_ada() {
  database::OpenOptions options;
  options.vfs_name = vfs_name_;
  return visit_of(course_, "ada", options);
}

database::AttemptHeader OperableCourse::attempt() {
  EXPECT_EQ(database::list_attempts(course_.database()).size(), 1U);
  return newest_attempt();
}

database::AttemptHeader OperableCourse::newest_attempt() {
  // Whoever opens the file sees what became of attempts whose writer is gone.
  database::Database again = database::Database::open(course_.database().directory());
  const std::vector<database::AttemptHeader> all = database::list_attempts(again);
  const auto newest = std::ranges::max_element(
      all, {}, [](const database::AttemptHeader& each) { return each.started_utc; });
  EXPECT_NE(newest, all.end());
  return newest == all.end() ? database::AttemptHeader{} : *newest;
}

std::shared_ptr<const PreparedCase> OperableCourse::prepared_case(SignedInSession& signed_in) {
  return signed_in.in_turn([&](database::Session&, database::Database& database) {
    const database::ScenarioText text = database::get_scenario_version(database, version_);
    return std::make_shared<const PreparedCase>(
        prepare_case(scenarios::parse_scenario(text.json, text.name), no_progress));
  });
}

bool soon(const std::function<bool()>& holds) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (!holds()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return true;
}

Progress no_progress(const std::string&) { return {}; }

LentHands some_mouse(const HandStart& start, const Progress&) {
  return {std::make_unique<simulator::MouseDevice>(start.world_from_tool)};
}

Operator::Operator(OperableCourse& course, database::AttemptKind kind, float scale, Point size,
                   ScenePainter* painter, LendHands lend) {
  open(
      std::make_unique<OperatingScreen>(course.visit_of_ada(), navigator,
                                        OperationChoice{course.version(), {kind}}, std::move(lend)),
      scale, size, painter);
  EXPECT_TRUE(until([&] { return driver_->has("operate.begin"); }, 60.0));
}

Operator::Operator(std::unique_ptr<Screen> screen, float scale, Point size) {
  open(std::move(screen), scale, size, nullptr);
}

void Operator::open(std::unique_ptr<Screen> screen, float scale, Point size,
                    ScenePainter* painter) {
  DriverSetting setting;
  setting.width = size.x * scale;
  setting.height = size.y * scale;
  setting.scale = scale;
  shell_->set_display_scale(scale);
  shell_->preferences().is_motion_reduced = true;
  // Whoever runs the tests has not asked to hear them.
  shell_->preferences().is_saw_heard = false;
  shell_->push(std::make_unique<ScreenBelow>());
  shell_->push(std::move(screen));
  driver_ = std::make_unique<Driver>(
      texts_,
      [this, painter](Ui& ui) {
        if (shell_ != nullptr) shell_->draw(ui, painter == nullptr ? scenes : *painter);
      },
      setting);
}

Operator::~Operator() = default;

void Operator::make_frames(int count) {
  for (int i = 0; i < count; ++i) driver_->frame();
}

bool Operator::until(const std::function<bool()>& holds, double seconds) {
  const auto end =
      std::chrono::steady_clock::now() + patience * std::chrono::duration<double>(seconds);
  while (!holds()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    driver_->frame(0.005);
  }
  return true;
}

void Operator::press(Key key, Modifiers modifiers) {
  driver_->send(key_events(key, modifiers));
  make_frames(3);
}

void Operator::click(std::string_view id) {
  if (!driver_->ui().captured_by().empty()) {
    press(Key::L);
    make_frames(2);
  }
  const Rect place = driver_->widget(id).visible;
  driver_->send(
      click_events({place.mid_x() * driver_->ui().scale(), place.mid_y() * driver_->ui().scale()}));
  make_frames(6);
}

void Operator::move_to(Point place) {
  driver_->send({driver_->moved_to(place)});
  make_frames(3);
}

void Operator::begin() {
  press(Key::Enter);
  EXPECT_TRUE(until([&] { return driver_->has("operate.pause"); }));
}

}  // namespace hallux::ui
