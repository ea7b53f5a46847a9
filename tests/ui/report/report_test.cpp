#include "ui/report/html_report.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "ui/report/effects_text.h"
#include "ui/report/html_text.h"
#include "ui/report/measured_text.h"
#include "ui/report/report_facts.h"
#include "ui/report/report_pictures.h"
#include "ui/report/score_sheet.h"

namespace hallux::ui {
namespace {

using database::LedgerLine;

LedgerLine line(const std::string& item, const std::string& text, std::int64_t lost_milli) {
  LedgerLine made;
  made.item = item;
  made.text = text;
  made.unit = "mm";
  made.value = 1.25;
  made.group = "accuracy";
  made.weight_milli = 25000;
  made.points_lost_milli = lost_milli;
  made.start_us = 2700000;
  made.end_us = 61000000;
  return made;
}

std::vector<Vec2> circle(double radius_mm) {
  std::vector<Vec2> points;
  for (int step = 0; step < 60; ++step) {
    const double angle_rad = 0.1047 * step;
    points.emplace_back(radius_mm * std::cos(angle_rad), radius_mm * std::sin(angle_rad));
  }
  return points;
}

ReportMaterial made_up() {
  ReportMaterial material;
  material.title = "Silver exostectomy";
  database::ScoreCard& card = material.card;
  card.groups = {{"accuracy", 50000, 50000, 40000}, {"safety", 50000, 0, 0}};
  card.rubric_milli = 100000;
  card.measured_milli = 50000;
  card.earned_milli = 40000;
  card.score_milli = 80000;
  card.ledger = {line("A1", "The face is tilted.", 10000), line("A2", "The place is right.", 0)};
  card.shown_losses_milli = {20000, 0};
  card.sentences = {"The face is tilted."};
  card.gates = {{"past_sulcus", 59000, false, 0.0, 1.0, "mm", "Past the sulcus: 0.00 mm."}};
  material.group_titles = {"Accuracy", "Safety"};
  material.gate_titles = {"Past the sulcus"};
  material.quality = "Recording complete.";
  material.faces = {FacePicture{
      "The cut", "distal", "dorsal", "medial", "lateral", {circle(9.0)}, {}, 0.5, {}, true}};
  material.faces[0].dots = {{Vec2{0.0, 0.0}, 0.9}, {Vec2{0.5, 0.0}, -0.9}};
  material.frontal = FrontalPicture{{circle(9.0), circle(4.0)},
                                    {Vec2{-5.0, -12.0}, Vec2{-5.0, 12.0}},
                                    PictureLine{Vec2{-4.0, -12.0}, Vec2{-6.0, 12.0}},
                                    {"depth landmark", Vec2{-7.0, 4.0}}};
  material.traces.points = {
      {0.0, 0.0, {}, 0.0, 37.0}, {1.0, 9.5, 3.0, 0.5, 62.0}, {2.0, 4.0, {}, 0.0, 51.0}};
  material.traces.heat.hottest_celsius = 62.4;
  material.traces.heat.hot_s = 3.26;
  material.traces.marks = {{0.5, "plane frozen"}};
  return material;
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

TEST(Report, CarriesItsMarksWhereverTheScoreIsSeen) {
  for (const std::string& text : {html_report(made_up()), score_sheet(made_up())}) {
    EXPECT_NE(text.find("80.0"), std::string::npos);
    EXPECT_NE(text.find("machine score, not confirmed"), std::string::npos);
    EXPECT_NE(text.find("not surgeon-reviewed"), std::string::npos);
    EXPECT_NE(text.find("partial: 50 % of the rubric is measured"), std::string::npos);
    EXPECT_NE(text.find("not measured yet"), std::string::npos);
  }
}

TEST(Report, WhatIsLostAndTheScoreAreAHundredOnPageAndSheet) {
  const std::string html = html_report(made_up());
  EXPECT_NE(html.find("Score 80 + 20 lost = 100 points"), std::string::npos);
  EXPECT_NE(html.find("<b>80</b> of 100"), std::string::npos);
  const std::string sheet = score_sheet(made_up());
  EXPECT_NE(sheet.find("80 of 100\n"), std::string::npos);
  EXPECT_NE(sheet.find("     -20  The face is tilted."), std::string::npos);
}

TEST(Report, SaysWhatWouldHaveEarnedMoreOrWhyNothing) {
  ReportMaterial material = made_up();
  EXPECT_EQ(html_report(material).find("What would have earned more"), std::string::npos);
  material.what_if.changes = {{"Turned back", "Its edge lay too far", "+4.2 points", {"A1"}}};
  std::string html = html_report(material);
  EXPECT_LT(html.find("What cost the most"), html.find("What would have earned more"));
  for (const char* words : {"<strong>Turned back</strong>", "Its edge lay too far", "+4.2 points"})
    EXPECT_NE(html.find(words), std::string::npos) << words;
  EXPECT_EQ(count_of(html, "class=\"gain\""), 1U) << "one alone is not together";
  material.what_if.together = "Both together";
  EXPECT_EQ(count_of(html_report(material), "class=\"gain\""), 2U);
  material.what_if = {};
  material.what_if.nothing = "Every point was earned";
  html = html_report(material);
  EXPECT_NE(html.find("<p>Every point was earned</p>"), std::string::npos);
  EXPECT_EQ(html.find("class=\"gain\""), std::string::npos);
}

TEST(Report, ThatHeatIsNotScoredIsSaidWhereItIsNot) {
  ReportMaterial material = made_up();
  EXPECT_NE(html_report(material).find("nothing is scored by it"), std::string::npos);
  EXPECT_FALSE(are_effects_scored(material.card));
  database::LedgerLine heat;
  heat.item = "H4";
  heat.metric = "hot_s";
  material.card.ledger.push_back(heat);
  material.card.shown_losses_milli.push_back(0);
  EXPECT_TRUE(are_effects_scored(material.card));
  EXPECT_EQ(html_report(material).find("nothing is scored by it"), std::string::npos);
  material.card.ledger.back().kind = database::LedgerKind::Gate;
  EXPECT_FALSE(are_effects_scored(material.card));
}

TEST(Report, ALedgerSaysClaimsAsYesOrNo) {
  database::LedgerLine line;
  line.metric = "started_in_bone";
  line.is_measured = true;
  EXPECT_EQ(measured_text(line), "no");
  line.value = 1.0;
  EXPECT_EQ(measured_text(line), "yes");
  line.metric = "piece_out";
  line.kind = database::LedgerKind::Gate;
  line.value = 0.0;
  EXPECT_EQ(measured_text(line), "yes") << "the gate was met: its title is so";
  line.is_measured = false;
  EXPECT_EQ(measured_text(line), "–");
  line = {};
  line.metric = "angle_deg";
  line.unit = "deg";
  line.value = -3.62;
  line.is_measured = true;
  EXPECT_EQ(measured_text(line), "−3.6°");
}

TEST(Report, AReviewedAndWholeScoreHasNoSuchMarks) {
  ReportMaterial material = made_up();
  material.card.is_reviewed = true;
  material.card.rubric_milli = material.card.measured_milli;
  const std::string html = html_report(material);
  EXPECT_EQ(html.find("not surgeon-reviewed"), std::string::npos);
  EXPECT_EQ(html.find("partial:"), std::string::npos);
}

TEST(Report, LoadsNothingAndRunsNothing) {
  const std::string html = html_report(made_up());
  EXPECT_NE(html.find("Content-Security-Policy"), std::string::npos);
  for (const char* door : {"<script", "src=", "href=", "url(", "@import", "http://", "https://"}) {
    EXPECT_EQ(html.find(door), std::string::npos) << door;
  }
}

TEST(Report, WhatPeopleTypedIsTextOnly) {
  ReportMaterial material = made_up();
  const std::string hostile = "<img src=x onerror='a'>\"&\x01";
  material.title = hostile;
  material.facts = {{hostile, hostile}};
  material.quality = hostile;
  material.group_titles = {hostile, hostile};
  material.card.sentences = {hostile};
  material.what_if.changes = {{hostile, hostile, hostile, {}}};
  material.what_if.together = material.what_if.together_score = hostile;
  material.card.ledger[0].text = hostile;
  material.card.ledger[0].item = hostile;
  material.card.ledger[0].unit = hostile;
  material.card.gates[0].text = hostile;
  material.faces[0].right = material.faces[0].title = hostile;
  material.traces.marks = {{0.5, hostile}};
  const std::string html = html_report(material);
  EXPECT_EQ(html.find("<img"), std::string::npos);
  EXPECT_EQ(html.find('\x01'), std::string::npos);
  const std::string sheet = score_sheet(material);
  EXPECT_EQ(sheet.find('\x01'), std::string::npos);
}

TEST(Report, SaysHowHotTheBoneBecame) {
  ReportMaterial material = made_up();
  EXPECT_NE(html_report(material).find("above 47 °C for 3.3 s, 62 °C at most; none took the dose"),
            std::string::npos);
  material.traces.heat.necrotic_mm3 = 6.0;
  EXPECT_NE(html_report(material).find("6 mm³ took the dose"), std::string::npos);
  material.traces.heat = {};
  EXPECT_NE(html_report(material).find("stayed below 47 °C: 37 °C at most"), std::string::npos);
}

TEST(Report, SaysWhichDangerZonesTheRunningSawTouched) {
  ReportMaterial material = made_up();
  EXPECT_EQ(html_report(material).find("danger zone."), std::string::npos) << "none was watched";
  material.zones = {{"Flexor tendon", 0, 0.0}, {"Digital nerve", 0, 0.0}};
  EXPECT_NE(html_report(material).find("touched no danger zone."), std::string::npos);
  material.zones[1] = {"Digital nerve", 2, 1.26};
  EXPECT_NE(html_report(material).find("touched: Digital nerve (2 contacts, 1.3 s)."),
            std::string::npos);
}

TEST(ZoneContacts, AreCountedAndTimedAndEndWithTheRecording) {
  scenarios::Scenario scenario;
  scenario.danger_zones.resize(2);
  scenario.danger_zones[0].title = "Tendon";
  scenario.danger_zones[1].title = "Nerve";
  simulator::Recording recording;
  recording.samples.resize(1);
  recording.samples.back().tick = 5000;
  const auto note = [&](std::int64_t tick, simulator::CutEventKind kind, std::int32_t zone) {
    recording.events.push_back({tick, kind, zone, 0, {}});
  };
  using enum simulator::CutEventKind;
  note(1000, DangerContact, 1);
  note(1500, DangerLeft, 1);
  note(2000, BoneHot, 0);
  note(3000, DangerContact, 1);
  note(4000, DangerContact, 7);
  const std::vector<ZoneContact> contacts = zone_contacts(scenario, recording);
  ASSERT_EQ(contacts.size(), 2U);
  EXPECT_EQ(contacts[0].count, 0);
  EXPECT_EQ(contacts[1].title, "Nerve");
  EXPECT_EQ(contacts[1].count, 2);
  EXPECT_DOUBLE_EQ(contacts[1].duration_s, 2.5);
  EXPECT_DOUBLE_EQ(contacts[1].first_s, 1.0);
  EXPECT_EQ(watched_zones(scenario, recording).size(), 2U);
  recording.engine = 2;
  EXPECT_TRUE(watched_zones(scenario, recording).empty()) << "that engine watched none";
}

TEST(Report, DrawsForceFeedAdvanceAndHeatOverOneTime) {
  const std::string html = html_report(made_up());
  for (const char* curve : {"trace force", "trace feed", "trace advance", "trace heat"}) {
    EXPECT_EQ(count_of(html, std::string("class=\"") + curve + "\""), 1U) << curve;
  }
}

TEST(Report, EveryTagThatOpensCloses) {
  const std::string html = html_report(made_up());
  for (const std::string tag : {"html",       "body", "main",  "header", "section", "div", "figure",
                                "figcaption", "svg",  "table", "tr",     "td",      "ul",  "ol",
                                "li",         "dl",   "p",     "span",   "footer",  "text"}) {
    const std::size_t opened = count_of(html, "<" + tag + ">") + count_of(html, "<" + tag + " ");
    EXPECT_EQ(opened, count_of(html, "</" + tag + ">")) << tag;
  }
}

TEST(Report, TheSameMaterialGivesTheSamePage) {
  EXPECT_EQ(html_report(made_up()), html_report(made_up()));
}

TEST(Report, AnEmptyCardStillMakesAPage) {
  const std::string html = html_report({});
  EXPECT_NE(html.find("machine score"), std::string::npos);
  EXPECT_EQ(count_of(html, "<svg"), 0U);
  EXPECT_NE(score_sheet(ReportMaterial{}).find("Score 0.0 of 100"), std::string::npos);
}

TEST(Report, ATriggeredGateIsSaidByShapeAndNotByColourAlone) {
  ReportMaterial material = made_up();
  material.card.gates[0].is_triggered = true;
  EXPECT_NE(html_report(material).find("\xE2\x9C\x95"), std::string::npos);
  EXPECT_NE(score_sheet(material).find("x Past the sulcus"), std::string::npos);
}

TEST(Report, TheSheetFitsIntoAHundredColumns) {
  ReportMaterial material = made_up();
  material.card.ledger[0].text =
      std::string(40, 'a') + " " + std::string(40, 'b') + " " + std::string(40, 'c') + " deg";
  const std::string sheet = score_sheet(material);
  std::size_t start = 0;
  while (start < sheet.size()) {
    const std::size_t end = sheet.find('\n', start);
    std::size_t letters = 0;
    for (std::size_t at = start; at < end; ++at) {
      // Bytes that continue a UTF-8 letter take no column.
      letters += (static_cast<unsigned char>(sheet[at]) & 0xC0U) == 0x80U ? 0 : 1;
    }
    EXPECT_LE(letters, 100U) << sheet.substr(start, end - start);
    start = end + 1;
  }
}

TEST(Report, FactsSayWhoseAttemptItWasAndWhetherItIsWhole) {
  database::AttemptHeader header;
  header.begun.hand = "novice";
  header.begun.seed = 7;
  header.state = database::AttemptState::Interrupted;
  ReportMaterial material = made_up();
  add_attempt_facts(material, header);
  const std::string html = html_report(material);
  EXPECT_NE(html.find("robot, novice hand, seed 7"), std::string::npos);
  EXPECT_NE(html.find("interrupted"), std::string::npos);
}

TEST(Report, SaysWhyARecordingMayNotBeGraded) {
  database::AttemptHeader header;
  header.state = database::AttemptState::Closed;
  header.is_valid = false;
  database::RecordingCertificate certificate;
  certificate.expected_samples = 1000;
  certificate.received_samples = 999;
  certificate.clock_steps = 1;
  ReportMaterial material = made_up();
  add_attempt_facts(material, header, verdict_of(certificate));
  EXPECT_NE(html_report(material).find("It is not valid for grading: samples were lost; the "
                                       "machine slept, or its clock jumped."),
            std::string::npos);
  header.is_valid = true;
  add_attempt_facts(material, header);
  EXPECT_EQ(html_report(material).find("not valid"), std::string::npos);
}

TEST(EffectsText, GivesEachNumberItsUnit) {
  simulator::HeatSummary heat;
  EXPECT_FALSE(was_hot(heat));
  heat.hottest_celsius = 47.01;
  heat.hot_s = 0.24;
  heat.necrotic_mm3 = 4.0;
  EXPECT_TRUE(was_hot(heat));
  EXPECT_EQ(hottest_text(heat), "47 °C");
  EXPECT_EQ(hot_time_text(heat), "0.2 s");
  EXPECT_EQ(dead_bone_text(heat), "4 mm³");
  EXPECT_EQ(bend_text(0.254), "0.25 mm");
  EXPECT_EQ(contact_time_text(1.26), "1.3 s");
}

TEST(HtmlText, EscapesWhatHasAMeaning) {
  EXPECT_EQ(escaped("a<b>&\"'"), "a&lt;b&gt;&amp;&quot;&#39;");
}

}  // namespace
}  // namespace hallux::ui
