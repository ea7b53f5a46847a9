#include "ui/screens/administrator/origins_card.h"

#include <algorithm>
#include <string>

#include "ui/screens/parts/course_text.h"
#include "ui/screens/parts/page.h"

namespace hallux::ui {

namespace {

using database::Origin;

constexpr float head_height = 116.0F, row_height = 44.0F;
constexpr std::size_t rows_shown_max = 2;
/// Of 32 digits: enough to tell them apart.
constexpr std::size_t shown_digits = 8;

}  // namespace

float OriginsCard::height(Ui& ui, Shell& shell) {
  origins_.read(ui, shell, ui.text("records.origins.reading"), signed_in_,
                [](database::Session& session) { return administrator_of(session).origins(); });
  if (!origins_.has_value() || origins_.value().empty()) return 0.0F;
  return head_height +
         row_height * static_cast<float>(std::min(origins_.value().size(), rows_shown_max));
}

void OriginsCard::draw(Ui& ui, const Rect& rect, Shell& shell) {
  const std::string_view title = ui.text("records.origins");
  Rect rest = card(ui, rect, title, space::side_card);
  text_line(ui, rest, Type::Small, ui.theme().text_secondary, ui.text("records.origins.sentence"),
            8.0F);
  const std::vector<Origin>& origins = origins_.value();
  const float height = row_height * static_cast<float>(origins.size());
  const float offset = ui.begin_scroll("records.origins.list", title, rest, height);
  Rect line{rest.x, rest.y - offset, rest.w - 12.0F, row_height};
  for (const Origin& origin : origins) {
    draw_origin(ui, line, origin, shell);
    line.y += row_height;
  }
  ui.end_scroll();
}

void OriginsCard::draw_origin(Ui& ui, const Rect& line, const Origin& origin, Shell& shell) {
  ButtonSpec act{
      ui.text(origin.is_accepted ? "records.origins.unaccept" : "records.origins.accept"),
      ButtonLook::Secondary};
  act.is_busy = work_.is_running();
  Rect rest = line;
  const Rect strip = take_right(rest, button_width(ui, act), 8.0F);
  const Rect place{strip.x, strip.y + 4.0F, strip.w, header_button_height};
  const std::string id = "records.origins." + origin.directory.text.substr(0, shown_digits);
  if (button(ui, id, place, act)) accept(ui, origin, shell);
  ui.canvas().text_in(rest, {Type::Small, ui.theme().text},
                      ui.texts().say("records.origins.one",
                                     {{"directory", origin.directory.text.substr(0, shown_digits)},
                                      {"attempts", grouped(static_cast<long>(origin.attempts))}}),
                      true);
}

void OriginsCard::accept(Ui& ui, const Origin& origin, Shell& shell) {
  work_.change(
      shell, signed_in_,
      {std::string(ui.text("records.origins.changing")),
       std::string(ui.text("records.origins.failed"))},
      [directory = origin.directory,
       is_accepted = !origin.is_accepted](database::Session& session) {
        administrator_of(session).set_accepted(directory, is_accepted);
      },
      [this] { origins_.read_again(); });
}

}  // namespace hallux::ui
