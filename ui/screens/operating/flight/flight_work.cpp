#include "ui/screens/operating/flight/flight_work.h"

#include <utility>

#include "scenarios/practice_block.h"
#include "simulator/base/progress.h"

namespace hallux::ui {

PreparedOperation prepare_flight(SignedInSession& signed_in, WorkReport& report) {
  const std::filesystem::path directory = signed_in.in_turn(
      [](database::Session&, database::Database& database) { return database.directory(); });
  scenarios::PracticeBlock block = scenarios::make_practice_block();
  PreparedOperation prepared;
  prepared.prepared_case = std::make_shared<const PreparedCase>(
      prepare_case(std::move(block.scenario), std::move(block.bone)));
  const PreparedCase& prepared_case = *prepared.prepared_case;
  cancelled_as("stopped while the picture was being made; nothing was stored", [&] {
    prepared.pictures = pictures_of(prepared.prepared_case, directory,
                                    [&](double fraction) { return report.reached(fraction); });
  });
  SitePicture site;
  site.faces = faces_of(prepared_case);
  prepared.site = std::make_shared<const SitePicture>(std::move(site));
  prepared.passes = passes_of(prepared_case);
  return prepared;
}

}  // namespace hallux::ui
