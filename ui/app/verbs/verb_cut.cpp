/// cut: the kernel on any closed mesh, without a scenario. --plane, --kerf and --sweep are groups
/// in the order in which they stand on the line, which is read from CLI11's own record of it. The
/// balance of volumes is the exit code: pieces, debris and what was removed must add up to the
/// input.
#include "ui/app/verbs/verbs.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string_view>

#include "simulator/base/units.h"
#include "ui/jobs/cut_mesh.h"
#include "ui/jobs/frame_times.h"

namespace hallux::ui {

namespace {

using nlohmann::ordered_json;
using simulator::HingeOutcome;

/// Of the input: pieces, debris and what was removed must add up to it this well.
constexpr double balance_tolerance = 1.0e-6;

/// What stands on the line, in the order in which it stands there.
struct CutOptions {
  std::string mesh, output, close;
  std::vector<std::string> planes, kerfs, sweeps;
};

double number_from(std::string_view text, const std::string& option) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) {
    throw CLI::ValidationError(option, "'" + std::string(text) + "' is not a number");
  }
  return value;
}

CutGroup group_from(std::string_view text) {
  std::array<double, 4> numbers{};
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t comma = text.find(',');
    if ((comma == std::string_view::npos) != (i == 3)) {
      throw CLI::ValidationError("--plane", "takes four numbers nx,ny,nz,d");
    }
    numbers[i] = number_from(text.substr(0, comma), "--plane");
    text.remove_prefix(i == 3 ? 0 : comma + 1);
  }
  CutGroup group;
  group.normal = Vec3(numbers[0], numbers[1], numbers[2]);
  group.offset = numbers[3];
  group.kerf_mm = 0.0;
  const double length = std::sqrt(glm::dot(group.normal, group.normal));
  if (!(length >= 1.0e-9 && length <= 1.0e9)) {
    throw CLI::ValidationError("--plane", "the normal must have a length");
  }
  return group;
}

double kerf_from(const std::string& text) {
  const double kerf_mm = number_from(text, "--kerf");
  if (kerf_mm < 0.001 || kerf_mm > 50.0) {
    throw CLI::ValidationError("--kerf", "a kerf is 0.001 to 50 mm thick");
  }
  return kerf_mm;
}

/// --kerf and --sweep belong to the --plane before them.
std::vector<CutGroup> groups_from(const CLI::App& verb, const CutOptions& options) {
  std::vector<CutGroup> groups;
  std::size_t plane_count = 0, kerf_count = 0, sweep_count = 0;
  const auto last_group = [&](const std::string& option) -> CutGroup& {
    if (groups.empty()) throw CLI::ValidationError(option, "must follow the --plane it belongs to");
    return groups.back();
  };
  for (const CLI::Option* option : verb.parse_order()) {
    const std::string name = option->get_name();
    if (name == "--plane") {
      groups.push_back(group_from(options.planes.at(plane_count++)));
    } else if (name == "--kerf") {
      CutGroup& group = last_group(name);
      if (group.kerf_mm > 0.0) throw CLI::ValidationError(name, "is given twice for one --plane");
      group.kerf_mm = kerf_from(options.kerfs.at(kerf_count++));
    } else if (name == "--sweep") {
      CutGroup& group = last_group(name);
      if (group.sweep_file) throw CLI::ValidationError(name, "is given twice for one --plane");
      group.sweep_file = options.sweeps.at(sweep_count++);
    }
  }
  for (const CutGroup& group : groups) {
    if (group.kerf_mm <= 0.0)
      throw CLI::ValidationError("--kerf", "every --plane needs its --kerf");
  }
  return groups;
}

/// "2,1" of three groups are the indices 1 and 0.
HingeGroups hinge_from(std::string_view text, std::size_t group_count) {
  const CLI::ValidationError refusal(
      "--close", "takes the numbers A,B of two groups, 1 to " + std::to_string(group_count));
  const auto index_from = [&](std::string_view digits) {
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    const bool is_number = error == std::errc{} && end == digits.data() + digits.size();
    if (!is_number || number < 1 || number > group_count) throw refusal;
    return number - 1;
  };
  const std::size_t comma = text.find(',');
  if (comma == std::string_view::npos) throw refusal;
  const HingeGroups groups{index_from(text.substr(0, comma)), index_from(text.substr(comma + 1))};
  if (groups.first == groups.second) throw refusal;
  return groups;
}

const char* name_of(HingeOutcome outcome) {
  switch (outcome) {
    case HingeOutcome::Closed:
      return "closed";
    case HingeOutcome::Broken:
      return "broken";
    case HingeOutcome::Stiff:
      return "does not bend";
    case HingeOutcome::FacesMissing:
      return "does not touch";
  }
  return "";
}

ordered_json times_json(const std::vector<double>& frame_ms) {
  const std::optional<FrameTimes> times = frame_times(frame_ms);
  if (!times) return {{"median", nullptr}, {"p99", nullptr}, {"max", nullptr}};
  return {{"median", times->median_ms}, {"p99", times->p99_ms}, {"max", times->max_ms}};
}

ordered_json cut_json(const GroupOutcome& cut, std::size_t group) {
  const bool is_reopened = cut.kerf && *cut.kerf != group;
  return {{"contact_ms", cut.contact_ms},
          {"frames", cut.frame_ms.size()},
          {"frame_ms", times_json(cut.frame_ms)},
          {"refused_frames", cut.refused_frames},
          {"nudges", cut.nudges},
          {"reopens", is_reopened ? ordered_json(*cut.kerf + 1) : ordered_json(nullptr)},
          {"removed_mm3", cut.removed_mm3}};
}

ordered_json hinge_json(const std::optional<HingeReport>& hinge) {
  if (!hinge) return nullptr;
  const bool is_closed = hinge->outcome == HingeOutcome::Closed;
  const ordered_json angle =
      is_closed ? ordered_json(degree_from_radian(hinge->angle_rad)) : ordered_json(nullptr);
  return {{"outcome", name_of(hinge->outcome)}, {"angle_deg", angle},
          {"hinge_mm", hinge->thickness_mm},    {"wedge", hinge->wedge_file},
          {"fixed", hinge->fixed_file},         {"moved", hinge->moved_file}};
}

/// All groups as one.
GroupOutcome sum_of(const std::vector<GroupOutcome>& cuts) {
  GroupOutcome sum;
  for (const GroupOutcome& cut : cuts) {
    sum.frame_ms.insert(sum.frame_ms.end(), cut.frame_ms.begin(), cut.frame_ms.end());
    sum.refused_frames += cut.refused_frames;
    sum.triangles_max = std::max(sum.triangles_max, cut.triangles_max);
  }
  return sum;
}

ordered_json report_json(const CutReport& report) {
  ordered_json pieces = ordered_json::array(), cuts = ordered_json::array();
  for (const WrittenPiece& piece : report.pieces) {
    pieces.push_back({{"file", piece.file},
                      {"triangles", piece.triangles},
                      {"volume_mm3", piece.volume_mm3},
                      {"closed", piece.is_closed}});
  }
  for (const GroupOutcome& cut : report.cuts) cuts.push_back(cut_json(cut, cuts.size()));
  const GroupOutcome sum = sum_of(report.cuts);
  return {{"input_mm3", report.input_mm3},
          {"removed_mm3", report.removed_mm3},
          {"debris_mm3", report.debris_mm3},
          {"debris_pieces", report.debris_pieces},
          {"missing_mm3", report.missing_mm3()},
          {"pieces", std::move(pieces)},
          {"cuts", std::move(cuts)},
          {"frame_ms", times_json(sum.frame_ms)},
          {"refused_frames", sum.refused_frames},
          {"triangles_max", sum.triangles_max},
          {"hinge", hinge_json(report.hinge)}};
}

void print_report(std::ostream& out, const CutReport& report) {
  out << "volume " << report.input_mm3 << " mm3, removed " << report.removed_mm3 << " mm3, debris "
      << report.debris_mm3 << " mm3 in " << report.debris_pieces << " pieces\n";
  if (const auto times = frame_times(sum_of(report.cuts).frame_ms)) {
    out << "a frame took " << times->median_ms << " ms (median), " << times->p99_ms
        << " ms (99 of 100), " << times->max_ms << " ms (most)\n";
  }
  for (const WrittenPiece& piece : report.pieces) {
    out << piece.file << "  " << piece.volume_mm3 << " mm3  " << piece.triangles << " triangles  "
        << (piece.is_closed ? "closed" : "NOT CLOSED") << "\n";
  }
  if (!report.hinge) return;
  out << "hinge of " << report.hinge->thickness_mm << " mm: " << name_of(report.hinge->outcome);
  if (report.hinge->outcome == HingeOutcome::Closed) {
    out << ", " << report.hinge->moved_file << " turned by "
        << degree_from_radian(report.hinge->angle_rad) << " degrees";
  }
  out << "\n";
}

/// What the kernel promises of every cut; the answer is given all the same.
void expect_promises(const CutReport& report, const std::string& mesh) {
  for (const WrittenPiece& piece : report.pieces) {
    if (piece.is_closed) continue;
    throw VerbError(ExitCode::CheckFailed, mesh + ": " + piece.file +
                                               " is not closed; keep the mesh and the planes for "
                                               "a report, and move the last plane by 0.01 mm");
  }
  if (std::abs(report.missing_mm3()) <= balance_tolerance * report.input_mm3) return;
  throw VerbError(ExitCode::CheckFailed,
                  mesh + ": pieces, debris and what was removed miss the input's " +
                      std::to_string(report.input_mm3) + " mm3 by " +
                      std::to_string(report.missing_mm3()) +
                      " mm3; keep the mesh and the planes for a report");
}

CutReport cut_or_refuse(const VerbContext& context, const CutRequest& request) {
  try {
    return cut_mesh(request, progress_on(context, "Cutting"));
  } catch (const KernelRefusal& refusal) {
    throw VerbError(ExitCode::CheckFailed,
                    request.mesh_file.filename().string() + ": " + refusal.what());
  }
}

ExitCode cut_on(const VerbContext& context, const CutRequest& request) {
  const CutReport report = cut_or_refuse(context, request);
  answer(context, report_json(report), [&](std::ostream& out) { print_report(out, report); });
  expect_promises(report, request.mesh_file.filename().string());
  return ExitCode::Done;
}

}  // namespace

void add_cut_verb(CLI::App& app, VerbContext& context) {
  CLI::App* verb = app.add_subcommand(
      "cut",
      "cut a closed mesh by planes and write its pieces; groups of --plane, --kerf and "
      "--sweep may be repeated and act in turn");
  const auto options = std::make_shared<CutOptions>();
  verb->add_option("MESH", options->mesh, "closed STL, OBJ or PLY in millimetres")->required();
  verb->add_option("--plane", options->planes, "nx,ny,nz,d: the kerf's middle plane n.p = d")
      ->required()
      ->allow_extra_args(false);
  verb->add_option("--kerf", options->kerfs, "thickness of what is taken away, in millimetres")
      ->required()
      ->allow_extra_args(false);
  verb->add_option("--sweep", options->sweeps,
                   "JSON file with the blade and its motion; without it the cut goes all the way "
                   "through")
      ->allow_extra_args(false);
  verb->add_option("--close", options->close,
                   "A,B: turn the bone beyond group B about the bridge that groups A and B leave, "
                   "until their wedge is closed");
  verb->add_option("-o,--output", options->output, "folder for piece-1.ply ...")
      ->required()
      ->check(fault_in_place);
  verb->callback([verb, options, &context] {
    CutRequest request{options->mesh, groups_from(*verb, *options), options->output,
                       context.data_directory};
    if (!options->close.empty()) {
      request.close = hinge_from(options->close, request.groups.size());
    }
    context.chosen = [request = std::move(request), &context] { return cut_on(context, request); };
  });
}

}  // namespace hallux::ui
