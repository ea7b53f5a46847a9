// A random walker in every role, or in one, through the whole course: course_walk STEPS COURSE
// [SEED [ROLE]]. COURSE is the folder of a simulated one, with the answer of `hallux demo` beside
// its data.
//
// A step presses something that can be pressed, writes into a field, uses keys, drags, turns the
// wheel, changes the window. After each, the frame is read: no other trainee's name on a trainee's
// screen, no text without its value. Now and then it must find home from where it is. What it did
// last is printed where something is wrong.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <set>
#include <stdexcept>
#include <thread>

#include "tests/database/some_database.h"
#include "tests/ui/app/window/course_window.h"
#include "ui/window/shell/help.h"

namespace {

using namespace hallux;
using namespace hallux::ui;

constexpr int steps_between_ways_home = 60, escapes_at_most = 12;
constexpr std::size_t remembered_steps = 25;

/// What a walker may do and must not see.
struct Walk {
  std::string login, password, role;
  std::vector<std::string> forbidden;  ///< words that name somebody else
};

class Fault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

bool is_letter(char letter) { return std::isalnum(static_cast<unsigned char>(letter)) != 0; }

/// Whether `word` stands in `text` by itself: trainee-1 does not stand in trainee-12.
bool names(const std::string& text, const std::string& word) {
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) {
    const bool begins = at == 0 || !is_letter(text[at - 1]);
    const std::size_t end = at + word.size();
    if (begins && (end == text.size() || !is_letter(text[end]))) return true;
  }
  return false;
}

class Walker {
 public:
  Walker(const std::filesystem::path& data, Walk walk, std::uint64_t seed)
      : walk_(std::move(walk)),
        random_(seed),
        window_(data, database::cheap, [](Shell& shell, Ui& ui) { shell.draw(ui); }) {}

  /// errors  Fault
  void go(int steps) {
    come_in();
    take_off();
    for (int step = 0; step < steps; ++step) {
      open_lock();
      come_in();
      act();
      if (one_in(3)) window_.finish_work();
      if (one_in(4)) say_something();
      read_frame();
      if (step % steps_between_ways_home != steps_between_ways_home - 1) continue;
      open_lock();
      find_home();
    }
    if (!window_.finish_work()) throw Fault("work did not end within a minute");
    constexpr int steps_in_which_it_is_met = 100;
    if (steps >= steps_in_which_it_is_met && !seen_.contains("guide"))
      throw Fault("the guide was never met");
  }

  std::string last_steps() const {
    std::string all;
    for (const std::string& each : done_) all += "  " + each + "\n";
    return all;
  }
  std::size_t screens_seen() const noexcept { return seen_.size(); }

 private:
  Driver& driver() { return window_.driver(); }
  int below(int bound) { return std::uniform_int_distribution<int>(0, bound - 1)(random_); }
  bool one_in(int count) { return below(count) == 0; }

  void note(std::string what) {
    done_.push_back(std::move(what));
    if (done_.size() > remembered_steps) done_.pop_front();
  }

  // Whoever signed out, or chose the other form, comes in again as the same person.
  void come_in() {
    if (driver().has("entry.to_sign_in")) driver().press(Key::Escape);
    if (driver().has("entry.to_sign_in")) driver().click("entry.to_sign_in");
    if (!driver().has("entry.sign_in")) return;
    window_.finish_work();
    // The list of keys may lie over the form.
    for (int count = 0; count < 3 && reachable_layer(driver().content()) > Layer::Page; ++count)
      driver().press(Key::Escape);
    if (!driver().has("entry.sign_in")) return;
    note("sign in as " + walk_.login);
    window_.sign_in(walk_.login, walk_.password);
    if (!driver().has("entry.sign_in")) return;
    wait_for_the_guard();
    window_.sign_in(walk_.login, walk_.password);
    if (driver().has("entry.sign_in")) throw Fault("cannot sign in again");
  }

  // By chance few come to the first flight; each walk begins in it.
  void take_off() {
    note("first flight");
    driver().click("nav.operations");
    window_.finish_work();
    driver().click(driver().has("flight.offer.fly") ? "flight.offer.fly" : "operations.fly");
    const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
    while (!driver().has("flight.skip")) {
      if (std::chrono::steady_clock::now() > end) throw Fault("the first flight does not begin");
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      driver().frame();
    }
  }

  // Whoever locked the window opens it again.
  void open_lock() {
    if (!driver().has("lock.open")) return;
    note("open the lock");
    for (int count = 0; count < 2 && window_.shell().is_locked(); ++count) {
      if (count > 0) wait_for_the_guard();
      driver().click("lock.password");
      driver().press(Key::A, {.control = true});
      driver().type(walk_.password);
      driver().press(Key::Enter);
      window_.finish_work();
    }
    if (window_.shell().is_locked()) throw Fault("the lock does not open");
  }

  // Somebody who writes anything into the form for a new password has given wrong ones: the longest
  // wait there is.
  void wait_for_the_guard() {
    constexpr int longest_wait_s = 61;
    std::this_thread::sleep_for(std::chrono::seconds(longest_wait_s));
    driver().frame(longest_wait_s);
    driver().settle();
  }

  void act() {
    switch (below(12)) {
      case 0:
        return press_keys();
      case 1:
        return write();
      case 2:
        return move_pointer();
      case 3:
        return one_in(4) ? change_window() : press_something();
      case 4:
        return one_in(3) ? open_guide() : press_something();
      default:
        return press_something();
    }
  }

  std::vector<const Widget*> reachable(bool fields) {
    std::vector<const Widget*> found;
    const FrameContent& content = driver().content();
    for (const Widget& widget : content.widgets) {
      const bool is_field = widget.role == Role::Field;
      if (!widget.is_enabled || widget.visible.is_empty() || is_field != fields) continue;
      if (widget.role == Role::Scroll || widget_at(content, widget.visible.centre()) != &widget)
        continue;
      found.push_back(&widget);
    }
    return found;
  }

  bool can_press(std::string_view id) {
    const auto found = reachable(false);
    return std::any_of(found.begin(), found.end(),
                       [&](const Widget* widget) { return widget->id == id; });
  }

  void press(const Widget& widget) {
    const Point middle = widget.visible.centre();
    const float scale = driver().ui().scale();
    driver().send(click_events({middle.x * scale, middle.y * scale}));
    driver().settle();
  }

  void press_something() {
    const auto found = reachable(false);
    if (found.empty()) return press_keys();
    const Widget widget = *found[static_cast<std::size_t>(below(static_cast<int>(found.size())))];
    note("press " + widget.id);
    seen_.insert(widget.id.substr(0, widget.id.find('.')));
    press(widget);
  }

  void write() {
    static const std::array<const char*, 9> words{
        "",           "a",
        "somebody-3", "Łódź, 12 mm",
        "../../etc",  "{moment}",
        "0",          "A longer remark about the second cut, which went astray",
        "\t"};
    const auto found = reachable(true);
    if (found.empty()) return press_something();
    const Widget widget = *found[static_cast<std::size_t>(below(static_cast<int>(found.size())))];
    const char* word = words[static_cast<std::size_t>(below(words.size()))];
    note("write '" + std::string(word) + "' into " + widget.id);
    press(widget);
    driver().type(word);
  }

  // From wherever one is, unless a question lies there.
  void open_guide() {
    note("guide");
    for (int count = 0; count < 2; ++count) driver().press(Key::F1);
    window_.finish_work();
    if (window_.shell().is_guide_shown()) seen_.insert("guide");
  }

  /// Half of them of those that the screen has bound, as F1 lists them; the others mean something
  /// to controls and fields, or nothing.
  Chord some_chord() {
    static const std::array keys{
        Key::Tab,   Key::Tab,    Key::Tab,  Key::Enter, Key::Escape,    Key::Space,
        Key::Left,  Key::Right,  Key::Up,   Key::Down,  Key::Home,      Key::End,
        Key::F1,    Key::F9,     Key::G,    Key::N,     Key::P,         Key::Period,
        Key::F,     Key::C,      Key::S,    Key::B,     Key::Backspace, Key::Delete,
        Key::Comma, Key::Digit0, Key::Plus, Key::Minus, Key::PageUp,    Key::PageDown};
    const std::vector<Shortcut>& bound = driver().ui().shortcuts();
    if (!bound.empty() && one_in(2))
      return bound[static_cast<std::size_t>(below(static_cast<int>(bound.size())))].chord;
    return {keys[static_cast<std::size_t>(below(static_cast<int>(keys.size())))],
            {one_in(5), one_in(12), false}};
  }

  void press_keys() {
    for (int count = 1 + below(4); count > 0; --count) {
      const Chord chord = some_chord();
      note("key " + chord_text(texts_, chord));
      driver().press(chord.key, chord.modifiers);
    }
  }

  void move_pointer() {
    const Rect display = driver().ui().display();
    const auto anywhere = [&] {
      return Point{display.w * static_cast<float>(below(1000)) / 1000.0F,
                   display.h * static_cast<float>(below(1000)) / 1000.0F};
    };
    note("pointer");
    if (one_in(2)) return driver().wheel(anywhere(), one_in(2) ? 1.0F : -3.0F);
    const auto button = static_cast<MouseButton>(below(mouse_button_count));
    driver().drag(anywhere(), anywhere(), button);
  }

  void change_window() {
    static const std::array<std::array<float, 2>, 5> sizes{
        {{1280, 720}, {1440, 900}, {1920, 1080}, {3840, 2160}, {640, 400}}};
    Preferences& preferences = window_.shell().preferences();
    note("window");
    switch (below(3)) {
      case 0: {
        const auto& size = sizes[static_cast<std::size_t>(below(sizes.size()))];
        return driver().resize(size[0], size[1]);
      }
      case 1:
        preferences.theme = one_in(2) ? ThemeName::Dark : ThemeName::Light;
        break;
      default:
        preferences.scale = one_in(2) ? 1.0F : 0.8F + 0.2F * static_cast<float>(below(7));
    }
    driver().frame();
    driver().settle();
  }

  // Of each kind and length, as something may happen on every screen.
  void say_something() {
    static const std::array<const char*, 3> details{
        "", "What was recorded is kept.",
        "The backup was written to /srv/courses/autumn/backups/hallux-20260303-140210"};
    window_.shell().say({one_in(2) ? Meaning::Good : Meaning::Warn, "Something was said",
                         details[static_cast<std::size_t>(below(details.size()))],
                         one_in(3) ? "Seen" : ""});
    for (int frame = 0; frame < 2; ++frame) driver().frame();
    driver().settle();
  }

  // A window in which a message finds no room anywhere is no place to work in.
  void look_under_messages() {
    const Rect display = driver().ui().display();
    if (display.w < 1000.0F || display.h < 600.0F) return;
    for (const std::string& covered : driver().covered_by_messages()) throw Fault(covered);
  }

  void read_frame() {
    look_under_messages();
    for (const std::string& id : driver().off_without_reason())
      throw Fault("off without a reason: " + id);
    for (const std::string& text : driver().texts()) {
      if (text == "[missing text]") throw Fault("a text is missing");
      for (const std::string& word : walk_.forbidden)
        if (names(text, word)) fail_for(word, text);
    }
  }

  [[noreturn]] void fail_for(const std::string& word, const std::string& text) const {
    throw Fault("'" + word + "' is seen by " + walk_.login + ": " + text);
  }

  bool is_home() {
    for (const Widget& widget : driver().content().widgets)
      if (widget.id.starts_with("nav.") && widget.is_enabled &&
          widget.layer == reachable_layer(driver().content()))
        return true;
    return driver().has("entry.sign_in") || driver().has("entry.to_sign_in");
  }

  /// Its picture is there, and nothing that begins or ends an operation.
  bool is_being_saved() {
    return driver().has("operate.view") && !driver().has("operate.abandon") &&
           !driver().has("operate.begin");
  }

  /// A key may have hidden what an operation is abandoned with.
  void bring_panels_back() {
    constexpr int questions_at_most = 3;
    for (int count = 0; count < questions_at_most && is_being_saved(); ++count) {
      driver().press(Key::Escape);
      if (!driver().has("operate.go_on")) continue;
      if (!driver().has("operate.abandon")) driver().press(Key::H);
      return;
    }
  }

  /// Saving an attempt takes real time.
  void wait_for_the_record() {
    const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
    while (is_being_saved()) {
      if (std::chrono::steady_clock::now() > end) throw Fault("an attempt is not saved");
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      driver().frame();
      window_.finish_work();
    }
  }

  // Esc leads back from everywhere, but for an operation: that is abandoned, and a flight left.
  void find_home() {
    note("home");
    for (int count = 0; count < escapes_at_most && !is_home(); ++count) {
      bring_panels_back();
      wait_for_the_record();
      // Where the saw has the pointer, the pause by Esc frees it.
      const bool is_free = driver().ui().captured_by().empty();
      if (is_free && can_press("operate.ask_abandon.act")) {
        driver().click("operate.ask_abandon.act");
      } else if (is_free && can_press("operate.abandon")) {
        driver().click("operate.abandon");
      } else {
        driver().press(Key::Escape);
      }
      window_.finish_work();
    }
    if (!is_home()) throw Fault("no way home from" + ids_of(reachable(false)));
  }

  static std::string ids_of(const std::vector<const Widget*>& widgets) {
    std::string ids;
    for (const Widget* widget : widgets) ids += " " + widget->id;
    return ids;
  }

  Walk walk_;
  std::mt19937_64 random_;
  const Texts texts_ = english_texts();
  CourseWindow window_;
  std::deque<std::string> done_;
  std::set<std::string> seen_;
};

std::vector<Walk> walks_of(const nlohmann::json& course) {
  std::vector<std::string> trainees;
  for (const nlohmann::json& account : course.at("accounts"))
    if (account.at("role") == "trainee") trainees.push_back(account.at("login"));
  std::vector<Walk> walks;
  std::set<std::string> roles;
  for (const nlohmann::json& account : course.at("accounts")) {
    if (!roles.insert(account.at("role")).second) continue;
    Walk walk{account.at("login"), course.at("password"), account.at("role"), {}};
    if (walk.role == "trainee") {
      walk.forbidden = trainees;
      std::erase(walk.forbidden, walk.login);
    }
    walks.push_back(std::move(walk));
  }
  return walks;
}

// True where the walk ended without a fault.
bool walk_as(const std::filesystem::path& data, const Walk& walk, int steps, std::uint64_t seed) {
  Walker walker(data, walk, seed);
  try {
    walker.go(steps);
    std::printf("%s: %d steps, %zu parts of the product\n", walk.login.c_str(), steps,
                walker.screens_seen());
    return true;
  } catch (const std::exception& fault) {
    std::printf("%s, seed %llu: %s\nlast steps:\n%s", walk.login.c_str(),
                static_cast<unsigned long long>(seed), fault.what(), walker.last_steps().c_str());
    return false;
  }
}

}  // namespace

int main(int count, char** arguments) {
  testing::InitGoogleTest(&count, arguments);
  if (count < 3) {
    std::fprintf(stderr, "usage: course_walk STEPS COURSE [SEED [ROLE]]\n");
    return 2;
  }
  const int steps = std::atoi(arguments[1]);
  const std::filesystem::path course = arguments[2];
  const std::uint64_t seed = count > 3 ? std::strtoull(arguments[3], nullptr, 10) : 1;
  const std::string only = count > 4 ? arguments[4] : "";
  std::ifstream answer{course / "answer.json"};
  bool is_well = true;
  std::size_t walked = 0;
  for (const Walk& walk : walks_of(nlohmann::json::parse(answer))) {
    if (!only.empty() && walk.role != only) continue;
    ++walked;
    // Each in a course of its own: an administrator who walks about makes trainees instructors.
    const database::TemporaryDirectory own;
    std::filesystem::copy(course / "data", own.data(), std::filesystem::copy_options::recursive);
    is_well = walk_as(own.data(), walk, steps, seed) && is_well;
  }
  if (walked == 0) std::fprintf(stderr, "nobody has the role %s\n", only.c_str());
  return is_well && walked > 0 && !testing::Test::HasFailure() ? 0 : 1;
}
