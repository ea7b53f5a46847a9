/// What trainees of the cohorts that one teaches ask about moments of their attempts: read, seen,
/// answered.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "ui/screens/parts/desk_work.h"
#include "ui/screens/parts/loaded.h"
#include "ui/screens/parts/navigator.h"

namespace hallux::ui {

/// A question in the inbox, with a cohort from whose desk it can be answered.
struct InboxRequest {
  database::HelpRequest request;
  database::CohortId cohort;
};

/// Those of all cohorts that are taught, each once: open first, oldest first; then the answered,
/// newest first.
/// errors  DatabaseError
std::vector<InboxRequest> read_inbox(database::Session& session);
int count_open(const std::vector<InboxRequest>& inbox) noexcept;

class InboxScreen : public Screen {
 public:
  /// Told how many questions are open whenever they were read.
  using Counted = std::function<void(int open)>;

  /// What was typed as an answer and not sent; it outlives the screen, so that nothing is lost on
  /// the way.
  using Drafts = std::map<database::HelpRequestId, std::string>;

  /// `navigator` outlives the screen.
  InboxScreen(std::shared_ptr<SignedInSession> signed_in, Navigator& navigator,
              std::shared_ptr<Drafts> drafts, Counted counted = {})
      : signed_in_(std::move(signed_in)),
        navigator_(navigator),
        drafts_(std::move(drafts)),
        counted_(std::move(counted)) {}

  GuideSection guide_section() const override { return GuideSection::Inbox; }
  std::string_view navigation_id() const override { return "nav.inbox"; }
  /// What was answered elsewhere in the meantime is read anew.
  void enter(Shell&) override { inbox_.read_again(); }
  void draw(Ui& ui, const Rect& content, Shell& shell) override;

 private:
  void read(Ui& ui, Shell& shell);
  void draw_list(Ui& ui, const Rect& content);
  void draw_chosen(Ui& ui, const Rect& content, Shell& shell);
  void draw_answer(Ui& ui, Rect& rest, const InboxRequest& chosen, Shell& shell);
  void answer(Ui& ui, Shell& shell, const InboxRequest& chosen);
  const InboxRequest* chosen() const;

  std::shared_ptr<SignedInSession> signed_in_;
  Navigator& navigator_;
  std::shared_ptr<Drafts> drafts_;
  Counted counted_;
  Loaded<std::vector<InboxRequest>> inbox_;
  bool is_counted_ = false;
  /// 0 open, 1 all.
  int filter_ = 0;
  bool is_filter_set_ = false;
  database::HelpRequestId chosen_;
  DeskWork work_;
};

}  // namespace hallux::ui
