/// Small drawings that say something: a shape with every meaning, marks of competence, surfaces,
/// the focus ring.
#pragma once

#include "ui/widgets/canvas.h"
#include "ui/widgets/look/theme.h"

namespace hallux::ui {

/// Good: disc and tick. Warn: triangle and "!". Bad: diamond and cross. Info: disc and "i".
/// Neutral: ring.
void draw_meaning(Canvas& canvas, const Theme& theme, Meaning meaning, Point centre,
                  float radius = 7.0F);

/// Learning: ring filled by `progress` (0-1). Competent: disc and tick. Slipped: triangle
/// downwards. Stale: clock. Not started: short dash.
void draw_competence(Canvas& canvas, const Theme& theme, Competence competence, Point centre,
                     float radius = 7.5F, float progress = 0.0F);

void draw_tick(Canvas& canvas, Point centre, float radius, Color color, float thickness = 2.0F);
/// A quarter of a ring; it stands still, as nothing in the product moves without a reason.
void draw_spinner(Canvas& canvas, Point centre, float radius, Color color);
/// A bone's section, cortex and canal, with a wedge taken out.
void draw_logo(Canvas& canvas, const Theme& theme, Point centre, float size);

/// 2 px, 3 px outside the control.
void draw_focus_ring(Canvas& canvas, const Theme& theme, const Rect& rect, float corner);

enum class Elevation { Card, Popup };
void draw_shadow(Canvas& canvas, const Theme& theme, const Rect& rect, float corner,
                 Elevation elevation);
/// Shadow, fill and hairline of a card; of a menu, toast or tooltip.
void draw_card(Canvas& canvas, const Theme& theme, const Rect& rect, float corner = radius::card);
void draw_popup(Canvas& canvas, const Theme& theme, const Rect& rect, float corner = radius::card);
/// Words beside a place, in as many lines as they need, on the layer of tooltips and inside the
/// display.
void draw_told_words(Canvas& canvas, const Theme& theme, const Rect& beside,
                     std::string_view words);
/// A panel over the picture of the bone.
void draw_hud_panel(Canvas& canvas, const Theme& theme, const Rect& rect,
                    float corner = radius::picture);

}  // namespace hallux::ui
