#include "ui/jobs/cached_fields.h"

#include <bit>

#include "database/content/cached_bytes.h"
#include "database/store/database_error.h"
#include "scenarios/tray/laid_out_tools.h"
#include "simulator/base/progress.h"
#include "ui/jobs/files/byte_form.h"

namespace hallux::ui {

namespace {

using assessment::OpenedFields;
using simulator::FieldGrid;
using simulator::FieldWindow;
using simulator::OpenedField;

/// Another form of these bytes, or another way to open fields, has another number.
constexpr std::int64_t form_version = 1;
constexpr std::int32_t nodes_max = 1 << 14;
/// Opening the fields takes about this share of the time; the rest is cutting solids and
/// measuring.
constexpr double fields_share = 0.4;

bool is_within(const FieldWindow& window, const FieldGrid& grid) noexcept {
  const bool is_sane = grid.spacing_mm > 0.0 && grid.u_count > 0 && grid.v_count > 0 &&
                       grid.u_count <= nodes_max && grid.v_count <= nodes_max;
  return is_sane && window.u_first >= 0 && window.u_first <= window.u_last &&
         window.u_last <= grid.u_count && window.v_first >= 0 && window.v_first <= window.v_last &&
         window.v_last <= grid.v_count;
}

std::size_t nodes_of(const FieldWindow& window) noexcept {
  return static_cast<std::size_t>(window.u_last - window.u_first) *
         static_cast<std::size_t>(window.v_last - window.v_first);
}

bool take_field(ByteReader& reader, OpenedField& field) {
  if (!reader.take(field.plane) || !reader.take(field.grid) || !reader.take(field.window) ||
      !is_within(field.window, field.grid))
    return false;
  const std::size_t nodes = nodes_of(field.window);
  if (nodes * (sizeof(float) + sizeof(std::int32_t)) > reader.left()) return false;
  field.inside_mm.resize(nodes);
  field.opened_tick.resize(nodes);
  return reader.take_all(std::span(field.inside_mm)) &&
         reader.take_all(std::span(field.opened_tick));
}

/// Of all that the fields are made from.
Digest key_of(const AttemptMaterial& material) {
  Digester digester;
  digester.add_int(form_version);
  digester.add_int(std::endian::native == std::endian::little ? 1 : 2);
  digester.add_int(material.header.begun.engine);
  digester.add_digest(material.header.begun.bone);
  const simulator::Tray tray = scenarios::tray_of(material.scenario);
  for (std::int32_t place = 0; place < tray.count(); ++place) {
    const simulator::Saw* const saw = tray.saw(place);
    if (saw == nullptr) continue;
    for (const double size : {saw->blade.width_mm, saw->blade.depth_mm, saw->blade.kerf_mm})
      digester.add_double(size);
  }
  digester.add_digest(digest_outputs(material.recording));
  return digester.finish();
}

/// Kept, or not: the fields are there either way, and what cannot be kept is made again the next
/// time.
void keep(const AttemptMaterial& material, const std::filesystem::path& data_directory,
          const Digest& key, const OpenedFields& fields) {
  try {
    database::store_cached(data_directory, cached_fields_name(material.header.id), key,
                           bytes_of(fields));
  } catch (const database::DatabaseError& error) {
    if (!is_storage_failure(error.kind())) throw;
  }
}

}  // namespace

std::string cached_fields_name(const database::AttemptId& attempt) {
  return attempt.text + ".fields";
}

std::vector<std::byte> bytes_of(const OpenedFields& fields) {
  ByteWriter writer;
  writer.add(static_cast<std::uint64_t>(fields.size()));
  for (const OpenedField& field : fields) {
    writer.add(field.plane);
    writer.add(field.grid);
    writer.add(field.window);
    writer.add_bytes(std::as_bytes(std::span(field.inside_mm)));
    writer.add_bytes(std::as_bytes(std::span(field.opened_tick)));
  }
  return writer.take();
}

std::optional<OpenedFields> fields_from(std::span<const std::byte> bytes) {
  ByteReader reader(bytes);
  std::uint64_t count = 0;
  if (!reader.take(count) || count > static_cast<std::uint64_t>(simulator::kerf_limit))
    return std::nullopt;
  OpenedFields fields(count);
  for (OpenedField& field : fields) {
    if (!take_field(reader, field)) return std::nullopt;
  }
  if (reader.left() != 0) return std::nullopt;
  return fields;
}

OpenedFields fields_of(const AttemptMaterial& material, const std::filesystem::path& data_directory,
                       const Progress& progress) {
  const Digest key = key_of(material);
  const simulator::Tray tray = scenarios::tray_of(material.scenario);
  if (const auto kept =
          database::load_cached(data_directory, cached_fields_name(material.header.id), key)) {
    std::optional<OpenedFields> fields = fields_from(*kept);
    if (fields && assessment::are_of(*fields, tray, material.bones, material.recording)) {
      report(progress, 1.0);
      return *std::move(fields);
    }
  }
  OpenedFields fields =
      assessment::opened_fields(tray, material.bones, material.recording, progress);
  keep(material, data_directory, key, fields);
  report(progress, 1.0);
  return fields;
}

assessment::Examination examine_kept(const AttemptMaterial& material,
                                     const std::filesystem::path& data_directory,
                                     std::vector<assessment::Measurement> measurements,
                                     const StageProgress& progress) {
  const Progress reached = progress("Examining");
  return cancelled_as("stopped while examining; nothing was changed", [&] {
    assessment::Measured measured{
        std::move(measurements),
        fields_of(material, data_directory, part_of(reached, 0.0, fields_share))};
    return assessment::examine_measured(material.scenario, material.bones, material.recording,
                                        material.header.begun.device_class, std::move(measured),
                                        part_of(reached, fields_share, 1.0));
  });
}

}  // namespace hallux::ui
