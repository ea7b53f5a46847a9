#include "database/exchange/score_table.h"

#include "database/exchange/manifest.h"
#include "database/text/csv_text.h"

namespace hallux::database {

namespace {

constexpr const char* header =
    "kind,item,metric,group,unit,value,is_measured,target,weight_milli,points_lost_milli,"
    "start_us,end_us,x_in_bone_mm,y_in_bone_mm,z_in_bone_mm,text\r\n";

std::string line_of(const LedgerLine& line) {
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
  return text + "," + csv_cell(line.text) + "\r\n";
}

}  // namespace

ExchangeFile write_score_table(const std::filesystem::path& folder, const ScoreCard& card) {
  ExchangeWriter writer(folder, score_table_name);
  writer.write(header);
  for (const LedgerLine& line : card.ledger) writer.write(line_of(line));
  return writer.finish();
}

}  // namespace hallux::database
