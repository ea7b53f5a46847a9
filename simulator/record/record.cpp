#include "simulator/record/record.h"

#include "simulator/base/units.h"

namespace hallux::simulator {

namespace {

/// Appends integers to a row, or takes them off again, in one fixed order.
template <std::size_t Count>
class RowWriter {
 public:
  void add(std::int64_t value) noexcept { row_[used_++] = value; }
  void add(const QuantisedPose& pose) noexcept {
    for (const std::int32_t part : pose.translation_um) add(part);
    for (const std::int32_t part : pose.rotation_micro) add(part);
  }
  const std::array<std::int64_t, Count>& row() const noexcept { return row_; }

 private:
  std::array<std::int64_t, Count> row_{};
  std::size_t used_ = 0;
};

template <std::size_t Count>
class RowReader {
 public:
  explicit RowReader(const std::array<std::int64_t, Count>& row) noexcept : row_(row) {}
  template <typename Integer>
  Integer take() noexcept {
    return static_cast<Integer>(row_[used_++]);
  }
  QuantisedPose take_pose() noexcept {
    QuantisedPose pose;
    for (std::int32_t& part : pose.translation_um) part = take<std::int32_t>();
    for (std::int32_t& part : pose.rotation_micro) part = take<std::int32_t>();
    return pose;
  }

 private:
  const std::array<std::int64_t, Count>& row_;
  std::size_t used_ = 0;
};

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
  RowWriter<tape_columns> row;
  row.add(line.tick);
  row.add(line.device.world_from_handle);
  row.add(line.device.switches | (static_cast<std::int64_t>(line.device.faults) << 32U));
  row.add(line.ticks);
  row.add(line.command_count);
  for (const Command& command : line.commands) {
    row.add(static_cast<std::int32_t>(command.kind));
    row.add(command.argument);
    row.add(command.detail);
  }
  return row.row();
}

TapeLine tape_line_from(const std::array<std::int64_t, tape_columns>& columns) noexcept {
  RowReader row{columns};
  TapeLine line;
  line.tick = row.template take<std::int64_t>();
  line.device.world_from_handle = row.take_pose();
  const auto bits = row.template take<std::int64_t>();
  line.device.switches = static_cast<std::uint32_t>(bits & 0xFFFFFFFFLL);
  line.device.faults = static_cast<std::uint32_t>(bits >> 32U);
  line.ticks = row.template take<std::uint8_t>();
  line.command_count = row.template take<std::uint8_t>();
  for (Command& command : line.commands) {
    command.kind = static_cast<CommandKind>(row.template take<std::int32_t>());
    command.argument = row.template take<std::int32_t>();
    command.detail = row.template take<std::int64_t>();
  }
  return line;
}

std::array<std::int64_t, sample_columns> columns_of(const ToolSample& sample) noexcept {
  RowWriter<sample_columns> row;
  row.add(sample.tick);
  row.add(sample.world_from_tool);
  for (const std::int32_t part : sample.force_mn) row.add(part);
  row.add(sample.status);
  row.add(sample.kerf);
  return row.row();
}

ToolSample tool_sample_from(const std::array<std::int64_t, sample_columns>& columns) noexcept {
  RowReader row{columns};
  ToolSample sample;
  sample.tick = row.template take<std::int64_t>();
  sample.world_from_tool = row.take_pose();
  for (std::int32_t& part : sample.force_mn) part = row.template take<std::int32_t>();
  sample.status = row.template take<std::uint32_t>();
  sample.kerf = row.template take<std::int32_t>();
  return sample;
}

std::array<std::int64_t, event_columns> columns_of(const CutEvent& event) noexcept {
  RowWriter<event_columns> row;
  row.add(event.tick);
  row.add(static_cast<std::int32_t>(event.kind));
  row.add(event.subject);
  row.add(event.value);
  row.add(event.pose);
  return row.row();
}

CutEvent cut_event_from(const std::array<std::int64_t, event_columns>& columns) noexcept {
  RowReader row{columns};
  CutEvent event;
  event.tick = row.template take<std::int64_t>();
  event.kind = static_cast<CutEventKind>(row.template take<std::int32_t>());
  event.subject = row.template take<std::int32_t>();
  event.value = row.template take<std::int64_t>();
  event.pose = row.take_pose();
  return event;
}

Digest digest_outputs(const Recording& recording) noexcept {
  Digester digester;
  digester.add_int(recording.engine);
  add_rows(digester, recording.samples);
  add_rows(digester, recording.events);
  return digester.finish();
}

}  // namespace hallux::simulator
