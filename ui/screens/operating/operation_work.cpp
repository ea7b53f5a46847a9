#include "ui/screens/operating/operation_work.h"

#include <malloc.h>

#include <atomic>
#include <future>
#include <utility>

#include "database/content/assets.h"
#include "simulator/base/progress.h"

namespace hallux::ui {

namespace {

/// Where the work has come when the patient is made; its picture takes the rest.
constexpr double patient_share = 0.5;

/// A stage of a job as a part of the work's own progress.
StageProgress stages_of(WorkReport& report, double share) {
  return [&report, share](const std::string&) {
    return [&report, share](double fraction) { return report.reached(share * fraction); };
  };
}

/// The neighbour's picture, made beside that of the bone; where that one stops, so does this.
class NeighbourWork {
 public:
  /// Borrows the scenario.
  NeighbourWork(const scenarios::Scenario& scenario, const std::filesystem::path& directory)
      : made_(std::async(std::launch::async, [this, &scenario, directory] {
          return neighbour_picture(scenario, directory, [this](double) { return !is_stopped_; });
        })) {}
  ~NeighbourWork() { is_stopped_ = true; }
  NeighbourWork(const NeighbourWork&) = delete;
  NeighbourWork& operator=(const NeighbourWork&) = delete;

  std::optional<BoneInView> take() { return made_.get(); }

 private:
  std::atomic<bool> is_stopped_{false};
  /// Last: waited for before the rest goes.
  std::future<std::optional<BoneInView>> made_;
};

database::TraineeDesk desk_of(database::Session& session) {
  std::optional<database::TraineeDesk> desk = session.trainee();
  if (!desk) {
    throw database::DatabaseError(database::DatabaseErrorKind::Refused,
                                  "this person may not operate any more; ask an administrator");
  }
  return *desk;
}

}  // namespace

std::vector<scenarios::PlannedPasses> passes_of(const PreparedCase& prepared_case) {
  std::vector<scenarios::PlannedPasses> passes;
  for (std::size_t cut = 0; cut < prepared_case.plan.cuts.size(); ++cut) {
    const std::size_t bone = prepared_case.plan.cuts[cut].bone;
    const simulator::WholeBone& whole = *prepared_case.wholes[bone];
    scenarios::PlannedPasses& made = passes.emplace_back(
        planned_passes(prepared_case.scenario, prepared_case.plan, cut, whole.solid, whole.tree));
    const RigidTransform first_from_bone = first_from(prepared_case.bones, bone);
    for (Vec3* const direction : {&made.feed_in_bone, &made.along_in_bone})
      *direction = transform_direction(first_from_bone, *direction);
  }
  return passes;
}

std::vector<PlannedFace> faces_of(const PreparedCase& prepared_case) {
  std::vector<simulator::SolidWithTree> wholes;
  for (const auto& whole : prepared_case.wholes) wholes.push_back({whole->solid, whole->tree});
  return planned_faces(wholes, prepared_case.plan, prepared_case.bones);
}

PreparedOperation prepare_operation(SignedInSession& signed_in,
                                    database::ScenarioVersionId scenario, WorkReport& report) {
  std::filesystem::path directory;
  const database::ScenarioText text =
      signed_in.in_turn([&](database::Session&, database::Database& database) {
        directory = database.directory();
        return database::get_scenario_version(database, scenario);
      });
  PreparedOperation prepared;
  prepared.prepared_case = std::make_shared<const PreparedCase>(prepare_case(
      scenarios::parse_scenario(text.json, text.name), stages_of(report, patient_share)));
  cancelled_as("stopped while the picture was being made; nothing was stored", [&] {
    NeighbourWork neighbour(prepared.prepared_case->scenario, directory);
    prepared.pictures = pictures_of(prepared.prepared_case, directory, [&](double fraction) {
      return report.reached(patient_share + (1.0 - patient_share) * fraction);
    });
    SitePicture site;
    site.faces = faces_of(*prepared.prepared_case);
    site.neighbour = neighbour.take();
    if (site.neighbour)
      site.neighbour_tree = std::make_shared<const simulator::Bvh>(site.neighbour->mesh.solid.mesh);
    prepared.site = std::make_shared<const SitePicture>(std::move(site));
    prepared.passes = passes_of(*prepared.prepared_case);
  });
  // What briefing, replays and the making of the patient left free in the heaps goes back to the
  // system now, while nobody operates: an operation needs the room.
  ::malloc_trim(0);
  return prepared;
}

std::unique_ptr<LiveAttempt> begin_operation(SignedInSession& signed_in,
                                             std::shared_ptr<const PreparedCase> prepared_case,
                                             LiveBegin what,
                                             std::unique_ptr<simulator::HapticDevice> device) {
  what.device_class = device->description().device_class;
  return signed_in.in_turn([&](database::Session& session, database::Database& database) {
    database::TraineeDesk desk = desk_of(session);
    database::WriterLease lease = begin_live(database, desk, what, prepared_case->bones);
    return std::make_unique<LiveAttempt>(std::move(prepared_case), database, std::move(lease),
                                         std::move(device), std::move(what));
  });
}

void score_operation(SignedInSession& signed_in, const database::AttemptId& attempt,
                     WorkReport& report) {
  const AttemptMaterial material =
      signed_in.in_turn([&](database::Session& session, database::Database& database) {
        database::TraineeDesk desk = desk_of(session);
        return load_to_score(database, desk, attempt);
      });
  const assessment::Examination examination = score_attempt(material, stages_of(report, 1.0));
  signed_in.in_turn([&](database::Session& session, database::Database&) {
    database::TraineeDesk desk = desk_of(session);
    store_examination(desk, material, examination);
  });
}

}  // namespace hallux::ui
