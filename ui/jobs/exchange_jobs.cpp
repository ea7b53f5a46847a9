#include "ui/jobs/exchange_jobs.h"

#include <algorithm>

#include "assessment/rebuild/rebuild.h"
#include "database/exchange/read_exported.h"
#include "database/store/fresh_directory.h"
#include "scenarios/hidden_letters.h"
#include "scenarios/tray/laid_out_tools.h"
#include "simulator/base/progress.h"
#include "simulator/mesh/mesh_error.h"
#include "simulator/mesh/write_ply.h"
#include "ui/jobs/left_behind_json.h"
#include "ui/jobs/plan_file.h"

namespace hallux::ui {

namespace {

using database::DatabaseError;
using database::DatabaseErrorKind;

/// A thousand pieces are none that a saw leaves; their names end where those of an export do.
constexpr std::size_t pieces_max = 200;

/// One of `count` attempts that take the same share each.
Progress one_of(const Progress& whole, std::size_t index, std::size_t count) {
  const auto all = static_cast<double>(count);
  return part_of(whole, static_cast<double>(index) / all, static_cast<double>(index + 1) / all);
}

scenarios::Scenario scenario_of(const database::Manifest& manifest) {
  scenarios::Scenario scenario =
      scenarios::parse_scenario(manifest.scenario.json, manifest.scenario.name);
  scenarios::check_letters(manifest.scenario.json, manifest.scenario.name);
  if (scenario.name != manifest.scenario.name || scenario.version != manifest.scenario.version ||
      scenario.claims_review != manifest.scenario.is_reviewed) {
    throw DatabaseError{DatabaseErrorKind::BadInput,
                        "the manifest says something else of the scenario than its text does"};
  }
  return scenario;
}

/// What this program makes of it; nothing of one that was interrupted.
std::optional<database::ScoreCard> rescored(database::ImportedAttempt& attempt,
                                            const StageProgress& progress) {
  AttemptMaterial material;
  material.scenario = scenario_of(attempt.manifest);
  material.bones = simulator::decode_patient(attempt.bone);
  if (!attempt.manifest.header.seal) return std::nullopt;
  material.header = attempt.manifest.header;
  material.recording = attempt.tables.recording;
  return score_attempt(material, progress).card;
}

/// Whether others can be taken in although this one was not.
bool is_of_one_folder(const DatabaseError& error) {
  return error.kind() == DatabaseErrorKind::BadInput || error.kind() == DatabaseErrorKind::Newer ||
         error.kind() == DatabaseErrorKind::Refused || error.kind() == DatabaseErrorKind::Damaged;
}

void import_one(database::AdministratorDesk& desk, const std::filesystem::path& folder,
                const StageProgress& progress, ImportReport& report) {
  const auto refuse = [&](const std::exception& error) {
    report.refused.push_back({folder.filename().string(), error.what()});
  };
  try {
    database::ImportedAttempt attempt = database::read_exported(folder);
    const database::AttemptId id = attempt.manifest.header.id;
    if (desk.is_here(attempt)) {
      report.known.push_back(id);
      return;
    }
    const auto card = rescored(attempt, progress);
    const bool is_new = desk.import_attempt(attempt, card);
    (is_new ? report.imported : report.known).push_back(id);
    if (is_new && !attempt.why_not_all.empty()) report.not_all.push_back(attempt.why_not_all);
  } catch (const DatabaseError& error) {
    if (!is_of_one_folder(error)) throw;
    refuse(error);
  } catch (const scenarios::ScenarioError& error) {
    refuse(error);
  } catch (const simulator::MeshError& error) {
    refuse(error);
  }
}

/// Nothing where the scenario does not fit the patient: an attempt that was interrupted elsewhere
/// was never planned here, and leaves as it came all the same.
std::optional<scenarios::Plan> plan_if_it_fits(const scenarios::Scenario& scenario,
                                               const simulator::Bones& bones) {
  try {
    return plan_on(scenario, bones);
  } catch (const scenarios::ScenarioError&) {
    return std::nullopt;
  }
}

/// A mesh of one of the bones, in the frame of the first.
std::string ply_in_first(simulator::IndexedMesh mesh, const simulator::Bones& bones,
                         std::size_t bone) {
  if (bone != 0) {
    const RigidTransform first_from_bone = first_from(bones, bone);
    for (Vec3& point_mm : mesh.points_mm) point_mm = transform_point(first_from_bone, point_mm);
  }
  return simulator::ply_bytes(mesh);
}

std::string bone_file_name(std::size_t bone) {
  return bone == 0 ? "bone.ply" : "bone-" + std::to_string(bone + 1) + ".ply";
}

void add_bones(const simulator::Bones& bones, std::vector<database::DerivedFile>& files) {
  for (std::size_t i = 0; i < bones.size(); ++i)
    files.push_back({bone_file_name(i), ply_in_first(solid_of(bones[i]), bones, i)});
}

void add_solids(const assessment::RebuiltBone& rebuilt, const simulator::Bones& bones,
                std::string (*name_of)(std::size_t), std::vector<database::DerivedFile>& files) {
  for (std::size_t i = 0; i < rebuilt.pieces.size() && i < pieces_max; ++i)
    files.push_back(
        {name_of(i), ply_in_first(rebuilt.pieces[i].mesh, bones, rebuilt.piece_bones[i])});
}

/// The pieces as they are scored, and how all bodies lie.
void add_left_behind(const scenarios::Scenario& scenario, const scenarios::Plan& plan,
                     const simulator::Bones& bones, const simulator::Recording& recording,
                     std::vector<database::DerivedFile>& files) {
  assessment::RebuiltBone scored = assessment::rebuild(
      bones, scenarios::tray_of(scenario), recording, {}, nullptr, {}, assessment::hinges_of(plan));
  const bool has_bodies_of_their_own = has_undivided_hinge(plan, recording);
  if (has_bodies_of_their_own) add_solids(scored, bones, piece_file_name, files);
  const auto name_of = has_bodies_of_their_own ? body_file_name : piece_file_name;
  const LeftBehind left = left_behind(scenario, plan, bones, recording, std::move(scored));
  files.push_back({fragments_file_name, fragments_file(left, bones, name_of)});
  files.push_back({implants_file_name, implants_file(left)});
  add_solids(left.rebuilt, bones, name_of, files);
}

}  // namespace

std::vector<database::DerivedFile> files_made_from(const database::ExportMaterial& material) {
  const scenarios::Scenario scenario =
      scenarios::parse_scenario(material.scenario.json, material.scenario.name);
  const std::vector<simulator::Bone> bones = simulator::decode_patient(material.bone);
  std::vector<database::DerivedFile> files;
  add_bones(bones, files);
  const auto plan = plan_if_it_fits(scenario, bones);
  if (!plan) {
    add_solids(assessment::rebuild(bones, scenarios::tray_of(scenario), material.recording), bones,
               piece_file_name, files);
    return files;
  }
  files.push_back({plan_file_name, plan_file(scenario, bones, *plan)});
  add_left_behind(scenario, *plan, bones, material.recording, files);
  return files;
}

void export_attempts(const ExportRequest& request, const FindDesk& desk_of,
                     const StageProgress& progress) {
  const Progress progress_of_all = progress("Exporting");
  const database::FreshDirectory fresh(request.folder, request.data_directory);
  for (std::size_t i = 0; i < request.attempts.size(); ++i) {
    cancelled_as("stopped while exporting; nothing was left in " + request.folder.string(),
                 [&] { hallux::report(one_of(progress_of_all, i, request.attempts.size()), 0.0); });
    desk_of(request.attempts[i]).export_attempt(request.attempts[i], fresh.path(), files_made_from);
  }
  fresh.finish();
  if (progress_of_all) progress_of_all(1.0);
}

ImportReport import_attempts(database::AdministratorDesk& desk, const std::filesystem::path& folder,
                             const StageProgress& progress) {
  desk.origins();  // Refuses here who may not, before anything of theirs is read.
  const std::vector<std::filesystem::path> folders = database::find_exported(folder);
  const auto whole = progress("Importing");
  ImportReport report;
  for (std::size_t i = 0; i < folders.size(); ++i) {
    const Progress part = one_of(whole, i, folders.size());
    const StageProgress within = [&part](const std::string&) { return Progress(part); };
    const std::string stopped = "stopped; " + std::to_string(report.imported.size()) +
                                " attempts were taken in, each of them whole";
    cancelled_as(stopped, [&] {
      hallux::report(part, 0.0);
      import_one(desk, folders[i], within, report);
    });
  }
  if (whole) whole(1.0);
  return report;
}

}  // namespace hallux::ui
