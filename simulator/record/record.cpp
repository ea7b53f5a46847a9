#include "simulator/record/record.h"

#include "simulator/base/units.h"

namespace hallux::simulator {

namespace {

/// Writes integers into a row, in one fixed order.
struct RowWriter {
  std::int64_t* at;
  template <typename Integer>
  void operator()(const Integer& value) noexcept {
    *at++ = static_cast<std::int64_t>(value);
  }
};

/// Takes them off again.
struct RowReader {
  const std::int64_t* at;
  template <typename Integer>
  void operator()(Integer& value) noexcept {
    value = static_cast<Integer>(*at++);
  }
};

template <typename Port>
void pass(Port& port, QuantisedPose& pose) noexcept {
  for (std::int32_t& part : pose.translation_um) port(part);
  for (std::int32_t& part : pose.rotation_micro) port(part);
}

template <typename Port>
void pass(Port& port, TapeLine& line) noexcept {
  port(line.tick);
  pass(port, line.device.world_from_handle);
  // Switches and faults share a column.
  auto bits = line.device.switches | (static_cast<std::int64_t>(line.device.faults) << 32U);
  port(bits);
  line.device.switches = static_cast<std::uint32_t>(bits & 0xFFFFFFFFLL);
  line.device.faults = static_cast<std::uint32_t>(bits >> 32U);
  port(line.ticks);
  port(line.command_count);
  for (Command& command : line.commands) {
    port(command.kind);
    port(command.argument);
    port(command.detail);
  }
}

template <typename Port>
void pass(Port& port, ToolSample& sample) noexcept {
  port(sample.tick);
  pass(port, sample.world_from_tool);
  for (std::int32_t& part : sample.force_mn) port(part);
  port(sample.status);
  port(sample.kerf);
}

template <typename Port>
void pass(Port& port, CutEvent& event) noexcept {
  port(event.tick);
  port(event.kind);
  port(event.subject);
  port(event.value);
  pass(port, event.pose);
}

template <std::size_t Count, typename Row>
std::array<std::int64_t, Count> written(Row row) noexcept {
  std::array<std::int64_t, Count> columns{};
  RowWriter writer{columns.data()};
  pass(writer, row);
  return columns;
}

template <typename Row, std::size_t Count>
Row read(const std::array<std::int64_t, Count>& columns) noexcept {
  Row row;
  RowReader reader{columns.data()};
  pass(reader, row);
  return row;
}

template <typename Row>
void add_rows(Digester& digester, const std::vector<Row>& rows) noexcept {
  digester.add_int(static_cast<std::int64_t>(rows.size()));
  for (const Row& row : rows) {
    for (const std::int64_t value : columns_of(row)) digester.add_int(value);
  }
}

}  // namespace

QuantisedPose quantise(const RigidTransform& pose) noexcept {
  const Quat rotation = normalised(pose.rotation);
  QuantisedPose quantised;
  quantised.translation_um = {um_from_mm(pose.translation_mm.x), um_from_mm(pose.translation_mm.y),
                              um_from_mm(pose.translation_mm.z)};
  quantised.rotation_micro = {micro_from_unit(rotation.w), micro_from_unit(rotation.x),
                              micro_from_unit(rotation.y), micro_from_unit(rotation.z)};
  for (const std::int32_t part : quantised.rotation_micro) {
    if (part == 0) continue;
    if (part < 0) {
      for (std::int32_t& other : quantised.rotation_micro) other = -other;
    }
    break;
  }
  return quantised;
}

RigidTransform transform_from(const QuantisedPose& pose) noexcept {
  return {normalised(Quat{
              unit_from_micro(pose.rotation_micro[0]), unit_from_micro(pose.rotation_micro[1]),
              unit_from_micro(pose.rotation_micro[2]), unit_from_micro(pose.rotation_micro[3])}),
          Vec3{mm_from_um(pose.translation_um[0]), mm_from_um(pose.translation_um[1]),
               mm_from_um(pose.translation_um[2])}};
}

std::array<std::int64_t, tape_columns> columns_of(const TapeLine& line) noexcept {
  return written<tape_columns>(line);
}
std::array<std::int64_t, sample_columns> columns_of(const ToolSample& sample) noexcept {
  return written<sample_columns>(sample);
}
std::array<std::int64_t, event_columns> columns_of(const CutEvent& event) noexcept {
  return written<event_columns>(event);
}

TapeLine tape_line_from(const std::array<std::int64_t, tape_columns>& columns) noexcept {
  return read<TapeLine>(columns);
}
ToolSample tool_sample_from(const std::array<std::int64_t, sample_columns>& columns) noexcept {
  return read<ToolSample>(columns);
}
CutEvent cut_event_from(const std::array<std::int64_t, event_columns>& columns) noexcept {
  return read<CutEvent>(columns);
}

Digest digest_outputs(const Recording& recording) noexcept {
  Digester digester;
  digester.add_int(recording.engine);
  add_rows(digester, recording.samples);
  add_rows(digester, recording.events);
  return digester.finish();
}

}  // namespace hallux::simulator
