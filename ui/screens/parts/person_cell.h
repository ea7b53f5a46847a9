/// A person in a row of a table: initials in a circle, and the name.
#pragma once

#include <string>

#include "database/records/ids.h"
#include "ui/widgets/ui.h"

namespace hallux::ui {

/// The avatar of a person: the initials of `name` in a colour that is theirs.
void person_avatar(Ui& ui, Point centre, float radius, std::string_view name,
                   database::PersonId id);

void draw_person_cell(Ui& ui, const Rect& cell, const std::string& name, database::PersonId id);

}  // namespace hallux::ui
