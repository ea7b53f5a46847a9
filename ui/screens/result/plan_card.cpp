// Plan against cut, as one turns it. A cut is looked at from its waste and a little aside, so that
// its shape can be told; the map colours the face by its distance to the plan. A place of the
// ledger without a cut of its own is shown on the whole bone.
#include "ui/screens/result/plan_card.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "ui/render/scene/palette.h"
#include "ui/widgets/controls/choice.h"
#include "ui/widgets/controls/menu.h"
#include "ui/widgets/shapes.h"

namespace hallux::ui {

namespace {

constexpr float edge = 16.0F, views_room = 48.0F, legend_width = 300.0F, legend_height = 66.0F;
/// How far from square one looks at a face, so that its shape can be told.
constexpr double aside_rad = 0.42, above_rad = 0.26;
constexpr double room_around = 1.55;

Color color_of(const Float3& srgb) {
  const auto byte = [](float share) {
    return static_cast<std::uint8_t>(std::lround(255.0F * std::clamp(share, 0.0F, 1.0F)));
  };
  return {byte(srgb.x), byte(srgb.y), byte(srgb.z), 255};
}

/// Looks at the face from the waste, a little from the side.
Quat view_of_face(const RigidTransform& world_from_face) {
  const Vec3 normal = transform_direction(world_from_face, Vec3(0.0, 0.0, 1.0));
  Vec3 up(0.0, 1.0, 0.0);  // dorsal
  if (std::abs(glm::dot(normal, up)) > 0.9) up = Vec3(1.0, 0.0, 0.0);
  const Vec3 right = glm::normalize(glm::cross(up, normal));
  Camera camera;
  camera.world_from_view = rotation_from_axes(right, glm::cross(normal, right));
  return orbited(camera, aside_rad, above_rad).world_from_view;
}

std::string signed_mm(int mm) {
  if (mm == 0) return "0";
  return mm < 0 ? "\xE2\x88\x92" + std::to_string(-mm) : "+" + std::to_string(mm);
}

}  // namespace

void PlanCard::show_place(const std::array<double, 3>& place_in_bone_mm,
                          std::optional<std::size_t> cut) {
  place_in_bone_mm_ = Vec3(place_in_bone_mm[0], place_in_bone_mm[1], place_in_bone_mm[2]);
  // Without a cut of its own a place is looked for on the whole bone.
  constexpr int whole = 1000;
  chosen_ = cut ? static_cast<int>(*cut) : whole;
  ++revision_;
}

void PlanCard::aim(const ExaminedAttempt& examined) {
  chosen_ = std::min(chosen_, static_cast<int>(examined.cuts.size()));
  if (aimed_ == chosen_) return;
  aimed_ = chosen_;
  ++revision_;
  if (is_whole(examined)) {
    stage_.look_at(examined.middle_in_world_mm, 0.85 * examined.radius_mm, StandardView::Operator);
    return;
  }
  const CutAgainstPlan& cut = examined.cuts[static_cast<std::size_t>(chosen_)];
  const RigidTransform& world_from_bone = examined.world_from_bones[cut.bone];
  const RigidTransform world_from_face = world_from_bone * cut.bone_from_face;
  stage_.set_blade(world_from_face);
  stage_.look_at(transform_point(world_from_bone, cut.middle_in_bone_mm),
                 room_around * cut.radius_mm, view_of_face(world_from_face));
}

Scene PlanCard::scene_of(const Theme& theme, const ExaminedAttempt& examined) const {
  Scene scene;
  scene.ground = theme.is_dark() ? Ground::Dark : Ground::Light;
  const bool shows_whole = is_whole(examined);
  for (std::size_t i = 0; i < examined.pieces.size(); ++i) {
    const std::size_t of_bone = examined.piece_bones[i];
    BoneInScene bone;
    bone.mesh = &examined.pieces[i];
    bone.look = &examined.looks[of_bone];
    bone.world_from_bone = examined.world_from_bones[of_bone];
    if (!shows_whole) {
      const CutAgainstPlan& cut = examined.cuts[static_cast<std::size_t>(chosen_)];
      if (cut.is_cut && cut.bone == of_bone) {
        bone.map = cut.map;
        bone.cut_away = cut.cut_away;
      }
    }
    scene.bones.push_back(bone);
  }
  for (std::size_t i = 0; i < examined.cuts.size(); ++i) {
    if (!shows_whole && static_cast<int>(i) != chosen_) continue;
    const CutAgainstPlan& cut = examined.cuts[i];
    scene.planes.push_back({examined.world_from_bones[cut.bone] * cut.bone_from_face,
                            Vec2(1.15 * cut.radius_mm), Ink::Reference, false, false});
  }
  if (place_in_bone_mm_) {
    scene.marks.push_back(
        {transform_point(examined.world_from_bones.front(), *place_in_bone_mm_), 7.0, Ink::Harm});
  }
  return scene;
}

void PlanCard::draw_choice(Ui& ui, const Rect& rect, const ExaminedAttempt& examined) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < examined.cuts.size(); ++i)
    words.push_back(ui.texts().say("result.cut", {{"number", std::to_string(i + 1)}}));
  words.emplace_back(ui.text("result.whole_bone"));
  const std::vector<std::string_view> labels(words.begin(), words.end());
  const float width = std::min(segmented_width(ui, labels), rect.w - 2.0F * edge);
  const Rect place{rect.right() - edge - width, rect.y + edge, width, segmented_height};
  if (segmented(ui, "result.cut", place, labels, chosen_)) ++revision_;
}

void PlanCard::draw_labels(Ui& ui, const Rect& rect, const ExaminedAttempt& examined) const {
  const CutAgainstPlan& cut = examined.cuts[static_cast<std::size_t>(chosen_)];
  const RigidTransform& world_from_bone = examined.world_from_bones[cut.bone];
  const ClipScope clip(ui.canvas(), rect);
  for (const IsoPlace& iso : cut.iso_places) {
    std::optional<Point> rightmost;
    for (const Vec3& place : iso.places_in_bone_mm) {
      const auto seen = stage_.seen_at(transform_point(world_from_bone, place));
      if (seen && (!rightmost || seen->x > rightmost->x)) rightmost = seen;
    }
    if (!rightmost) continue;
    const std::string words =
        ui.texts().say("result.mm", {{"distance", signed_mm(iso.distance_mm)}});
    const float width = ui.width_of(Type::CaptionMedium, words);
    const Rect ground{rightmost->x + 8.0F, rightmost->y - 9.0F, width + 8.0F, 18.0F};
    if (!rect.encloses(ground)) continue;
    ui.canvas().fill(ground, ui.theme().hud, 4.0F);
    ui.canvas().text_in(ground, {Type::CaptionMedium, ui.theme().text, Align::Centre}, words);
  }
}

void PlanCard::draw_legend(Ui& ui, const Rect& rect) const {
  Canvas& canvas = ui.canvas();
  const float width = std::min(legend_width, rect.w - 2.0F * edge - 24.0F - views_room);
  const Rect panel{rect.x + edge, rect.bottom() - edge - legend_height, width + 24.0F,
                   legend_height};
  draw_hud_panel(canvas, ui.theme(), panel, radius::control);
  const Rect inner = inset(panel, 12.0F, 6.0F);
  const TextStyle words{Type::Caption, ui.theme().text};
  canvas.text_in({inner.x, inner.y, 0.5F * inner.w, 18.0F}, words, ui.text("result.map.low"));
  canvas.text_in({inner.mid_x(), inner.y, 0.5F * inner.w, 18.0F},
                 {Type::Caption, ui.theme().text, Align::Right}, ui.text("result.map.high"));
  const Rect bar{inner.x, inner.y + 22.0F, inner.w, 10.0F};
  canvas.gradient_across({bar.x, bar.y, 0.5F * bar.w, bar.h}, color_of(map_low),
                         color_of(map_middle));
  canvas.gradient_across({bar.mid_x(), bar.y, 0.5F * bar.w, bar.h}, color_of(map_middle),
                         color_of(map_high));
  for (int mm = -2; mm <= 2; ++mm) {
    const float x = bar.x + bar.w * (static_cast<float>(mm) + 2.0F) / 4.0F;
    const Align align = mm == -2 ? Align::Left : mm == 2 ? Align::Right : Align::Centre;
    const std::string text =
        mm == 2 ? ui.texts().say("result.mm", {{"distance", signed_mm(mm)}}) : signed_mm(mm);
    canvas.text({x, inner.bottom() - 8.0F}, {Type::Caption, ui.theme().text_secondary, align},
                text);
  }
}

void PlanCard::draw_views(Ui& ui, const Rect& rect) {
  const Rect place{rect.right() - edge - 36.0F, rect.bottom() - edge - 36.0F, 36.0F, 36.0F};
  draw_hud_panel(ui.canvas(), ui.theme(), place, radius::control);
  if (icon_button(ui, "result.views", place, {ui.text("result.views"), Icon::Eye, shows_views_}))
    shows_views_ = true;
  if (!shows_views_) return;
  std::vector<std::string> keys;
  const int views = stage_.has_blade() ? standard_view_count : standard_view_count - 1;
  for (int view = 1; view <= views; ++view) keys.push_back(std::to_string(view));
  std::vector<MenuItem> items;
  for (std::size_t view = 0; view < keys.size(); ++view)
    items.push_back({ui.text(standard_view_texts[view]), Icon::None, keys[view]});
  const Point corner{place.right() - 250.0F, place.y - menu_height(items) - 8.0F};
  const int chosen = menu(ui, "result.view", corner, items);
  if (chosen == menu_open) return;
  shows_views_ = false;
  if (chosen >= 0) stage_.turn_to(static_cast<StandardView>(chosen));
}

void PlanCard::draw(Ui& ui, Shell& shell, const Rect& rect, const ExaminedAttempt& examined) {
  aim(examined);
  stage_.draw(ui, shell, rect, scene_of(ui.theme(), examined),
              {"result.plan", ui.text("result.plan"), revision_, radius::card});
  if (!is_whole(examined)) {
    const bool is_cut = examined.cuts[static_cast<std::size_t>(chosen_)].is_cut;
    if (is_cut) draw_labels(ui, rect, examined);
    if (is_cut) draw_legend(ui, rect);
    if (!is_cut) {
      const Rect note{rect.x + edge, rect.bottom() - 48.0F, rect.w - 2.0F * edge, 32.0F};
      draw_hud_panel(ui.canvas(), ui.theme(), note, radius::control);
      ui.canvas().text_in(note, {Type::Small, ui.theme().text, Align::Centre},
                          ui.text("result.cut.missing"));
    }
  }
  ui.canvas().text_on_baseline({rect.x + space::card, rect.y + 39.0F},
                               {Type::CardTitle, ui.theme().text}, ui.text("result.plan"));
  draw_choice(ui, rect, examined);
  draw_views(ui, rect);
}

}  // namespace hallux::ui
