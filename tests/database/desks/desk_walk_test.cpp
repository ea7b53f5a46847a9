/// Walks the policy table: each action x role x relation is tried at a real desk on a real row.
/// What the table allows must be done, all else be refused or not be offered at all.

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <functional>
#include <map>

#include "database/exchange/export_attempt.h"
#include "database/exchange/origins.h"
#include "tests/database/some_course.h"

namespace hallux::database {

namespace {

enum class Outcome { Done, Refused, NotOffered };

/// Who owns the row that is tried: at each desk somebody else, and the trainee of a cohort is a
/// stranger to all but its instructor.
struct Subject {
  std::string login;  ///< "" for the robot
  AttemptId attempt;
  NoteId note;  ///< open, on that attempt
  HelpRequestId help;
  Relation relation = Relation::Other;
};

/// All desks at which one try is made; nothing where that desk is not the one that is tried.
struct TriedDesk {
  Role role;
  AttemptDesk* any = nullptr;
  HouseDesk* house = nullptr;
  TraineeDesk* trainee = nullptr;
  InstructorDesk* instructor = nullptr;
  AdministratorDesk* administrator = nullptr;
  CourseDesk* course = nullptr;
  Session* session = nullptr;
};

/// Processes for reports, which begin before anything is opened.
class ReportProcesses {
 public:
  ReportProcess& next_report() { return processes_.at(used_++); }

 private:
  std::array<ReportProcess, relation_count> processes_;
  std::size_t used_ = 0;
};

class Walk : public ReportProcesses, public SomeCourse {
 public:
  Walk() {
    for (const char* login : {"ada", "bob", "eve", "kim", "root"}) add_rows_of(login);
    robot_ = {"", recorded_by_robot(), {}, {}, Relation::Robot};
    store_score(database(), robot_.attempt, card_worth(1000));
  }

  /// The row with which `role` stands in `relation`; nothing where there is no such row.
  std::optional<Subject> subject(Role role, Relation relation) {
    switch (relation) {
      case Relation::Own:
        if (role == Role::House) return std::nullopt;
        return rows_.at(holder(role));
      case Relation::Cohort:
        return rows_.at("bob");
      case Relation::Robot:
        return robot_;
      case Relation::Other:
        return rows_.at("eve");
    }
    return std::nullopt;
  }

  std::filesystem::path new_directory() {
    return database().directory().parent_path() / ("new-" + std::to_string(++directories_));
  }

  Outcome try_at(Role role, const std::function<Outcome(TriedDesk&)>& work) {
    if (role == Role::House) {
      HouseDesk desk{database()};
      TriedDesk tried{role, &desk, &desk};
      return work(tried);
    }
    Session session = sign_in_as(holder(role));
    TriedDesk tried{role};
    tried.session = &session;
    if (role == Role::Trainee) {
      TraineeDesk desk = *session.trainee();
      tried.any = tried.course = tried.trainee = &desk;
      return work(tried);
    }
    if (role == Role::Instructor) {
      InstructorDesk desk = *session.instructor_of(autumn());
      tried.any = tried.course = tried.instructor = &desk;
      return work(tried);
    }
    AdministratorDesk desk = *session.administrator();
    tried.any = tried.administrator = &desk;
    return work(tried);
  }

 private:
  static std::string holder(Role role) {
    return role == Role::Trainee ? "ada" : role == Role::Instructor ? "kim" : "root";
  }

  /// An attempt with a score, a note and a question of that person.
  void add_rows_of(const std::string& login) {
    Subject rows{login, scored_by(login, 50'000), {}, {}, Relation::Other};
    rows.note = add_note(database(), {rows.attempt, {}, false, "look"}, id_of("lee"));
    add_note(database(), {rows.attempt, {}, true, "for us"}, id_of("lee"));
    rows.help = add_help_request(database(), {rows.attempt, {}, "why?"}, id_of(login));
    rows_[login] = rows;
  }

  int directories_ = 0;
  std::map<std::string, Subject> rows_;
  Subject robot_;
};

template <typename Work>
Outcome refused_or_done(Work&& work) {
  try {
    work();
  } catch (const DatabaseError& error) {
    const bool is_unseen = error.kind() == DatabaseErrorKind::NotFound;
    EXPECT_TRUE(is_unseen || error.kind() == DatabaseErrorKind::Refused) << error.what();
    return Outcome::Refused;
  }
  return Outcome::Done;
}

template <typename Rows, typename IsIt>
Outcome is_listed(const Rows& rows, IsIt&& is_it) {
  for (const auto& row : rows) {
    if (is_it(row)) return Outcome::Done;
  }
  return Outcome::Refused;
}

Outcome begin(Walk& world, TriedDesk& desk, const Subject& subject) {
  NewAttempt attempt =
      subject.login.empty() ? some_attempt(world.database()) : world.attempt_of(subject.login);
  if (desk.house) return refused_or_done([&] { desk.house->begin_attempt(attempt); });
  if (desk.trainee) return refused_or_done([&] { desk.trainee->begin_attempt(attempt); });
  return Outcome::NotOffered;
}

std::vector<DerivedFile> no_derived_files(const ExportMaterial&) { return {}; }

Outcome about_attempt(Walk& world, TriedDesk& desk, Action action, const Subject& subject) {
  const AttemptId id = subject.attempt;
  switch (action) {
    case Action::BeginAttempt:
      return begin(world, desk, subject);
    case Action::ListAttempts:
      return is_listed(desk.any->attempts(),
                       [&](const AttemptHeader& header) { return header.id == id; });
    case Action::ViewAttempt: {
      const Outcome recording = refused_or_done([&] { desk.any->recording(id); });
      EXPECT_EQ(refused_or_done([&] { desk.any->packed_recording(id); }), recording);
      EXPECT_EQ(refused_or_done([&] { desk.any->header(id); }), recording);
      EXPECT_EQ(refused_or_done([&] { desk.any->score(id); }), recording);
      EXPECT_EQ(refused_or_done([&] { desk.any->decisions(id); }), recording);
      return recording;
    }
    case Action::ExportAttempt: {
      const TemporaryDirectory out;
      return refused_or_done(
          [&] { desk.any->export_attempt(id, out.data().parent_path(), no_derived_files); });
    }
    default:
      return refused_or_done([&] { desk.any->store_score(id, card_worth(2000)); });
  }
}

Outcome about_talk(TriedDesk& desk, Action action, const Subject& subject) {
  if (!desk.course) return Outcome::NotOffered;
  if (action == Action::ReplyToNote) {
    if (subject.login.empty()) return Outcome::NotOffered;
    return refused_or_done([&] { desk.course->reply(subject.note, "thanks"); });
  }
  std::vector<Note> notes;
  const Outcome read = refused_or_done([&] { notes = desk.course->notes(subject.attempt); });
  if (action == Action::ReadNotes || read == Outcome::Refused) return read;
  return is_listed(notes, [](const Note& note) { return note.is_private; });
}

Outcome about_trainees_own(TriedDesk& desk, Action action, const Subject& subject) {
  const auto is_asked = [&](const HelpRequest& request) { return request.id == subject.help; };
  if (action == Action::ReadHelp && !subject.login.empty() && desk.course) {
    return is_listed(
        desk.trainee ? desk.trainee->help_requests() : desk.instructor->help_requests(), is_asked);
  }
  if (!desk.trainee) return Outcome::NotOffered;
  if (action == Action::AskForHelp) {
    return refused_or_done([&] { desk.trainee->ask_for_help({subject.attempt, {}, "how?"}); });
  }
  if (action == Action::ListOperations && subject.relation == Relation::Own) {
    return refused_or_done([&] { EXPECT_EQ(desk.trainee->operations().size(), 1U); });
  }
  return Outcome::NotOffered;
}

Outcome about_teaching(Walk& world, TriedDesk& desk, Action action, const Subject& subject) {
  if (!desk.instructor) return Outcome::NotOffered;
  InstructorDesk& instructor = *desk.instructor;
  switch (action) {
    case Action::WriteNote:
      return refused_or_done([&] { instructor.add_note({subject.attempt, {}, false, "look"}); });
    case Action::DecideResult:
      return refused_or_done([&] {
        instructor.decide({subject.attempt, DecisionKind::Confirmed, 0, "seen"});
      });
    case Action::AnswerHelp:
      if (subject.login.empty()) return Outcome::NotOffered;
      return refused_or_done([&] { instructor.answer(subject.help, "so"); });
    default:
      if (subject.login.empty()) return Outcome::NotOffered;
      EXPECT_EQ(instructor.cohort().trainees, 3);
      return is_listed(instructor.trainees(), [&](const TraineeStanding& trainee) {
        return trainee.id == world.id_of(subject.login);
      });
  }
}

Outcome about_person(Walk& world, TriedDesk& desk, Action action, const Subject& subject) {
  if (!desk.administrator || subject.login.empty()) return Outcome::NotOffered;
  AdministratorDesk& administrator = *desk.administrator;
  const std::string& login = subject.login;
  switch (action) {
    case Action::SetPassword:
      return refused_or_done(
          [&] { administrator.set_password(login, secret(good_password), cheap); });
    case Action::IssueCode:
      return refused_or_done([&] { administrator.reset(login, cheap); });
    case Action::DisablePerson:
      return refused_or_done([&] { administrator.set_disabled(login, false); });
    case Action::CorrectName:
      return refused_or_done([&] { administrator.correct_name(login, "Somebody Else"); });
    case Action::ChangeRole:
      return refused_or_done([&] { administrator.set_administrator(login, login == "root"); });
    case Action::ExportPerson:
      return refused_or_done([&] { administrator.export_person(login, world.new_directory()); });
    case Action::ErasePerson:
      return refused_or_done([&] {
        administrator.erase_person({login, "asked for it", true},
                                   desk.session->prove(secret(good_password), cheap));
      });
    default:
      return refused_or_done([&] {
        administrator.enrol(world.autumn(), login, CohortRole::Trainee);
        administrator.remove_from_cohort(world.autumn(), login);
      });
  }
}

Outcome about_directory(Walk& world, TriedDesk& desk, Action action, const Subject& subject) {
  if (!desk.administrator || subject.login != "eve") return Outcome::NotOffered;
  AdministratorDesk& administrator = *desk.administrator;
  return refused_or_done([&] {
    switch (action) {
      case Action::AddPerson:
        administrator.add_person_with_code({"new", "", false}, cheap);
        return;
      case Action::ListPeople:
        EXPECT_GE(administrator.people().size(), 7U);
        return;
      case Action::AddCohort:
        administrator.add_cohort("winter");
        return;
      case Action::ListCohorts:
        EXPECT_EQ(administrator.members(administrator.cohorts().front().id).size(), 4U);
        return;
      case Action::ListScenarios:
        EXPECT_EQ(administrator.scenario_text(administrator.scenarios().front().id).name, "silver");
        return;
      case Action::ImportScenario:
        administrator.import_scenario({"akin", 1, "{}", false});
        return;
      case Action::PublishScenario:
        administrator.publish_scenario(administrator.import_scenario({"tip", 1, "{ }", false}));
        return;
      case Action::RetireScenario:
        administrator.retire_scenario(world.published());
        return;
      case Action::Retain:
        EXPECT_TRUE(administrator.retention_plan().empty());
        EXPECT_FALSE(administrator.retention().practice_days);
        administrator.retain();
        return;
      case Action::RunReport:
        EXPECT_EQ(
            administrator.report("SELECT count(*) FROM attempt", world.next_report()).rows.size(),
            1U);
        return;
      case Action::ReadAudit:
        EXPECT_GT(administrator.audit_page({}).total, 0);
        return;
      case Action::ListOrigins:
        EXPECT_TRUE(administrator.origins().empty());
        return;
      case Action::ImportAttempt: {
        const TemporaryDirectory out;
        const std::filesystem::path folder = out.data().parent_path();
        export_attempt(world.database(), subject.attempt, folder, no_derived_files);
        EXPECT_FALSE(
            administrator.import_attempt(read_exported(folder / subject.attempt.text), {}));
        return;
      }
      case Action::AcceptOrigin:
        note_origin(world.database(), {std::string(32, 'a')});
        administrator.set_accepted({std::string(32, 'a')}, true);
        return;
      case Action::ChangeSettings:
        administrator.set_idle_lock_min(20);
        administrator.set_retention({30, {}, {}, {}});
        return;
      case Action::BackUp:
        EXPECT_TRUE(std::filesystem::exists(administrator.back_up().file));
        EXPECT_EQ(administrator.backups().size(), 1U);
        return;
      default:
        FAIL() << "no try was written for action " << static_cast<int>(action);
    }
  });
}

/// Of notices those told to the subject, and at an administrator's desk those told to all
/// administrators.
Outcome about_notices(Walk& world, TriedDesk& desk, const Subject& subject) {
  if (subject.login.empty()) return Outcome::NotOffered;
  const PersonId told = world.id_of(subject.login);
  if (desk.trainee) {
    tell_person(world.database(), told, NoticeKind::PasswordSet);
    const NoticeId notice = unseen_notices(world.database(), told).front().id;
    return refused_or_done([&] { desk.trainee->acknowledge(notice); });
  }
  if (!desk.administrator) return Outcome::NotOffered;
  if (subject.relation == Relation::Own) {
    tell_person(world.database(), told, NoticeKind::PasswordSet);
    const NoticeId notice = unseen_notices(world.database(), told).front().id;
    return refused_or_done([&] { desk.administrator->acknowledge(notice); });
  }
  tell_administrators(world.database(), NoticeKind::BackupSkipped);
  return refused_or_done(
      [&] { desk.administrator->acknowledge(desk.administrator->notices().front().id); });
}

Outcome about_limits(Walk& world, TriedDesk& desk, const Subject& subject) {
  if (desk.administrator && subject.login == "eve") {
    return refused_or_done([&] {
      desk.administrator->set_limit(world.autumn(), "silver", 3);
      EXPECT_EQ(desk.administrator->limits(world.autumn()).size(), 1U);
      desk.administrator->clear_limit(world.autumn(), "silver");
    });
  }
  if (!desk.instructor || subject.relation != Relation::Cohort) return Outcome::NotOffered;
  return refused_or_done([&] {
    desk.instructor->set_limit("silver", 3);
    EXPECT_EQ(desk.instructor->limits().size(), 1U);
    desk.instructor->clear_limit("silver");
  });
}

Outcome about_comparing(TriedDesk& desk, const Subject& subject) {
  if (desk.trainee && subject.relation == Relation::Own)
    return refused_or_done([&] { desk.trainee->cohort_comparisons("silver"); });
  if (desk.instructor && subject.relation == Relation::Cohort)
    return refused_or_done([&] { desk.instructor->cohort_comparisons("silver"); });
  return Outcome::NotOffered;
}

Outcome tried(Walk& world, TriedDesk& desk, Action action, const Subject& subject) {
  switch (action) {
    case Action::BeginAttempt:
    case Action::ListAttempts:
    case Action::ViewAttempt:
    case Action::StoreScore:
    case Action::ExportAttempt:
      return about_attempt(world, desk, action, subject);
    case Action::ReadNotes:
    case Action::ReadPrivateNotes:
    case Action::ReplyToNote:
      return about_talk(desk, action, subject);
    case Action::ListOperations:
    case Action::AskForHelp:
    case Action::ReadHelp:
      return about_trainees_own(desk, action, subject);
    case Action::WriteNote:
    case Action::AnswerHelp:
    case Action::DecideResult:
    case Action::SeeCohort:
      return about_teaching(world, desk, action, subject);
    case Action::ChangePassword:
      if (!desk.session || subject.relation != Relation::Own) return Outcome::NotOffered;
      return refused_or_done([&] {
        desk.session->change_password(secret(good_password), secret(good_password), cheap);
      });
    case Action::SetPassword:
    case Action::IssueCode:
    case Action::DisablePerson:
    case Action::CorrectName:
    case Action::ChangeRole:
    case Action::ErasePerson:
    case Action::Enrol:
      return about_person(world, desk, action, subject);
    case Action::ExportPerson:
      if (desk.trainee && subject.relation == Relation::Own) {
        return refused_or_done([&] { desk.trainee->export_own(world.new_directory()); });
      }
      return about_person(world, desk, action, subject);
    case Action::ChooseHand:
      if (!desk.trainee || subject.relation != Relation::Own) return Outcome::NotOffered;
      return refused_or_done([&] { desk.trainee->choose_hand({true}); });
    case Action::ReadNotices:
      return about_notices(world, desk, subject);
    case Action::LimitAttempts:
      return about_limits(world, desk, subject);
    case Action::CompareWithCohort:
      return about_comparing(desk, subject);
    default:
      return about_directory(world, desk, action, subject);
  }
}

/// A fresh course for each action: an outcome must not follow from what was tried before.
class EachAction : public testing::TestWithParam<std::size_t> {};

TEST_P(EachAction, IsDoneWhereTheTableAllowsItAndNowhereElse) {
  const auto action = static_cast<Action>(GetParam());
  Walk world;
  for (std::size_t role_index = 0; role_index < role_count; ++role_index) {
    const auto role = static_cast<Role>(role_index);
    for (std::size_t i = 0; i < relation_count; ++i) {
      std::optional<Subject> subject = world.subject(role, static_cast<Relation>(i));
      if (!subject) continue;
      // To all but the instructor's desk a trainee of a cohort is anybody else.
      const bool is_stranger =
          role != Role::Instructor && static_cast<Relation>(i) == Relation::Cohort;
      subject->relation = is_stranger ? Relation::Other : static_cast<Relation>(i);
      const Outcome outcome =
          world.try_at(role, [&](TriedDesk& desk) { return tried(world, desk, action, *subject); });
      const bool is_allowed = allows(role, action, subject->relation);
      const bool is_once = is_stranger && outcome == Outcome::NotOffered;
      EXPECT_EQ(outcome == Outcome::Done, is_allowed && !is_once)
          << "role " << role_index << ", relation " << i << ", outcome "
          << static_cast<int>(outcome);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(OfThePolicy, EachAction, testing::Range(std::size_t{0}, action_count));

}  // namespace

}  // namespace hallux::database
