#include "simulator/device/inverse3/inverse3_driver.h"

#include <gtest/gtest.h>

#include "simulator/device/inverse3/inverse_service.h"
#include "tests/support/served_bus/played_service.h"

namespace hallux::simulator {
namespace {

const OpeningWatch go_on = [](PortPhase, double) { return true; };

class PlayedInverse : public testing::Test {
 protected:
  TroubleReport opened() { return driver_.open(go_on); }
  DriverExchange exchanged(int times, const Vec3& force_newton = {0.0, 0.0, 0.0}) {
    DriverExchange exchange;
    for (int i = 0; i < times; ++i) exchange = driver_.exchange(force_newton);
    return exchange;
  }

  tests::ServiceModel model_;
  Inverse3Driver driver_{access_to(model_), "049D"};
};

TEST_F(PlayedInverse, ItsPlaceIsInTheFrameOfEveryDevice) {
  ASSERT_FALSE(opened());
  // 10 mm to the right, 20 mm away from the person, 30 mm up.
  model_.state()["cursor_position"] = {{"x", 0.01}, {"y", -0.10}, {"z", 0.18}};
  const DriverExchange exchange = exchanged(1);
  EXPECT_EQ(exchange.answer, DriverAnswer::Said);
  EXPECT_TRUE(exchange.state.is_homed);
  EXPECT_LT(length_of(exchange.state.device_from_handle.translation_mm - Vec3(10.0, 30.0, -20.0)),
            1e-9);
  EXPECT_EQ(driver_.description().device_class, "arm3");
  EXPECT_FALSE(driver_.description().measures_rotation);
}

TEST_F(PlayedInverse, ItPushesWhereItIsToldTo) {
  ASSERT_FALSE(opened());
  exchanged(1, {1.0, 2.0, 3.0});
  EXPECT_EQ(model_.force("x"), 1.0);
  EXPECT_EQ(model_.force("y"), -3.0) << "to the person is its backwards";
  EXPECT_EQ(model_.force("z"), 2.0);
}

TEST_F(PlayedInverse, AGripTurnsIt) {
  // A quarter about its upright axis.
  const double half = std::sqrt(0.5);
  model_.grips = {{{"device_id", "1"},
                   {"state",
                    {{"orientation", {{"w", half}, {"x", 0.0}, {"y", 0.0}, {"z", half}}},
                     {"buttons", {{"a", true}, {"b", true}, {"c", false}}}}}}};
  ASSERT_FALSE(opened());
  const DriverState state = exchanged(1).state;
  EXPECT_TRUE(driver_.description().measures_rotation);
  EXPECT_EQ(state.buttons, 0b11U);
  const Vec3 turned = state.device_from_handle.rotation * Vec3(1.0, 0.0, 0.0);
  EXPECT_LT(length_of(turned - Vec3(0.0, 0.0, -1.0)), 1e-12) << "right becomes away";
}

TEST_F(PlayedInverse, AGripThatIsGoneHoldsNoButtonAndTheArmIsAway) {
  const nlohmann::json grip = {{"device_id", "1"},
                               {"state",
                                {{"orientation", {{"w", 1.0}, {"x", 0.0}, {"y", 0.0}, {"z", 0.0}}},
                                 {"buttons", {{"a", true}, {"b", false}, {"c", false}}}}}};
  model_.grips.push_back(grip);
  ASSERT_FALSE(opened());
  EXPECT_EQ(exchanged(1).state.buttons, 1U);
  model_.grips.clear();
  EXPECT_TRUE(exchanged(10).state.is_homed) << "parts may be absent";
  const DriverState lost = exchanged(60).state;
  EXPECT_EQ(lost.buttons, 0U);
  EXPECT_FALSE(lost.is_homed);
  model_.grips.push_back(grip);
  EXPECT_TRUE(exchanged(1).state.is_homed);
}

TEST_F(PlayedInverse, AGripThatComesLaterTurnsNothing) {
  ASSERT_FALSE(opened());
  model_.grips.push_back(
      {{"device_id", "1"},
       {"state", {{"orientation", {{"w", 0.0}, {"x", 1.0}, {"y", 0.0}, {"z", 0.0}}}}}});
  EXPECT_EQ(exchanged(5).state.device_from_handle.rotation, Quat(1.0, 0.0, 0.0, 0.0));
}

TEST_F(PlayedInverse, NoForceIsLeftUnderAWordThatWasNotAnswered) {
  // It understands both, and says nothing of what it gives.
  model_.mutes_force = true;
  ASSERT_FALSE(opened());
  exchanged(30, {0.0, 3.0, 0.0});
  EXPECT_NE(model_.last_of("values"), model_.last_of("vector"));
  driver_.close();
  for (const char* key : {"values", "vector"}) EXPECT_EQ(model_.last_of(key), 0.0) << key;
}

TEST_F(PlayedInverse, TheWordForAForceIsFoundByWhatItGives) {
  for (const char* key : {"vector", "values"}) {
    for (const char* version : {"3.1.0", "3.5.0"}) {
      model_ = {};
      model_.keys = {key};
      model_.version_page = R"({"project_version":")" + std::string(version) + R"("})";
      ASSERT_FALSE(opened());
      exchanged(40, {0.0, 1.0, 0.0});
      EXPECT_EQ(model_.force("z"), 1.0) << key << ' ' << version;
      driver_.close();
      EXPECT_EQ(model_.force("z"), 0.0);
    }
  }
}

TEST_F(PlayedInverse, OneThatUnderstandsNoWordIsGivenUp) {
  model_.keys = {};
  ASSERT_FALSE(opened());
  const DriverExchange exchange = exchanged(50, {0.0, 1.0, 0.0});
  EXPECT_EQ(exchange.answer, DriverAnswer::Gone);
  EXPECT_EQ(exchange.trouble, DeviceTrouble::ServiceVersion);
}

TEST_F(PlayedInverse, OneThatTellsNoForceIsBelieved) {
  model_.tells_force = false;
  ASSERT_FALSE(opened());
  EXPECT_EQ(exchanged(100, {0.0, 1.0, 0.0}).answer, DriverAnswer::Said);
  EXPECT_FALSE(exchanged(1).state.own_force_scale);
}

TEST_F(PlayedInverse, ItsOwnScaleIsMeasured) {
  model_.force_scale = 0.5;
  ASSERT_FALSE(opened());
  EXPECT_FALSE(exchanged(10).state.own_force_scale) << "nobody pushed";
  EXPECT_NEAR(*exchanged(300, {0.0, 2.0, 0.0}).state.own_force_scale, 0.5, 0.01);
}

TEST_F(PlayedInverse, UncalibratedItIsNotHomed) {
  model_.arms[0]["status"]["calibrated"] = false;
  ASSERT_FALSE(opened());
  EXPECT_FALSE(exchanged(1).state.is_homed);
}

TEST_F(PlayedInverse, WhyItCannotBeOpenedIsTold) {
  model_.is_absent = true;
  EXPECT_EQ(opened(), (TroubleReport{DeviceTrouble::NoService, "10001", {}}));
  model_.is_absent = false;
  model_.version_page = R"({"project_version":"3.0.5"})";
  EXPECT_EQ(opened().trouble, DeviceTrouble::ServiceVersion);
  EXPECT_EQ(opened().detail, "3.0");
  model_.version_page = R"({"project_version":"4.0.0"})";
  EXPECT_EQ(opened().trouble, DeviceTrouble::ServiceVersion);
  model_.version_page = std::nullopt;
  model_.arms[0]["config"]["type"] = "minverse";
  EXPECT_EQ(opened(), (TroubleReport{DeviceTrouble::WrongModel, "049D", "minverse"}));
  model_.arms[0] = tests::ServiceModel::arm("1234", "inverse3");
  EXPECT_EQ(opened().trouble, DeviceTrouble::Unplugged);
  EXPECT_EQ(driver_.exchange({}).answer, DriverAnswer::Gone) << "nothing is left open";
}

TEST_F(PlayedInverse, SilenceRubbishAndAGoneServiceAreTold) {
  ASSERT_FALSE(opened());
  model_.is_silent = true;
  EXPECT_EQ(exchanged(1).answer, DriverAnswer::Nothing);
  model_.is_silent = false;
  for (const std::string& rubbish :
       {std::string("{"), std::string(100000, '['), std::string(70000, ' ') + "{}",
        std::string(
            R"({"inverse3":[{"device_id":"049D","state":{"cursor_position":{"x":1e9}}}]})")}) {
    model_.rubbish = rubbish;
    EXPECT_EQ(exchanged(1).answer, DriverAnswer::Garbled) << rubbish.substr(0, 60);
  }
  model_.rubbish.reset();
  EXPECT_EQ(exchanged(1).answer, DriverAnswer::Said);
  model_.is_gone = true;
  EXPECT_EQ(exchanged(1).trouble, DeviceTrouble::ServiceGone);
}

TEST_F(PlayedInverse, OneThatItsServiceDoesNotNameAnyMoreIsUnplugged) {
  ASSERT_FALSE(opened());
  model_.names_arm = false;
  EXPECT_EQ(exchanged(10).answer, DriverAnswer::Nothing);
  EXPECT_EQ(exchanged(60).trouble, DeviceTrouble::Unplugged);
}

TEST_F(PlayedInverse, StatesThatCameLateAreCaughtUpWith) {
  ASSERT_FALSE(opened());
  model_.is_silent = true;
  exchanged(3);
  model_.is_silent = false;
  for (int i = 0; i < 3; ++i) model_.say_all(false);
  model_.state()["cursor_position"]["x"] = 0.05;
  EXPECT_NEAR(exchanged(1).state.device_from_handle.translation_mm.x, 50.0, 1e-9);
  EXPECT_TRUE(model_.to_say.empty());
}

TEST(InverseService, ListsWithoutComingAndGoing) {
  tests::ServiceModel model;
  int opened = 0;
  InverseService service([&](std::uint16_t) {
    InverseAccess access = access_to(model);
    return InverseAccess{[&opened, open = access.open] {
                           ++opened;
                           return open();
                         },
                         access.version_page};
  });
  EXPECT_EQ(service.look(10001).arms.size(), 1U);
  model.arms.push_back(tests::ServiceModel::arm("1234", "inverse3x"));
  EXPECT_EQ(service.look(10001).arms.size(), 2U);
  EXPECT_EQ(opened, 1);
  model.is_gone = true;
  EXPECT_EQ(service.look(10001).trouble.trouble, DeviceTrouble::ServiceGone);
  model.is_gone = false;
  model.is_absent = true;
  EXPECT_EQ(service.look(10001).trouble.trouble, DeviceTrouble::NoService);
  model.is_absent = false;
  EXPECT_EQ(service.look(10001).arms.size(), 2U);
}

}  // namespace
}  // namespace hallux::simulator
