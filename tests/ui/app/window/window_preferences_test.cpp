#include "ui/app/window/window_preferences.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <thread>

#include "tests/database/some_database.h"
#include "tests/ui/widgets/driver.h"
#include "ui/jobs/files/output_error.h"
#include "ui/jobs/files/read_small_file.h"

namespace hallux::ui {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::ThrowsMessage;

class WindowPreferences : public testing::Test {
 protected:
  WindowPreferences() {
    fs::create_directory(directory());
    std::ofstream(directory() / "hallux.db") << "a course";
  }

  fs::path directory() const { return temporary_.data(); }
  fs::path file() const { return directory() / "window.json"; }
  void write(const std::string& words) const { std::ofstream(file()) << words; }
  std::string words() const {
    std::ifstream stream(file());
    return {std::istreambuf_iterator<char>(stream), {}};
  }

 private:
  database::TemporaryDirectory temporary_;
};

Preferences unusual() {
  Preferences preferences{ThemeName::Light, 1.3F, true, true, false};
  preferences.offered_flight = {3, 17};
  preferences.captures_pointer = false;
  return preferences;
}

TEST_F(WindowPreferences, AreTheUsualOnesWhereNothingIsKept) {
  EXPECT_EQ(read_preferences(directory()), Preferences{});
  EXPECT_EQ(read_preferences(directory() / "missing"), Preferences{});
}

TEST_F(WindowPreferences, ComeBackAsTheyWere) {
  keep_preferences(directory(), unusual());
  EXPECT_EQ(read_preferences(directory()), unusual());
  keep_preferences(directory(), Preferences{});
  EXPECT_EQ(read_preferences(directory()), Preferences{});
}

TEST_F(WindowPreferences, WhoWasOfferedTheFlightIsKnownByNumberWhateverElseStandsThere) {
  write(R"({"offered_flight": [17, "a", 3, 17, 2.5, null]})");
  EXPECT_EQ(read_preferences(directory()).offered_flight, (std::vector<std::int64_t>{3, 17}));
  write(R"({"offered_flight": "3"})");
  EXPECT_TRUE(read_preferences(directory()).offered_flight.empty());
}

TEST_F(WindowPreferences, MakeNothingWhereNoCourseIs) {
  fs::remove(directory() / "hallux.db");
  keep_preferences(directory(), unusual());
  EXPECT_TRUE(fs::is_empty(directory()));
  keep_preferences(directory() / "missing", unusual());
  EXPECT_FALSE(fs::exists(directory() / "missing"));
}

TEST_F(WindowPreferences, AFileThatIsNoneIsNamed) {
  for (const char* damaged : {"", "[1, 2", "[]", "7"}) {
    write(damaged);
    EXPECT_THAT([&] { read_preferences(directory()); },
                ThrowsMessage<FileRefused>(HasSubstr(file().string())))
        << damaged;
  }
}

TEST_F(WindowPreferences, AValueThatIsNotOursIsTheUsualOne) {
  write(R"({"theme": 7, "scale": "large", "full_screen": "yes", "saw_sound": false})");
  Preferences expected;
  expected.is_saw_heard = false;
  EXPECT_EQ(read_preferences(directory()), expected);
  write(R"({"scale": 1e9})");
  EXPECT_EQ(read_preferences(directory()).scale, largest_scale);
  write(R"({"scale": -3})");
  EXPECT_EQ(read_preferences(directory()).scale, smallest_scale);
}

/// A window without a screen in it.
class KeptByTheWindow : public WindowPreferences {
 protected:
  bool settle(const std::function<bool()>& holds) {
    for (int frame = 0; frame < 500 && !holds(); ++frame) {
      driver_.wait(0.01);
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return holds();
  }

  const Texts texts_ = english_texts();
  Shell shell_;
  Driver driver_{texts_, [this](Ui& ui) { shell_.draw(ui); }};
};

TEST_F(KeptByTheWindow, EachChoiceIsKeptAndTheNextWindowBeginsWithIt) {
  {
    const PreferenceKeeper keeper(texts_, directory(), shell_);
    driver_.frame();
    EXPECT_FALSE(fs::exists(file())) << "nothing was chosen yet";
    driver_.press(Key::Plus, {.control = true});
    driver_.press(Key::Plus, {.control = true});
    driver_.press(Key::F11);
    ASSERT_TRUE(settle([&] {
      return fs::exists(file()) && read_preferences(directory()) == shell_.preferences();
    }));
  }
  Shell next;
  const PreferenceKeeper keeper(texts_, directory(), next);
  EXPECT_FLOAT_EQ(next.preferences().scale, 1.2F);
  EXPECT_TRUE(next.preferences().is_full_screen);
}

TEST_F(KeptByTheWindow, ADamagedFileIsSaidAndStaysUntilSomethingIsChosen) {
  write("damaged");
  const PreferenceKeeper keeper(texts_, directory(), shell_);
  driver_.frame();
  EXPECT_TRUE(driver_.sees("The window begins with the usual settings"));
  EXPECT_TRUE(driver_.sees("window.json"));
  EXPECT_EQ(words(), "damaged");
  driver_.press(Key::F11);
  EXPECT_TRUE(settle([&] { return words() != "damaged"; }));
  EXPECT_TRUE(read_preferences(directory()).is_full_screen);
}

TEST_F(KeptByTheWindow, AChoiceThatCannotBeKeptIsSaid) {
  const PreferenceKeeper keeper(texts_, directory(), shell_);
  driver_.frame();
  fs::create_directory(file());
  driver_.press(Key::F11);
  EXPECT_TRUE(settle([&] { return driver_.sees("What was chosen here is not kept"); }));
}

}  // namespace
}  // namespace hallux::ui
