// The way in: three forms over one column, and the bone beside it. Which form comes first is known
// once the directory was opened, beside the window. A secret that was typed is handed on as one
// that wipes itself, and gone from the fields whatever comes of it. After a wrong password the wait
// counts down where the fault is said, for that login only.
#include "ui/screens/sign_in/sign_in_screen.h"

#include <algorithm>
#include <utility>

#include "database/records/code_form.h"
#include "ui/screens/parts/page.h"
#include "ui/screens/parts/value_text.h"
#include "ui/widgets/controls/button.h"
#include "ui/widgets/controls/card.h"
#include "ui/widgets/shapes.h"
#include "ui/widgets/texts/wipe.h"

namespace hallux::ui {

namespace {

// The form of a new password with all its messages; where it does not fit below the head it
// scrolls.
constexpr float longest_form = 600.0F;
constexpr float form_width = 360.0F, side_share = 0.6F, narrow_below = 1000.0F;
constexpr float logo_size = 40.0F, welcome_inset = 48.0F;
constexpr const char* pictured_scenario = "akin";
constexpr double bone_rise = 0.09;  // shares of the picture's width: the words stand below it

/// What the product is, beside the form and below the bone; left out where the window is narrow.
void draw_welcome(Ui& ui, const Rect& side) {
  Canvas& canvas = ui.canvas();
  const Theme& theme = ui.theme();
  canvas.hairline_down(side.right() - 1.0F, side.y, side.h, theme.line);
  const float left = side.x + welcome_inset, width = side.w - 2.0F * welcome_inset;
  draw_logo(canvas, theme, {left + logo_size / 2.0F, side.y + 60.0F}, logo_size / 2.0F);
  canvas.text({left + logo_size + 14.0F, side.y + 60.0F}, {Type::Section, theme.text},
              ui.text("product.name"));
  Rect rest{left, side.y, width, side.h - 40.0F};
  const auto add_above = [&](const TextStyle& style, std::string_view words, float gap) {
    const Rect place = take_bottom(rest, ui.paragraph_height(style.type, words, width), gap);
    canvas.paragraph(place, style, words);
  };
  add_above({Type::Small, theme.text_secondary}, ui.text("entry.not_reviewed"), 20.0F);
  add_above({Type::Body, theme.text_secondary}, ui.text("entry.sentence"), 10.0F);
  add_above({Type::Title, theme.text}, ui.text("entry.headline"), 0.0F);
}

}  // namespace

SignInScreen::SignInScreen(std::filesystem::path data_directory, Entered entered,
                           database::PasswordCost cost, PatientPictures* pictures)
    : data_directory_(std::move(data_directory)),
      entered_(std::move(entered)),
      cost_(cost),
      pictures_(pictures) {
  if (pictures_ != nullptr) pictured_ = scenarios::load_shipped_scenario(pictured_scenario);
}

SignInScreen::~SignInScreen() { forget_secrets(); }

// The ground is there from the first frame on, so that nothing but the bone appears.
void SignInScreen::draw_bone(Ui& ui, const Rect& side, Shell& shell) {
  ui.canvas().fill(side, ui.theme().side);
  if (pictures_ == nullptr) return;
  const PatientView* view = pictures_->find(shell, pictured_);
  Scene scene;
  Camera camera;
  if (view != nullptr) {
    const auto shape = static_cast<double>(side.w / side.h);
    scene = scene_of(*view, PatientPicture::Pair, {});
    camera = panned(camera_of(*view, PatientPicture::Pair, shape), {}, Vec2(0.0, bone_rise));
  }
  scene.ground = ground_of(ui.theme());
  scene.light_place = Vec2(0.5, 0.5 + bone_rise);
  const std::string name = std::string(view != nullptr ? "entry.bone." : "entry.ground.") +
                           std::string(ground_word(ui.theme()));
  ui.canvas().picture(still_picture(ui, shell, name, side, scene, camera), side);
}

// A code that was written as the password is not written again.
void SignInScreen::show(Form form) {
  form_ = form;
  is_login_known_ = !login_.empty();
  fault_.clear();
  if (!is_code_told_ || form != Form::Code) return forget_secrets();
  code_.swap(password_);
  is_code_told_ = false;
}

void SignInScreen::forget_secrets() {
  for (std::string* secret : {&code_, &password_, &password_again_}) wipe(*secret);
  is_code_told_ = false;
}

void SignInScreen::open(Ui& ui, Shell& shell) {
  opening_since_s_ = ui.time_s();
  shell.background().start(
      std::string(ui.text("entry.opening")),
      [this](WorkReport&) { is_without_people_ = is_without_people(data_directory_); },
      [this](WorkEnd end, const std::string& reason) {
        show(end != WorkEnd::Done ? Form::Unusable
             : is_without_people_ ? Form::FirstAdministrator
                                  : Form::SignIn);
        fault_ = sentence_of(reason);
      });
}

void SignInScreen::draw(Ui& ui, const Rect& content, Shell& shell) {
  Rect rest = content;
  if (content.w >= narrow_below) {
    const Rect side = take_left(rest, content.w * side_share);
    draw_bone(ui, side, shell);
    draw_welcome(ui, side);
  }
  const float width = std::min(form_width, rest.w - 2.0F * space::page);
  const float above = std::max(48.0F, rest.h * 0.2F);
  const bool is_scrolled = above + longest_form > rest.h;
  const float offset = is_scrolled ? ui.begin_scroll("entry.page", ui.text("entry.sign_in"), rest,
                                                     above + longest_form)
                                   : 0.0F;
  const Rect column{rest.mid_x() - width / 2.0F, rest.y + above - offset, width,
                    std::max(rest.h * 0.8F, longest_form)};
  if (form_ == Form::Opening || form_ == Form::Unusable) {
    draw_opening(ui, column, shell);
  } else {
    draw_form(ui, column, shell);
  }
  if (is_scrolled) ui.end_scroll();
}

void SignInScreen::draw_opening(Ui& ui, const Rect& column, Shell& shell) {
  if (form_ == Form::Opening) {
    if (opening_since_s_ < 0.0) open(ui, shell);
    loading_rows(ui, column, 4, opening_since_s_);
    return;
  }
  const FailedCard failed{ui.text("entry.unusable"), fault_, ui.text("entry.try_again")};
  if (!failed_card(ui, "entry.unusable", column, failed)) return;
  show(Form::Opening);
  opening_since_s_ = -1.0;
}

void SignInScreen::draw_form(Ui& ui, Rect column, Shell& shell) {
  if (form_ == Form::SignIn) draw_sign_in(ui, column, shell);
  if (form_ == Form::Code) draw_code(ui, column, shell);
  if (form_ == Form::FirstAdministrator) draw_first_administrator(ui, column, shell);
}

void SignInScreen::draw_head(Ui& ui, Rect& column, std::string_view title,
                             std::string_view sentence) const {
  const Theme& theme = ui.theme();
  ui.canvas().text_in(take_top(column, 40.0F, 4.0F), {Type::Title, theme.text}, title);
  text_line(ui, column, Type::Body, theme.text_secondary, sentence, 24.0F);
}

bool SignInScreen::draw_field(Ui& ui, Rect& column, std::string_view id, std::string& text,
                              FieldSpec spec) const {
  if (is_busy_) spec.why_off = ui.text("button.busy");
  return labelled_field(ui, id, column, text, spec,
                        entry_field_gap + (spec.hint.empty() ? 0.0F : field_message_height));
}

void SignInScreen::draw_fault(Ui& ui, Rect& column) {
  if (login_ != waiting_login_ && wait_.left_s(ui) > 0) {
    wait_ = {};
    fault_.clear();
  }
  wait_.draw_fault(ui, column, fault_);
}

bool SignInScreen::draw_button(Ui& ui, Rect& column, std::string_view id, std::string_view label,
                               std::string_view missing) {
  take_top(column, 6.0F);
  ButtonSpec spec{label, ButtonLook::Primary};
  spec.why_off = wait_.left_s(ui) > 0 ? ui.text("entry.missing.wait") : missing;
  spec.is_busy = is_busy_;
  return button(ui, id, take_top(column, large_button_height, 20.0F), spec);
}

std::string_view SignInScreen::missing(const Ui& ui) const {
  if (login_.empty()) return ui.text("entry.missing.login");
  if (form_ == Form::FirstAdministrator && !database::is_login(login_))
    return ui.text("entry.login.fault");
  if (form_ == Form::Code && code_.empty()) return ui.text("entry.missing.code");
  return password_.empty() ? ui.text("entry.missing.password") : std::string_view();
}

void SignInScreen::draw_sign_in(Ui& ui, Rect& column, Shell& shell) {
  draw_head(ui, column, ui.text("entry.sign_in"), ui.text("entry.sign_in.sentence"));
  draw_field(ui, column, "entry.login", login_, {.label = ui.text("entry.login")});
  if (draw_field(ui, column, "entry.password", password_,
                 {.label = ui.text("entry.password"), .is_secret = true}) &&
      std::exchange(is_code_told_, false))
    fault_.clear();
  ui.focus_first(is_login_known_ ? "entry.password" : "entry.login");
  draw_fault(ui, column);
  if (draw_button(ui, column, "entry.sign_in", ui.text("entry.sign_in"), missing(ui))) {
    sign_in_or_tell_of_code(ui, shell);
  }
  if (link(ui, "entry.to_code", {column.x, column.y + 10.0F}, ui.text("entry.to_code")) &&
      !is_busy_) {
    show(Form::Code);
  }
  const std::string_view shared = ui.text("entry.shared");
  const Rect foot{column.x, column.y + 48.0F, column.w,
                  ui.paragraph_height(Type::Small, shared, column.w)};
  ui.canvas().paragraph(foot, {Type::Small, ui.theme().text_caption}, shared);
}

// A code that is sent as a password would be refused, counted and told as a refused sign-in. A
// password that only looks like one is sent at the second press.
void SignInScreen::sign_in_or_tell_of_code(Ui& ui, Shell& shell) {
  if (is_code_told_ || !database::looks_like_code(password_)) return come_in(ui, shell, sign_in);
  is_code_told_ = true;
  fault_ = ui.text("entry.password_is_code");
  ui.want_frame_in_s(0.0);
}

void SignInScreen::draw_code(Ui& ui, Rect& column, Shell& shell) {
  draw_head(ui, column, ui.text("entry.code.title"), ui.text("entry.code.sentence"));
  draw_field(ui, column, "entry.login", login_, {.label = ui.text("entry.login")});
  draw_field(ui, column, "entry.code", code_, {.label = ui.text("entry.code"), .is_secret = true});
  draw_field(ui, column, "entry.password", password_,
             {.label = ui.text("entry.new_password"),
              .hint = ui.text("entry.password.rule"),
              .is_secret = true});
  draw_field(ui, column, "entry.password_again", password_again_,
             {.label = ui.text("entry.password_again"), .is_secret = true});
  ui.focus_first(is_login_known_ ? "entry.code" : "entry.login");
  draw_fault(ui, column);
  if (draw_button(ui, column, "entry.redeem", ui.text("entry.redeem"), missing(ui))) {
    come_in_with_new_password(ui, shell, redeem);
  }
  if (link(ui, "entry.to_sign_in", {column.x, column.y + 10.0F}, ui.text("entry.to_sign_in")) &&
      !is_busy_) {
    show(Form::SignIn);
  }
}

void SignInScreen::draw_first_administrator(Ui& ui, Rect& column, Shell& shell) {
  draw_head(ui, column, ui.text("entry.first.title"), ui.text("entry.first.sentence"));
  FieldSpec login{.label = ui.text("entry.login"), .hint = ui.text("entry.login.rule")};
  if (!database::may_become_login(login_)) login.error = ui.text("entry.login.fault");
  if (draw_field(ui, column, "entry.login", login_, login)) ui.want_frame_in_s(0.0);
  draw_field(ui, column, "entry.name", name_, {.label = ui.text("entry.name")});
  draw_field(ui, column, "entry.password", password_,
             {.label = ui.text("entry.password"),
              .hint = ui.text("entry.password.rule"),
              .is_secret = true});
  draw_field(ui, column, "entry.password_again", password_again_,
             {.label = ui.text("entry.password_again"), .is_secret = true});
  ui.focus_first("entry.login");
  draw_fault(ui, column);
  if (draw_button(ui, column, "entry.begin", ui.text("entry.begin"), missing(ui))) {
    come_in_with_new_password(ui, shell, begin_course);
  }
}

void SignInScreen::come_in_with_new_password(Ui& ui, Shell& shell, Work work) {
  if (password_ == password_again_) return come_in(ui, shell, work);
  fault_ = ui.text("entry.passwords_differ");
}

namespace {

/// What is typed stays where it is: what is refused is mended, not written anew.
database::SecretText secret_of(const std::string& typed) {
  std::string copy;
  copy.reserve(typed.size());
  copy = typed;
  return database::SecretText::take(copy);
}

}  // namespace

/// The words are kept by the screen until the work ends, and a screen stays until its work ended.
/// Of a new password nothing is wiped before somebody came in with it; a wrong one is.
void SignInScreen::come_in(Ui& ui, Shell& shell, Work work) {
  words_.login = login_;
  words_.display_name = name_;
  words_.code = secret_of(code_);
  words_.password = secret_of(password_);
  if (form_ == Form::SignIn) forget_secrets();
  fault_.clear();
  is_busy_ = true;
  shell.background().start(
      std::string(ui.text("entry.signing_in")),
      [this, work](WorkReport&) {
        told_.noting([&] { signed_in_ = work(data_directory_, words_, cost_); });
      },
      [this, &shell](WorkEnd end, const std::string& reason) {
        is_busy_ = false;
        waiting_login_ = std::exchange(words_, {}).login;
        wait_ = std::exchange(told_, {});
        if (end == WorkEnd::Done) {
          forget_secrets();
          return entered_(shell, std::move(signed_in_));
        }
        signed_in_.reset();
        fault_ = sentence_of(reason);
      });
}

}  // namespace hallux::ui
