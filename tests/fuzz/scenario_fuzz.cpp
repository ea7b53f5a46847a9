/// Feeds any bytes to the reader of scenarios: it must throw ScenarioError or give a scenario.
#include "scenarios/scenario.h"
#include "tests/fuzz/text_fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace hallux;
  try {
    scenarios::parse_scenario(tests::text_of(bytes, size), "fuzz");
  } catch (const scenarios::ScenarioError&) {
  }
  return 0;
}
