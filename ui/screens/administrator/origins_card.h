/// Other directories that attempts were imported from, and whether those count here. Nothing is
/// drawn where there are none. Inside this corner only.
///
///     const float height = origins_.height(ui, shell);
///     if (height > 0.0F) origins_.draw(ui, take_top(side, height, space::between_cards), shell);
#pragma once

#include <memory>
#include <vector>

#include "database/records/origin.h"
#include "ui/screens/parts/desk_work.h"
#include "ui/screens/parts/loaded.h"

namespace hallux::ui {

class OriginsCard {
 public:
  explicit OriginsCard(std::shared_ptr<SignedInSession> signed_in)
      : signed_in_(std::move(signed_in)) {}

  /// 0 until they were read, and where there are none.
  float height(Ui& ui, Shell& shell);
  void draw(Ui& ui, const Rect& rect, Shell& shell);

 private:
  void draw_origin(Ui& ui, const Rect& line, const database::Origin& origin, Shell& shell);
  void accept(Ui& ui, const database::Origin& origin, Shell& shell);

  std::shared_ptr<SignedInSession> signed_in_;
  Loaded<std::vector<database::Origin>> origins_;
  DeskWork work_;
};

}  // namespace hallux::ui
