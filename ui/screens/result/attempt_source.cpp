#include "ui/screens/result/attempt_source.h"

#include <utility>

#include "assessment/rebuild/opened_fields.h"
#include "scenarios/tray/laid_out_tools.h"
#include "simulator/base/progress.h"
#include "ui/jobs/cached_fields.h"
#include "ui/screens/parts/desk_work.h"

namespace hallux::ui {

namespace {

/// Of the time, as measured.
constexpr double stamped_share = 0.8;

}  // namespace

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

assessment::Examination stamped_examination_of(const AttemptSource& source,
                                               const StageProgress& progress) {
  const AttemptMaterial& material = source.attempt;
  if (!source.measurements) return score_attempt(material, progress);
  const Progress reached = progress("Examining");
  assessment::Measured measured{
      *source.measurements,
      assessment::opened_fields(scenarios::tray_of(material.scenario), material.bones,
                                material.recording, part_of(reached, 0.0, stamped_share))};
  return assessment::examine_measured(material.scenario, material.bones, material.recording,
                                      material.header.begun.device_class, std::move(measured),
                                      part_of(reached, stamped_share, 1.0));
}

}  // namespace hallux::ui
