#include "ui/screens/result/attempt_source.h"

#include <utility>

#include "ui/jobs/cached_fields.h"
#include "ui/screens/parts/desk_work.h"

namespace hallux::ui {

AttemptSource attempt_source(SignedInSession& signed_in, const database::AttemptId& id) {
  return signed_in.in_turn([&](database::Session& session, database::Database& database) {
    database::AttemptDesk desk =
        desk_or_refused(session.desk_for(database::Action::ViewAttempt, id),
                        "this account may not see attempts any more");
    MeasuredMaterial measured = load_measured(database, desk, id);
    return AttemptSource{std::move(measured.attempt), database.directory(),
                         std::move(measured.measurements)};
  });
}

assessment::Examination examination_of(const AttemptSource& source, const StageProgress& progress) {
  if (!source.measurements) return score_attempt(source.attempt, progress);
  return examine_kept(source.attempt, source.directory, *source.measurements, progress);
}

}  // namespace hallux::ui
