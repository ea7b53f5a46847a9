/// Feeds any bytes to the reader of hands: it must throw ScenarioError or give a motion.
#include "scenarios/hands/hand_file.h"
#include "scenarios/scenario_error.h"
#include "tests/fuzz/text_fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace hallux;
  try {
    scenarios::parse_hand_motion(
        tests::text_of(bytes, size), "fuzz",
        {{"wide", simulator::Saw{}}, {"wire 1.4", simulator::WireDriver{}}});
  } catch (const scenarios::ScenarioError&) {
  }
  return 0;
}
