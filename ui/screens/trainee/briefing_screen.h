/// What an operation is about, before it is begun: why and what, the steps, what is scored; the
/// bone with its planned faces.
#pragma once

#include <memory>

#include "ui/jobs/course/standing_jobs.h"
#include "ui/screens/parts/loaded.h"
#include "ui/screens/parts/navigator.h"
#include "ui/screens/parts/signed_in_session.h"
#include "ui/screens/pictures/bone_viewport.h"
#include "ui/screens/pictures/patient_pictures.h"

namespace hallux::ui {

class BriefingScreen : public Screen {
 public:
  /// `navigator` and `pictures` outlive the screen.
  BriefingScreen(std::shared_ptr<SignedInSession> signed_in, Navigator& navigator,
                 PatientPictures& pictures, database::ScenarioVersionId scenario)
      : signed_in_(std::move(signed_in)),
        navigator_(navigator),
        pictures_(pictures),
        scenario_(scenario) {}

  GuideSection guide_section() const override { return GuideSection::Briefing; }
  std::string_view navigation_id() const override { return "nav.operations"; }
  /// An assessment may have been used up since.
  void enter(Shell&) override { read_.read_again(); }
  void draw(Ui& ui, const Rect& content, Shell& shell) override;

 private:
  struct Read {
    OwnOperation operation;
    bool is_in_assessment = false;
  };
  const OwnOperation& operation() const { return read_.value().operation; }
  void draw_briefing(Ui& ui, const Rect& content, Shell& shell);
  void draw_picture(Ui& ui, const Rect& rect, Shell& shell);
  void draw_start(Ui& ui, const Rect& rect);
  float start_height(const Ui& ui, float width) const;
  /// The way to a simulated hand, with what it is and how long it takes.
  void draw_watch(Ui& ui, const Rect& rect);
  float watch_height(const Ui& ui, float width) const;
  /// What it means to begin as it is chosen.
  std::string choice_text(const Ui& ui) const;
  bool may_begin() const;
  /// The words of the chosen tab from the top of `rect`; returns their height.
  float draw_text(Ui& ui, const Rect& rect, Shell& shell);
  void draw_text_card(Ui& ui, const Rect& rect, Shell& shell);

  std::shared_ptr<SignedInSession> signed_in_;
  Navigator& navigator_;
  PatientPictures& pictures_;
  database::ScenarioVersionId scenario_;
  Loaded<Read> read_;
  int tab_ = 0, kind_ = 0;
  /// Of practice: none, soft, slot.
  int guidance_ = 0;
  /// Of practice with an arm.
  bool feels_historic_law_ = false;
  /// An arm was chosen to operate with.
  bool has_arm_ = false;
  /// As they were drawn last.
  float words_height_ = 0.0F;
  BoneViewport stage_;
};

}  // namespace hallux::ui
