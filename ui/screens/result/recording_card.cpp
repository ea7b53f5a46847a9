#include "ui/screens/result/recording_card.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "simulator/device/station/device_kind.h"
#include "ui/screens/operating/hud/operating_health.h"
#include "ui/widgets/controls/card.h"
#include "ui/widgets/texts/number_text.h"

namespace hallux::ui {

namespace {

constexpr float least_line = 28.0F, title_height = 52.0F, column_gap = 48.0F, least_column = 300.0F;

struct RecordingLine {
  std::string_view name;
  std::string value;
};

std::string limits_text(const Texts& texts, std::uint32_t limits) {
  std::string words;
  for (const std::string_view id : limit_text_ids(limits))
    words += (words.empty() ? "" : ", ") + std::string(texts.text(id));
  return words.empty() ? std::string(texts.text("limit.none")) : words;
}

constexpr std::array<std::string_view, database::stored_names<database::Invalidity>.size()>
    invalidity_texts{"invalid.samples_lost",   "invalid.ticks_left_out", "invalid.ticks_doubled",
                     "invalid.clock_stepped",  "invalid.time_unseen",    "invalid.ticks_missed",
                     "invalid.device_faulted", "invalid.device_changed"};

/// What was sealed counts; the reasons are those of the certificate.
std::string validity_text(const Texts& texts, const ResultFacts& facts) {
  if (facts.header.is_valid.value_or(true)) return std::string(texts.text("operate.yes"));
  std::string reasons;
  for (const database::Invalidity reason : verdict_of(facts.quality->certificate).reasons) {
    const std::string_view id = invalidity_texts.at(static_cast<std::size_t>(reason));
    reasons += (reasons.empty() ? "" : "; ") + std::string(texts.text(id));
  }
  // By limits of another day it would be valid.
  if (reasons.empty()) return std::string(texts.text("operate.no"));
  return texts.say("result.recording.valid.not", {{"reasons", reasons}});
}

/// Where nobody was pushed back there is no arm to speak of.
void add_arm_lines(std::vector<RecordingLine>& lines, const Texts& texts, const Quality& quality) {
  const std::string_view scale = texts.text("result.recording.scale");
  if (quality.force_limits == 0 && quality.force_scale == 1.0) {
    lines.push_back({scale, std::string(texts.text("result.recording.scale.none"))});
    return;
  }
  lines.push_back({scale, grouped(std::lround(100.0 * quality.force_scale)) + " %"});
  lines.push_back(
      {texts.text("result.recording.limits"), limits_text(texts, quality.force_limits)});
  const bool is_historic = quality.force_law == simulator::ForceLaw::Thesis;
  lines.push_back({texts.text("result.recording.law"),
                   std::string(texts.text(is_historic ? "result.recording.law.historic"
                                                      : "result.recording.law.simulated"))});
}

std::string device_text(const Texts& texts, const ResultFacts& facts) {
  const std::string& device_class = facts.header.begun.device_class;
  if (!facts.quality->device) return device_class;
  return texts.say("result.recording.device.of",
                   {{"model", facts.quality->device->model}, {"class", device_class}});
}

/// Of a device that was plugged in: how far it can be trusted, and how it was held.
void add_device_lines(std::vector<RecordingLine>& lines, const Texts& texts,
                      const Quality& quality) {
  const auto add = [&](std::string_view id, std::string value) {
    lines.push_back({texts.text(id), std::move(value)});
  };
  if (quality.device) {
    const simulator::PortFigures& figures = quality.device->figures;
    const auto whole = [](double value) { return grouped(std::lround(value)); };
    add("result.recording.answers",
        texts.say("result.recording.answers.of", {{"half", whole(figures.round_trip_p50_us)},
                                                  {"most", whole(figures.round_trip_p99_us)}}));
    add("result.recording.packets",
        texts.say("result.recording.packets.of",
                  {{"all", grouped(static_cast<long>(figures.packets))},
                   {"late", grouped(static_cast<long>(figures.late_packets))},
                   {"bad", grouped(static_cast<long>(figures.bad_packets))}}));
    add("result.recording.motion", "× " + fixed_text(quality.device->motion_scale, 2));
    if (figures.calibration_age_s)
      add("result.recording.calibrated", clock_text(*figures.calibration_age_s));
    if (figures.own_force_scale)
      add("result.recording.own_scale", whole(100.0 * *figures.own_force_scale) + " %");
  }
  if (const simulator::KindFacts* second = simulator::kind_named(quality.second_device))
    add("result.recording.second", std::string(second->name));
}

std::vector<RecordingLine> lines_of(const Texts& texts, const ResultFacts& facts) {
  const Quality& quality = *facts.quality;
  const database::RecordingCertificate& certificate = quality.certificate;
  const auto granted = [&](bool is_granted) {
    return std::string(texts.text(is_granted ? "operate.yes" : "operate.no"));
  };
  const auto count = [](std::int64_t number) { return grouped(static_cast<long>(number)); };
  std::vector<RecordingLine> lines{
      {texts.text("result.recording.valid"), validity_text(texts, facts)},
      {texts.text("result.recording.device"), device_text(texts, facts)},
      {texts.text("result.recording.samples"),
       texts.say("result.recording.samples.of", {{"kept", count(certificate.received_samples)},
                                                 {"all", count(certificate.expected_samples)}})},
      {texts.text("result.recording.missed"), count(certificate.missed_ticks)},
      {texts.text("result.recording.pauses"), count(certificate.pauses)},
      {texts.text("result.recording.late"), grouped(std::lround(certificate.late_p99_us)) + " µs"},
      {texts.text("result.recording.priority"), granted(certificate.has_priority)},
      {texts.text("result.recording.memory"), granted(certificate.has_locked_memory)}};
  add_arm_lines(lines, texts, quality);
  add_device_lines(lines, texts, quality);
  return lines;
}

int column_count(float width) noexcept { return width >= 2.0F * least_column + column_gap ? 2 : 1; }

float line_height_of(const Ui& ui, const RecordingLine& line, float width) {
  const float value = ui.paragraph_height(Type::Small, line.value, 0.5F * width);
  return std::max(least_line, value + 8.0F);
}

}  // namespace

float recording_card_height(const Ui& ui, const ResultFacts& facts, float width) {
  const float inside = width - 2.0F * space::card;
  if (!facts.quality) {
    return title_height + space::card +
           ui.paragraph_height(Type::Body, ui.text("result.recording.unsealed"), inside);
  }
  const std::vector<RecordingLine> lines = lines_of(ui.texts(), facts);
  const int count = column_count(inside);
  const std::vector<Rect> places = columns({0.0F, 0.0F, inside, 0.0F}, count, column_gap);
  const std::size_t per_column = (lines.size() + places.size() - 1) / places.size();
  float highest = 0.0F, height = 0.0F;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (i % per_column == 0) height = 0.0F;
    height += line_height_of(ui, lines[i], places.front().w);
    highest = std::max(highest, height);
  }
  return title_height + highest + space::card;
}

void draw_recording_card(Ui& ui, const Rect& rect, const ResultFacts& facts) {
  const Rect inside = card(ui, rect, ui.text("result.recording"));
  if (!facts.quality) {
    ui.canvas().paragraph(inside, {Type::Body, ui.theme().text_secondary},
                          ui.text("result.recording.unsealed"));
    return;
  }
  const std::vector<RecordingLine> lines = lines_of(ui.texts(), facts);
  std::vector<Rect> places = columns(inside, column_count(inside.w), column_gap);
  const std::size_t per_column = (lines.size() + places.size() - 1) / places.size();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    Rect& rest = places[i / per_column];
    Rect line = take_top(rest, line_height_of(ui, lines[i], rest.w));
    const Rect name = take_left(line, 0.5F * rest.w);
    ui.canvas().text_in({name.x, name.y, name.w - 8.0F, least_line},
                        {Type::Small, ui.theme().text_caption}, lines[i].name, true);
    const float words = ui.paragraph_height(Type::Small, lines[i].value, line.w);
    ui.canvas().paragraph({line.x, line.mid_y() - 0.5F * words, line.w, words},
                          {Type::Small, ui.theme().text}, lines[i].value);
  }
}

}  // namespace hallux::ui
