/// What is published, to choose from by pictures, with how the person stands in each; the next
/// thing to do on top.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ui/jobs/course/standing_jobs.h"
#include "ui/screens/parts/loaded.h"
#include "ui/screens/parts/navigator.h"
#include "ui/screens/parts/signed_in_session.h"
#include "ui/screens/pictures/patient_pictures.h"

namespace hallux::ui {

class OperationsScreen : public Screen {
 public:
  /// `navigator` and `pictures` outlive the screen.
  OperationsScreen(std::shared_ptr<SignedInSession> signed_in, Navigator& navigator,
                   PatientPictures& pictures)
      : signed_in_(std::move(signed_in)), navigator_(navigator), pictures_(pictures) {}

  GuideSection guide_section() const override { return GuideSection::Operations; }
  std::string_view navigation_id() const override { return "nav.operations"; }
  /// Back from an attempt, the person stands elsewhere.
  void enter(Shell&) override { operations_.read_again(); }
  void draw(Ui& ui, const Rect& content, Shell& shell) override;

 private:
  void draw_controls(Ui& ui, const Rect& controls);
  void draw_operations(Ui& ui, Rect page, Shell& shell);
  /// The one thing to do next: the first flight, or an operation.
  void draw_next(Ui& ui, const Rect& strip, Shell& shell);
  void draw_next_operation(Ui& ui, const Rect& strip, const OwnOperation& next);
  void draw_cards(Ui& ui, const Rect& page, Shell& shell);
  /// How the cards lie on a page of this width: side by side, and how large each is.
  struct Grid {
    int across = 1;
    float card_width = 0.0F, card_height = 0.0F, height = 0.0F;
  };
  Grid grid_of(float width) const;
  void show_all(Ui& ui);
  bool has_operations() const { return operations_.has_value() && !operations_.value().empty(); }
  bool draw_card(Ui& ui, const Rect& rect, const OwnOperation& operation, Shell& shell);
  Picture picture_of(Ui& ui, const Rect& card, const OwnOperation& operation, Shell& shell);
  /// What stands in the place of the picture until it is there.
  std::string picture_note(const Ui& ui, const OwnOperation& operation) const;
  std::vector<const OwnOperation*> shown() const;

  std::shared_ptr<SignedInSession> signed_in_;
  Navigator& navigator_;
  PatientPictures& pictures_;
  Loaded<std::vector<OwnOperation>> operations_;
  /// Of this frame.
  std::string now_utc_;
  int segment_ = 0;
  std::string search_;
};

/// The first flight is offered to whoever tried nothing yet and has not answered the offer.
bool is_flight_offered(const std::vector<OwnOperation>& operations, const Preferences& preferences,
                       database::PersonId person);
/// They answered, whatever they said.
void keep_flight_answer(Preferences& preferences, database::PersonId person);

/// How far the person is with it, by ui/screens/parts/standing.h.
Competence competence_of(const OwnOperation& operation, std::string_view now_utc);
/// The same in words: "Learning, 3 of 12".
std::string standing_text(const Texts& texts, const OwnOperation& operation,
                          std::string_view now_utc);
/// What the person should do next: the easiest operation they are not competent in, else the one
/// they did longest ago. Nothing where there is none that can be begun.
const OwnOperation* next_operation(const std::vector<OwnOperation>& operations,
                                   std::string_view now_utc);

}  // namespace hallux::ui
