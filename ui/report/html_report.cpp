// The report as one HTML file that loads nothing: style and pictures lie inside, and its policy
// forbids all else. It is put together from strings in the order in which it is read; titles,
// sentences and facts pass `escaped` on their way in.
#include "ui/report/html_report.h"

#include <span>

#include "assessment/number_text.h"
#include "assessment/shown_points.h"
#include "scenarios/metric_advice.h"
#include "simulator/base/embedded.h"
#include "ui/report/effects_text.h"
#include "ui/report/face_svg.h"
#include "ui/report/frontal_svg.h"
#include "ui/report/html_text.h"
#include "ui/report/report_ledger.h"
#include "ui/report/trace_svg.h"

namespace hallux::ui {

/// Made by the build from report.css.
std::span<const EmbeddedText> report_styles() noexcept;

namespace {

using database::ScoreCard;

std::string style_text() {
  std::string text;
  for (const EmbeddedText& file : report_styles()) text += file.text;
  return text;
}

std::string head_html(const ReportMaterial& material) {
  return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
         "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
         "style-src 'unsafe-inline'\">"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"
         "<meta name=\"color-scheme\" content=\"light dark\"><title>" +
         escaped(material.title) + " \xC2\xB7 Hallux</title><style>" + style_text() +
         "</style></head>";
}

std::string marks_html(const ReportMaterial& material) {
  const ScoreCard& card = material.card;
  std::string html =
      "<p class=\"marks\"><span class=\"mark\">" + escaped(material.signature) + "</span>";
  if (!card.is_reviewed) html += "<span class=\"mark warn\">not surgeon-reviewed</span>";
  const std::string partial = partial_text(card);
  if (!partial.empty()) html += "<span class=\"mark warn\">" + escaped(partial) + "</span>";
  return html + "</p>";
}

std::string facts_html(const std::vector<Fact>& facts, const char* css_class) {
  if (facts.empty()) return "";
  std::string html = "<dl class=\"" + std::string(css_class) + "\">";
  for (const Fact& fact : facts) {
    html += "<div><dt>" + escaped(fact.label) + "</dt><dd>" + escaped(fact.value) + "</dd></div>";
  }
  return html + "</dl>";
}

std::string header_html(const ReportMaterial& material) {
  return "<header><p class=\"brand\">Hallux</p><h1>" + escaped(material.title) + "</h1>" +
         marks_html(material) + facts_html(material.facts, "facts") + "</header>";
}

std::string score_html(const ReportMaterial& material) {
  const double score =
      static_cast<double>(assessment::shown_points(material.card).score_milli) / 1000.0;
  std::string html = "<section class=\"result\"><div class=\"score\"><span class=\"value\">" +
                     assessment::number_text(score, 1) +
                     "</span><span class=\"of\">of 100</span></div>" + groups_html(material) +
                     "</section>";
  if (material.card.sentences.empty()) return html;
  html += "<section><h2>What cost the most</h2><ol class=\"sentences\">";
  for (const std::string& sentence : material.card.sentences) {
    html += "<li>" + escaped(sentence);
    for (const database::LedgerLine& line : material.card.ledger) {
      if (line.text == sentence) html += " " + escaped(scenarios::advice_text(line.metric));
    }
    html += "</li>";
  }
  return html + "</ol></section>";
}

std::string what_if_row(const std::string& head, const std::string& body, const std::string& gain) {
  return "<li><div><strong>" + escaped(head) + "</strong><br>" + escaped(body) +
         "</div><span class=\"gain\">" + escaped(gain) + "</span></li>";
}

std::string what_if_html(const SaidWhatIf& said) {
  if (said.changes.empty() && said.nothing.empty()) return "";
  std::string html = "<section><h2>What would have earned more</h2>";
  if (!said.nothing.empty()) html += "<p>" + escaped(said.nothing) + "</p>";
  if (!said.changes.empty()) html += "<ul class=\"what-if\">";
  for (const SaidChange& change : said.changes)
    html += what_if_row(change.head, change.body, change.gain);
  if (!said.together.empty())
    html += what_if_row(said.together, said.together_score, said.together_gain);
  if (!said.changes.empty()) html += "</ul>";
  return html + "<p class=\"note\">" + escaped(what_if_note()) + "</p></section>";
}

std::string face_caption(const FacePicture& picture) {
  if (picture.dots.empty()) return "The planned face. Nothing was cut here.";
  const std::string colours = "Blue lies too far " + picture.below + ", vermilion too far " +
                              picture.above + "; the dashed outline is the planned section.";
  return picture.is_finished ? "Your face, seen square on. " + colours
                             : "Unfinished: only what the blade opened is shown. " + colours;
}

std::string pictures_html(const ReportMaterial& material) {
  if (material.faces.empty() && !material.frontal) return "";
  std::string html = "<section><h2>Plan against cut</h2><div class=\"pictures\">";
  for (const FacePicture& face : material.faces) {
    html += "<figure>" + face_svg(face) + "<figcaption><strong>" + escaped(face.title) +
            "</strong><br>" + escaped(face_caption(face)) + "</figcaption></figure>";
  }
  if (material.frontal) {
    html += "<figure>" + frontal_svg(*material.frontal) +
            "<figcaption>Section across the bone at the depth landmark, seen along the shaft."
            "</figcaption></figure>";
  }
  return html + "</div></section>";
}

std::string heat_sentence(const simulator::HeatSummary& heat) {
  if (!was_hot(heat)) return "The bone stayed below 47 °C: " + hottest_text(heat) + " at most.";
  const std::string dead = heat.necrotic_mm3 > 0.0 ? dead_bone_text(heat) : "none";
  return "Some bone was above 47 °C for " + hot_time_text(heat) + ", " + hottest_text(heat) +
         " at most; " + dead + " took the dose from which bone dies (16 minutes at 43 °C).";
}

/// Nothing where nothing was watched.
std::string zones_sentence(const std::vector<ZoneContact>& zones) {
  if (zones.empty()) return "";
  std::string touched;
  for (const ZoneContact& zone : zones) {
    if (zone.count == 0) continue;
    touched += (touched.empty() ? "" : "; ") + zone.title + " (" + std::to_string(zone.count) +
               (zone.count == 1 ? " contact, " : " contacts, ") +
               contact_time_text(zone.duration_s) + ")";
  }
  return touched.empty() ? "The running saw touched no danger zone."
                         : "The running saw touched: " + touched + ".";
}

std::string effects_text(const ReportMaterial& material) {
  std::string words = heat_sentence(material.traces.heat) + " The blade bent by up to " +
                      bend_text(material.traces.greatest_deflection_mm) + ". ";
  const std::string zones = zones_sentence(material.zones);
  if (!zones.empty()) words += zones + " ";
  return words + "All of this is by models that no surgeon has reviewed; " +
         (are_effects_scored(material.card) ? "the rubric asks for some of it."
                                            : "nothing is scored by it.");
}

std::string traces_html(const ReportMaterial& material) {
  if (material.traces.points.empty()) return "";
  return "<section><h2>Force, feed and heat</h2><figure class=\"wide\">" +
         trace_svg(material.traces) + "<figcaption>" + escaped(effects_text(material)) +
         "</figcaption></figure></section>";
}

std::string footer_html(const ReportMaterial& material) {
  std::string html = "<footer>";
  if (!material.quality.empty()) {
    html += "<p class=\"quality\">" + escaped(material.quality) + "</p>";
  }
  html += facts_html(material.versions, "versions");
  return html +
         "<p>Location is the greatest one-sided distance of the face from the plan. Angles are "
         "between the two normals. A machine score is advice until an instructor confirms it."
         "</p></footer>";
}

}  // namespace

std::string html_report(const ReportMaterial& material) {
  return head_html(material) + "<body><main>" + header_html(material) + score_html(material) +
         what_if_html(material.what_if) + pictures_html(material) + gates_html(material) +
         ledger_html(material) + traces_html(material) + footer_html(material) +
         "</main></body></html>\n";
}

}  // namespace hallux::ui
