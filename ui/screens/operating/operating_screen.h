/// Operating: a trainee cuts, with mouse and keyboard, and everything is recorded as theirs.
///
///     preparing -> ready -> operating <-> paused -> sealing -> scoring -> the result
///         |          |          '--> abandoned, or stopped by a failure: what was recorded is kept
///         |          |               (a full disk pauses; it stops only whoever does not wait for room)
///         '-> failed, with why
#pragma once

#include <memory>
#include <string>

#include "ui/render/scene/swarf.h"
#include "ui/render/stereo.h"
#include "ui/screens/operating/bone_being_cut.h"
#include "ui/screens/operating/operating_hud.h"
#include "ui/screens/operating/steering.h"
#include "ui/screens/parts/loaded.h"
#include "ui/screens/parts/places.h"
#include "ui/screens/parts/signed_in_session.h"
#include "ui/sound/saw_player.h"
#include "ui/window/shell/shell.h"

namespace hallux::ui {

/// What an operation needs before it can begin.
struct PreparedOperation {
  std::shared_ptr<const OperatingTable> table;
  BonePicture picture;
};

class OperatingScreen : public Screen {
 public:
  OperatingScreen(std::shared_ptr<Visit> visit, Places& places,
                  database::ScenarioVersionId scenario, database::AttemptKind kind,
                  simulator::Guidance guidance);
  ~OperatingScreen() override;

  Surround surround() const override { return Surround::Badge; }
  std::string_view why_not_leave() const override { return why_not_leave_; }
  /// Covered by another screen, or by the lock: nobody holds the saw.
  void leave(Shell& shell) override;
  void draw(Ui& ui, const Rect& content, Shell& shell) override;

 private:
  enum class Phase { Preparing, Ready, Beginning, Operating, Sealing, Scoring, Stopped };
  enum class Asking { Nothing, Finish, Abandon };
  /// What a step waits for after its button was pressed.
  enum class Waiting { Nothing, Piece, Hinge };
  /// The attempt, with what leads its device.
  struct Begun {
    std::unique_ptr<LiveAttempt> live;
    simulator::MouseDevice* mouse = nullptr;  ///< of live
  };

  void prepare(Ui& ui, Shell& shell);
  void draw_ready(Ui& ui, Shell& shell);
  void begin(Ui& ui, Shell& shell);
  void draw_stopped(Ui& ui, Shell& shell);

  void draw_operation(Ui& ui, Shell& shell);
  void look(Ui& ui, const AreaResponse& area);
  void hear_keys(Ui& ui, Shell& shell);
  void hear_views(Ui& ui);
  void steer(Ui& ui, const AreaResponse& area);
  void show_scene(Ui& ui, Shell& shell);
  Scene scene(Ui& ui);
  void let_chips_fly(double now_s);
  void sound_the_saw(Shell& shell);
  void draw_hud(Ui& ui, Shell& shell);
  OperatingHud hud(Ui& ui, Shell& shell);
  OperatingHealth health(Ui& ui, Shell& shell);
  std::optional<PlanReading> plan_reading() const;
  const scenarios::PlannedCut* planned_cut() const;

  void carry_out_step(Ui& ui);
  void follow_events(Ui& ui, Shell& shell);
  void end_step();
  void ask(Asking what);
  void draw_question(Ui& ui);
  void set_paused(bool is_paused);
  const char* what_took_the_hands(Ui& ui) const;
  std::string words_of_failure(const Ui& ui, const LiveEnd& end) const;
  void draw_paused(Ui& ui);
  void draw_sealing(Ui& ui) const;
  void follow_storage(Ui& ui);
  void draw_storage_full(Ui& ui);
  void give_up_on_storage(Ui& ui);
  void follow_end(Ui& ui, Shell& shell);
  void score(Ui& ui, Shell& shell);
  enum class Onward { Result, Replay };
  void lead_on(Shell& shell, Onward where);
  bool is_practice() const noexcept { return kind_ == database::AttemptKind::Practice; }

  std::shared_ptr<Visit> visit_;
  Places& places_;
  database::ScenarioVersionId scenario_;
  database::AttemptKind kind_;
  simulator::Guidance guidance_;
  Phase phase_ = Phase::Preparing;
  std::string why_not_leave_, stopped_;
  const char* paused_by_ = nullptr;  ///< a sentence of the catalogue, where it was not the person

  Reading<PreparedOperation> prepared_;
  ScreenWork work_;
  std::shared_ptr<Begun> begun_;
  std::unique_ptr<BoneBeingCut>
      bone_;  ///< before begun_ in the end: it follows that attempt's feed

  Sight sight_;
  Steering steering_;
  RigidTransform world_from_target_;
  StereoSetting stereo_;
  Swarf swarf_{1};
  std::unique_ptr<SawPlayer> player_;  ///< once the saw is to be heard
  simulator::ToolSample last_sample_;
  bool has_sample_ = false;  ///< the loop has taken its first step
  double last_s_ = 0.0, frame_ms_ = 0.0, steered_s_ = 0.0, sealing_since_s_ = 0.0;
  long pictures_ = 0;
  std::size_t triangles_ = 0;
  RecentLimits limits_;  ///< of the arm's force

  std::size_t step_ = 0;
  Waiting waiting_ = Waiting::Nothing;
  double waiting_until_s_ = 0.0;
  int freed_ = 0, removed_ = 0;
  Asking asking_ = Asking::Nothing;
  bool is_saw_on_ = false, is_irrigated_ = false, is_paused_ = false, was_paused_before_ = false;
  bool is_hud_shown_ = true, is_plane_shown_ = true, is_health_open_ = false, is_abandoned_ = false;
  bool is_storage_full_ = false;  ///< the recorder waits for room on the disk
};

}  // namespace hallux::ui
