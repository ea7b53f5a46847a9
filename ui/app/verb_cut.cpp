#include "ui/app/verb_cut.h"

#include <CLI/CLI.hpp>
#include <array>
#include <charconv>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string_view>

#include "ui/app/write_json.h"
#include "ui/jobs/cut_mesh.h"

namespace hallux::ui {

namespace {

using nlohmann::ordered_json;

/// What stands on the line, in the order in which it stands there.
struct CutOptions {
  std::string mesh, output;
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

ordered_json report_json(const CutReport& report) {
  ordered_json pieces = ordered_json::array(), cuts = ordered_json::array();
  for (const WrittenPiece& piece : report.pieces) {
    pieces.push_back({{"file", piece.file},
                      {"triangles", piece.triangles},
                      {"volume_mm3", piece.volume_mm3},
                      {"closed", piece.is_closed}});
  }
  for (const GroupOutcome& cut : report.cuts) {
    cuts.push_back({{"contact_ms", cut.contact_ms}, {"removed_mm3", cut.removed_mm3}});
  }
  return {{"input_mm3", report.input_mm3},
          {"removed_mm3", report.removed_mm3},
          {"debris_mm3", report.debris_mm3},
          {"debris_pieces", report.debris_pieces},
          {"pieces", std::move(pieces)},
          {"cuts", std::move(cuts)},
          {"frame_ms", {{"median", nullptr}, {"p99", nullptr}, {"max", nullptr}}},
          {"triangles_max", report.triangles_max}};
}

void print_report(std::ostream& out, const CutReport& report) {
  out << "volume " << report.input_mm3 << " mm3, removed " << report.removed_mm3 << " mm3, debris "
      << report.debris_mm3 << " mm3 in " << report.debris_pieces << " pieces\n";
  for (const WrittenPiece& piece : report.pieces) {
    out << piece.file << "  " << piece.volume_mm3 << " mm3  " << piece.triangles << " triangles  "
        << (piece.is_closed ? "closed" : "NOT CLOSED") << "\n";
  }
}

ExitCode cut_on(const VerbContext& context, const CutRequest& request) {
  const CutReport report = cut_mesh(request, progress_on(context, "Cutting"));
  if (context.json) {
    write_json(context.out, report_json(report));
  } else {
    print_report(context.out, report);
  }
  const bool all_closed = std::all_of(report.pieces.begin(), report.pieces.end(),
                                      [](const WrittenPiece& piece) { return piece.is_closed; });
  return all_closed ? ExitCode::Done : ExitCode::CheckFailed;
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
  verb->add_option("-o,--output", options->output, "folder for piece-1.ply ...")->required();
  verb->callback([verb, options, &context] {
    CutRequest request{options->mesh, groups_from(*verb, *options), options->output};
    context.chosen = [request = std::move(request), &context] { return cut_on(context, request); };
  });
}

}  // namespace hallux::ui
