// Two pictures of one place: seen by the person from before (x right, y up), and how far it is from
// them (z) as a strip beside it. Both show the box in which the grip has been.
#include "ui/screens/devices/felt_view.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "ui/widgets/texts/number_text.h"
#include "ui/widgets/texts/texts.h"

namespace hallux::ui {

namespace {

constexpr float strip_width = 28.0F, gap = 12.0F, line_height = 24.0F, dot = 6.0F;
/// Half of the side of what is shown, in millimetres; a larger reach is shown whole.
constexpr double least_half_mm = 60.0;
constexpr int buttons_shown = 4;

/// One axis of the picture: millimetres to logical pixels.
struct Axis {
  float middle = 0.0F, pixels_per_mm = 1.0F;
  float at(double mm) const noexcept { return middle + pixels_per_mm * static_cast<float>(mm); }
};

double half_shown_mm(const Reach& reach) {
  double half_mm = least_half_mm;
  for (int axis = 0; axis < 3; ++axis)
    half_mm = std::max({half_mm, -reach.least_mm[axis], reach.greatest_mm[axis]});
  return half_mm;
}

/// Where the cap of a 3D mouse is pushed, as if it were a place.
Vec3 shown_mm(const FeltState& felt, bool is_deflected) {
  return is_deflected ? least_half_mm * felt.said.deflection.pushed
                      : felt.said.device_from_handle.translation_mm;
}

void draw_ground(Ui& ui, const Rect& rect) {
  ui.canvas().fill(rect, ui.theme().chip, radius::row);
  ui.canvas().outline(rect, ui.theme().line, radius::row);
}

void draw_pictures(Ui& ui, Rect rect, const FeltState& felt, const Vec3& place_mm) {
  Rect square = take_left(rect, std::min(rect.h, rect.w - strip_width - gap), gap);
  const Rect strip = take_left(rect, strip_width);
  const auto pixels_per_mm = static_cast<float>(0.5F * square.h / half_shown_mm(felt.reach));
  const Axis across{square.mid_x(), pixels_per_mm}, up{square.mid_y(), -pixels_per_mm},
      near{strip.mid_y(), pixels_per_mm};
  draw_ground(ui, square);
  draw_ground(ui, strip);
  if (felt.reach.is_known) {
    const Vec3 &least = felt.reach.least_mm, &greatest = felt.reach.greatest_mm;
    ui.canvas().outline(
        {across.at(least.x), up.at(greatest.y), across.at(greatest.x) - across.at(least.x),
         up.at(least.y) - up.at(greatest.y)},
        ui.theme().text_caption, 0.0F);
    ui.canvas().fill({strip.x + 4.0F, near.at(least.z), strip.w - 8.0F,
                      std::max(1.0F, near.at(greatest.z) - near.at(least.z))},
                     ui.theme().line, 0.0F);
  }
  const Color ink = felt.is_pushing ? ui.theme().warn : ui.theme().accent;
  ui.canvas().fill({across.at(place_mm.x) - dot, up.at(place_mm.y) - dot, 2.0F * dot, 2.0F * dot},
                   ink, dot);
  ui.canvas().fill({strip.x + 4.0F, near.at(place_mm.z) - 2.0F, strip.w - 8.0F, 4.0F}, ink, 2.0F);
}

void line(Ui& ui, Rect& rest, std::string_view name, const std::string& value) {
  Rect row = take_top(rest, line_height);
  ui.canvas().text_in(take_left(row, 84.0F), {Type::Small, ui.theme().text_secondary}, name, true);
  ui.canvas().text_in(row, {Type::Small, ui.theme().text}, value, true);
}

std::string buttons_text(const Ui& ui, std::uint32_t buttons) {
  std::string words;
  for (int button = 0; button < buttons_shown; ++button) {
    if ((buttons >> button & 1U) == 0) continue;
    words += (words.empty() ? "" : ", ") + std::to_string(button + 1);
  }
  return words.empty() ? std::string(ui.text("devices.buttons.none")) : words;
}

std::string tenths(double mm) { return fixed_text(std::abs(mm) < 0.05 ? 0.0 : mm, 1); }

std::string places_text(const Vec3& mm) {
  return "x " + tenths(mm.x) + "   y " + tenths(mm.y) + "   z " + tenths(mm.z) + " mm";
}

}  // namespace

void draw_felt_view(Ui& ui, const Rect& rect, const FeltState& felt,
                    const simulator::PortFigures& figures) {
  const bool is_deflected = felt.said.deflection != simulator::Deflection{} ||
                            felt.said.device_from_handle.translation_mm == Vec3(0.0, 0.0, 0.0);
  const Vec3 place_mm = shown_mm(felt, is_deflected);
  Rect rest = rect;
  const float side = std::min(rect.h, 0.45F * rect.w);
  draw_pictures(ui, {rest.x, rest.y, side + strip_width + gap, side}, felt, place_mm);
  rest.x += side + strip_width + 2.0F * gap;
  rest.w -= side + strip_width + 2.0F * gap;
  line(ui, rest, ui.text("devices.place"), places_text(place_mm));
  line(ui, rest, ui.text("devices.reach"), places_text(felt.reach.size_mm()));
  line(ui, rest, ui.text("devices.buttons"), buttons_text(ui, felt.said.buttons));
  line(ui, rest, ui.text("devices.packets"),
       ui.texts().say("devices.packets.value",
                      {{"packets", grouped(static_cast<long>(figures.packets))},
                       {"bad", grouped(static_cast<long>(figures.bad_packets))}}));
  line(ui, rest, ui.text("devices.round_trip"),
       ui.texts().say("devices.round_trip.value",
                      {{"median", fixed_text(figures.round_trip_p50_us / 1000.0, 2)},
                       {"p99", fixed_text(figures.round_trip_p99_us / 1000.0, 2)}}));
  ui.tell("devices.felt", places_text(place_mm) + ", " + buttons_text(ui, felt.said.buttons), rect);
}

}  // namespace hallux::ui
