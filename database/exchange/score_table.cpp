#include "database/exchange/score_table.h"

#include "database/course/detail_json.h"
#include "database/exchange/manifest.h"
#include "database/text/csv_text.h"

namespace hallux::database {

namespace {

constexpr const char* number_columns =
    "kind,item,metric,group,unit,value,is_measured,target,weight_milli,points_lost_milli,"
    "start_us,end_us,x_in_bone_mm,y_in_bone_mm,z_in_bone_mm";
/// Of a card that brought its words.
constexpr const char* word_columns = ",text";
/// What words are made from.
constexpr const char* fact_columns =
    ",title,subject,target_kind,target_low,target_high,absence,done_fraction,direction,detail_json,"
    "remark";

std::string facts_of(const LineFacts& facts) {
  return "," + csv_cell(facts.title) + "," + csv_cell(facts.subject) + "," +
         csv_cell(name_of(facts.target)) + "," + csv_number(facts.target_low) + "," +
         csv_number(facts.target_high) + "," + csv_cell(name_of(facts.absence)) + "," +
         csv_number(facts.done_fraction) + "," + csv_cell(facts.direction) + "," +
         csv_cell(json_from_detail(facts.detail)) + "," + csv_cell(name_of(facts.remark));
}

std::string line_of(const LedgerLine& line, CardForm form) {
  std::string text{name_of(line.kind)};
  for (const std::string& word : {line.item, line.metric, line.group, line.unit}) {
    text += "," + csv_cell(word);
  }
  text +=
      "," + csv_number(line.value) + (line.is_measured ? ",1," : ",0,") + csv_number(line.target);
  for (const std::int64_t number :
       {line.weight_milli, line.points_lost_milli, line.start_us, line.end_us}) {
    text += "," + std::to_string(number);
  }
  for (const double part : line.place_in_bone_mm) text += "," + csv_number(part);
  text += form == CardForm::Words ? "," + csv_cell(line.text) : facts_of(line.facts);
  return text + "\r\n";
}

}  // namespace

ExchangeFile write_score_table(const std::filesystem::path& folder, const ScoreCard& card) {
  ExchangeWriter writer(folder, score_table_name);
  writer.write(std::string(number_columns) +
               (card.form == CardForm::Words ? word_columns : fact_columns) + "\r\n");
  for (const LedgerLine& line : card.ledger) writer.write(line_of(line, card.form));
  return writer.finish();
}

}  // namespace hallux::database
