/// What one may not see is as if it were not there: the same kind, the same words, the same rows
/// written. Only the audit tells them apart.

#include <gtest/gtest.h>

#include "database/audit/audit.h"
#include "tests/database/some_course.h"

namespace hallux::database {

namespace {

struct Answer {
  DatabaseErrorKind kind = DatabaseErrorKind::InputOutput;
  std::string words;
  std::size_t rows_written = 0;
  friend bool operator==(const Answer&, const Answer&) = default;
};

class Unseen : public testing::Test, protected SomeCourse {
 protected:
  /// What `work` was answered, with the name it asked for taken out.
  template <typename Work>
  Answer answer_to(Work&& work, const std::string& named) {
    Answer answer;
    const std::size_t before = read_audit(database()).size();
    try {
      work();
      ADD_FAILURE() << "was not refused";
    } catch (const DatabaseError& error) {
      answer.kind = error.kind();
      answer.words = error.what();
    }
    for (auto place = answer.words.find(named); place != std::string::npos;
         place = answer.words.find(named)) {
      answer.words.replace(place, named.size(), "?");
    }
    answer.rows_written = read_audit(database()).size() - before;
    return answer;
  }

  AttemptId absent_{"00000000-0000-4000-8000-000000000000"};
};

TEST_F(Unseen, AttemptsAreAsIfThereWereNone) {
  const AttemptId of_eve = scored_by("eve", 50'000);
  TraineeDesk trainee_desk = trainee("ada");
  InstructorDesk instructor_desk = instructor("kim", autumn());
  AdministratorDesk administrator_desk = administrator();
  HouseDesk house{database()};
  for (AttemptDesk* desk : std::initializer_list<AttemptDesk*>{&trainee_desk, &instructor_desk,
                                                               &administrator_desk, &house}) {
    const auto alike = [&](auto&& ask) {
      const Answer foreign = answer_to([&] { ask(of_eve); }, of_eve.text);
      EXPECT_EQ(last_audit().text.find("not there"), std::string::npos);
      EXPECT_EQ(foreign, answer_to([&] { ask(absent_); }, absent_.text));
      EXPECT_NE(last_audit().text.find("not there"), std::string::npos);
      EXPECT_EQ(foreign.kind, DatabaseErrorKind::NotFound);
      EXPECT_EQ(foreign.rows_written, 1U);
    };
    alike([&](const AttemptId& id) { desk->header(id); });
    alike([&](const AttemptId& id) { desk->recording(id); });
    alike([&](const AttemptId& id) { desk->packed_recording(id); });
    alike([&](const AttemptId& id) { desk->display_facts(id); });
    alike([&](const AttemptId& id) { desk->score(id); });
    alike([&](const AttemptId& id) { desk->decisions(id); });
    alike([&](const AttemptId& id) { desk->store_score(id, card_worth(1)); });
  }
  Session ada = sign_in_as("ada");
  const auto through_session = [&](const AttemptId& id) {
    return answer_to([&] { ada.desk_for(Action::ViewAttempt, id)->header(id); }, id.text);
  };
  EXPECT_EQ(through_session(of_eve), through_session(absent_));
}

TEST_F(Unseen, BeginningsOfNamesAreThoseOfWhatOneMaySee) {
  const AttemptId of_ada = recorded_by("ada"), of_eve = recorded_by("eve");
  const AttemptId beginning{of_ada.text.substr(0, 8)};
  tamper(database(), "UPDATE attempt SET uuid = '" + beginning.text +
                         "' || substr(uuid, 9) WHERE uuid = '" + of_eve.text + "'");
  // Both begin alike; to her hers is the only one.
  EXPECT_EQ(headers_that_begin_with(database(), beginning).size(), 2U);
  EXPECT_EQ(trainee("ada").header(beginning).id, of_ada);
  EXPECT_EQ(sign_in_as("ada").desk_for(Action::ViewAttempt, beginning)->header(beginning).id,
            of_ada);
}

TEST_F(Unseen, NotesAndQuestionsAreAsIfThereWereNone) {
  const AttemptId of_eve = recorded_by("eve"), of_ada = recorded_by("ada");
  InstructorDesk lee = instructor("lee", spring());
  const NoteId foreign = lee.add_note({of_eve, {}, false, "look"});
  const NoteId hidden = instructor("kim", autumn()).add_note({of_ada, {}, true, "for us"});
  TraineeDesk ada = trainee("ada");
  const auto reply = [&](NoteId note) {
    return answer_to([&] { ada.reply(note, "what?"); }, "note " + std::to_string(note.number));
  };
  EXPECT_EQ(reply(foreign), reply({99}));
  EXPECT_EQ(reply(hidden), reply({99}));
  const HelpRequestId asked = trainee("eve").ask_for_help({of_eve, {}, "why?"});
  InstructorDesk kim = instructor("kim", autumn());
  const auto answer = [&](HelpRequestId request) {
    return answer_to([&] { kim.answer(request, "so"); },
                     "request " + std::to_string(request.number));
  };
  EXPECT_EQ(answer(asked), answer({99}));
  EXPECT_EQ(answer(asked).rows_written, 1U);
}

TEST_F(Unseen, PeopleAreAsIfThereWereNone) {
  InstructorDesk kim = instructor("kim", autumn());
  const auto list = [&](PersonId person) {
    return answer_to([&] { kim.attempts_of(person); }, "person " + std::to_string(person.number));
  };
  EXPECT_EQ(list(id_of("eve")), list({99}));
}

TEST_F(Unseen, WhatWasSeenOfOthersStandsInTheAuditOnceAMinute) {
  const AttemptId of_ada = scored_by("ada", 50'000);
  database().pretend_it_is("2026-03-10T08:00:00.000Z");
  InstructorDesk kim = instructor("kim", autumn());
  const auto views = [&] {
    std::size_t count = 0;
    for (const AuditRow& row : read_audit(database())) {
      count += row.entry.action == "attempt_viewed" ? 1U : 0U;
    }
    return count;
  };
  kim.score(of_ada);
  EXPECT_EQ(last_audit().actor, id_of("kim"));
  EXPECT_EQ(last_audit().subject_id, of_ada.text);
  kim.recording(of_ada);
  EXPECT_EQ(views(), 1U);
  database().pretend_it_is("2026-03-10T08:01:30.000Z");
  kim.recording(of_ada);
  EXPECT_EQ(views(), 2U);
  trainee("ada").recording(of_ada);
  EXPECT_EQ(views(), 2U);
}

}  // namespace

}  // namespace hallux::database
