/// The cards over the picture of an operation, before, beside and after it; plain functions of what
/// they say.
#pragma once

#include <filesystem>
#include <string>

#include "ui/screens/operating/operating_session.h"
#include "ui/widgets/controls/menu.h"
#include "ui/widgets/ui.h"

namespace hallux::ui {

enum class ReadyAnswer { Waiting, Begin, Back };
/// What is operated on, and the button that begins.
/// words         what leads the saw, and what is shown
/// is_beginning  it was pressed, and its work is under way
ReadyAnswer draw_ready_card(Ui& ui, const std::string& title, const std::string& words,
                            bool is_beginning);
/// device  its id, as it was chosen; "mouse"
std::string ready_text(const Ui& ui, bool is_practice, bool is_beginning,
                       const std::string& device);

/// The pause with its cause. True where somebody goes on.
bool draw_paused_card(Ui& ui, PausedBy by);

enum class LostAnswer { Waiting, TakeMouse, Abandon };
/// The device is away: why, and that it goes on by itself once it is there again. A practice may go
/// on with the mouse, an assessment may be given up.
/// trouble  a sentence; may be empty
LostAnswer draw_device_lost_card(Ui& ui, bool is_practice, const std::string& trouble);

/// A full disk: where it is, and that nothing is lost. True where somebody does not wait for room.
/// directory  that is recorded into
bool draw_storage_full_card(Ui& ui, const std::filesystem::path& directory);

/// Sentences that a question adds.
struct EndWords {
  /// Of an unfinished step: what still holds; empty where that is not told.
  std::string held;
  /// Of the steps that are not done.
  std::string left;
};
/// The question before a step or an operation ends.
Answer draw_end_question(Ui& ui, Asked asked, const EndWords& words);

/// "2 steps are not done: X, Y or Z.": by title, of alternatives of which none is done all; or that
/// all are done. Steps that may be left out are not told, nor the finish itself.
/// progress  of the scenario
std::string left_steps_text(const Texts& texts, const scenarios::Scenario& scenario,
                            const StepProgress& progress);

/// The record is being closed: a moment, unless the disk is slow.
/// since_s  on the clock of `ui`; what takes no time is not shown
void draw_sealing(Ui& ui, double since_s);

enum class StoppedAnswer { Waiting, SeeKept, Back };
/// Why it stopped, over the whole window.
/// is_kept  something was recorded and can be looked at
StoppedAnswer draw_stopped_card(Ui& ui, const OperatingSession::Stop& stop, bool is_kept);

}  // namespace hallux::ui
