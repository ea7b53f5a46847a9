/// What trainees, instructors and administrators do together, rule by rule.

#include <gtest/gtest.h>

#include <cmath>

#include "database/audit/audit.h"
#include "database/course/begin_attempt.h"
#include "database/store/sql.h"
#include "tests/database/some_course.h"

namespace hallux::database {

namespace {

class Course : public testing::Test, protected SomeCourse {
 protected:
  /// Closed, whole and valid by its certificate, without a score.
  AttemptId valid_assessment_of(const std::string& login) {
    NewAttempt attempt = attempt_of(login);
    attempt.kind = AttemptKind::Assessment;
    simulator::AttemptChannels channels{4096};
    Recorder recorder{database(), create_attempt(database(), attempt), channels};
    produce(some_recording(5), channels);
    recorder.finish("{\"complete\": true}");
    return recorder.attempt();
  }
};

TEST_F(Course, ShowsATraineeThePublishedOperationsAndHowTheyStand) {
  scored_by("ada", 61'000);
  scored_by("ada", 48'000);
  scored_by("bob", 99'000);
  AdministratorDesk desk = administrator();
  desk.import_scenario({"akin", 1, "{\"name\": \"akin\"}", false});
  const auto operations = trainee("ada").operations();
  ASSERT_EQ(operations.size(), 1U) << "a draft is shown to nobody";
  EXPECT_EQ(operations[0].name, "silver");
  EXPECT_EQ(operations[0].standing.attempts, 2);
  EXPECT_EQ(operations[0].standing.best_milli, 61'000);
  EXPECT_EQ(operations[0].standing.last_milli, 48'000);
  EXPECT_EQ(trainee("eve").operations()[0].standing.attempts, 0);
}

TEST_F(Course, LetsATraineeOperateOnlyWhatIsPublished) {
  NewAttempt attempt = attempt_of("ada");
  attempt.kind = AttemptKind::Assessment;
  const AttemptId id = record(database(), attempt, some_recording(5));
  EXPECT_EQ(trainee("ada").header(id).begun.kind, AttemptKind::Assessment);
  administrator().retire_scenario(published());
  EXPECT_EQ(kind_thrown([&] { trainee("ada").begin_attempt(attempt); }),
            DatabaseErrorKind::BadInput);
}

TEST_F(Course, KeepsAPersonsAttemptsFromScriptedHands) {
  NewAttempt attempt = attempt_of("ada");
  attempt.hand = "expert";
  EXPECT_EQ(kind_thrown([&] { trainee("ada").begin_attempt(attempt); }),
            DatabaseErrorKind::BadInput);
}

TEST_F(Course, ShowsAnInstructorHowTheCohortStands) {
  scored_by("ada", 61'000);
  const AttemptId last = scored_by("ada", 70'000);
  const AttemptId of_robot = recorded_by_robot();
  trainee("ada").ask_for_help({last, {}, "was this too deep?"});
  const auto trainees = instructor("kim", autumn()).trainees(1);
  ASSERT_EQ(trainees.size(), 3U);
  EXPECT_EQ(trainees[0].login, "ada");
  ASSERT_EQ(trainees[0].last_attempts.size(), 1U);
  EXPECT_EQ(trainees[0].last_attempts[0].id, last);
  EXPECT_EQ(trainees[0].open_help_requests, 1);
  ASSERT_EQ(trainees[0].operations.size(), 1U);
  EXPECT_EQ(trainees[0].operations[0].attempts, 2);
  EXPECT_TRUE(trainees[1].operations.empty());
  for (const TraineeStanding& trainee : trainees) {
    for (const AttemptHeader& attempt : trainee.last_attempts) EXPECT_NE(attempt.id, of_robot);
  }
}

TEST_F(Course, KeepsTheRobotOutOfEveryCohort) {
  const AttemptId robot = recorded_by_robot();
  store_score(database(), robot, card_worth(90'000));
  InstructorDesk desk = instructor("kim", autumn());
  for (const TraineeStanding& trainee : desk.trainees()) EXPECT_TRUE(trainee.operations.empty());
  EXPECT_EQ(kind_thrown([&] {
              desk.decide({robot, DecisionKind::Confirmed, 0, "fine"});
            }),
            DatabaseErrorKind::Refused);
  EXPECT_EQ(kind_thrown([&] {
              desk.add_note({robot, {}, false, "look"});
            }),
            DatabaseErrorKind::Refused);
}

TEST_F(Course, LetsOnePersonTeachOneCohortAndLearnInAnother) {
  const AttemptId of_eve = recorded_by("eve");
  const AttemptId of_ada = recorded_by("ada");
  const AttemptId of_lee = recorded_by("lee");
  Session lee = sign_in_as("lee");
  EXPECT_FALSE(lee.instructor_of(autumn()));
  InstructorDesk teaching = *lee.instructor_of(spring());
  EXPECT_NO_THROW(teaching.recording(of_eve));
  EXPECT_EQ(kind_thrown([&] { teaching.recording(of_ada); }), DatabaseErrorKind::NotFound);
  EXPECT_EQ(kind_thrown([&] {
              teaching.decide({of_lee, DecisionKind::Voided, 0, "mine"});
            }),
            DatabaseErrorKind::NotFound)
      << "nobody decides about their own";
  EXPECT_NO_THROW(instructor("kim", autumn()).recording(of_lee));
}

TEST_F(Course, ListsForAnInstructorTheirOwnAndTheirCohortsAttemptsOnce) {
  const AttemptId of_ada = recorded_by("ada");
  const AttemptId of_eve = recorded_by("eve");
  const AttemptId of_lee = recorded_by("lee");
  const AttemptId robot = recorded_by_robot();
  const auto listed_for = [&](const char* login) {
    std::vector<AttemptId> ids;
    for (const AttemptHeader& header : sign_in_as(login).attempts()) ids.push_back(header.id);
    return ids;
  };
  EXPECT_EQ(listed_for("lee"), (std::vector<AttemptId>{robot, of_lee, of_eve}));
  EXPECT_EQ(listed_for("kim"), (std::vector<AttemptId>{robot, of_lee, of_ada}));
  EXPECT_EQ(listed_for("ada"), (std::vector<AttemptId>{robot, of_ada}));
  EXPECT_EQ(listed_for("root"), (std::vector<AttemptId>{robot}));
}

TEST_F(Course, EndsAnInstructorsViewWhenTheTraineeLeavesTheCohort) {
  const AttemptId id = recorded_by("ada");
  InstructorDesk desk = instructor("kim", autumn());
  EXPECT_NO_THROW(desk.header(id));
  administrator().remove_from_cohort(autumn(), "ada");
  EXPECT_EQ(kind_thrown([&] { desk.header(id); }), DatabaseErrorKind::NotFound);
  EXPECT_EQ(trainee("ada").attempts().size(), 1U) << "the attempt stays theirs";
}

TEST_F(Course, NeverShowsATraineeAPrivateNote) {
  const AttemptId id = recorded_by("ada");
  InstructorDesk desk = instructor("kim", autumn());
  const NoteId open = desk.add_note({id, {{2000}}, false, "hold it level"});
  const NoteId hidden = desk.add_note({id, {{1000}}, true, "watch this one"});
  const auto seen = trainee("ada").notes(id);
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_EQ(seen[0].id, open);
  EXPECT_EQ(kind_thrown([&] { trainee("ada").reply(hidden, "which one?"); }),
            DatabaseErrorKind::NotFound);
  const auto all = desk.notes(id);
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].id, hidden) << "by moment";
  EXPECT_EQ(kind_thrown([&] { desk.reply(hidden, "this"); }), DatabaseErrorKind::BadInput);
  EXPECT_EQ(kind_thrown([&] { trainee("bob").notes(id); }), DatabaseErrorKind::NotFound);
  EXPECT_EQ(kind_thrown([&] { trainee("bob").reply(open, "me too"); }),
            DatabaseErrorKind::NotFound);
}

TEST_F(Course, LetsTraineeAndInstructorTalkBelowANote) {
  const AttemptId id = recorded_by("ada");
  const AttemptMoment moment{3000, BonePoint{1, {12.5, -3.25, 0.125}}};
  const NoteId note = instructor("kim", autumn()).add_note({id, moment, false, "too steep"});
  trainee("ada").reply(note, "by how much?");
  instructor("kim", autumn()).reply(note, "five degrees");
  const Note read = trainee("ada").notes(id).at(0);
  EXPECT_EQ(read.author_name, "kim");
  EXPECT_EQ(read.moment.moment_us, 3000);
  EXPECT_EQ(read.moment.place, moment.place);
  ASSERT_EQ(read.replies.size(), 2U);
  EXPECT_EQ(read.replies[0].author_name, "ada");
  EXPECT_EQ(read.replies[1].text, "five degrees");
}

TEST_F(Course, RefusesNotesThatCannotBePinned) {
  const AttemptId id = recorded_by("ada");
  InstructorDesk desk = instructor("kim", autumn());
  const auto kind_of = [&](const AttemptMoment& moment, const std::string& text) {
    return kind_thrown([&] { desk.add_note({id, moment, false, text}); });
  };
  EXPECT_NO_THROW(desk.add_note({id, {5000}, false, "at the very end"}));
  EXPECT_EQ(kind_of({5001}, "after the end"), DatabaseErrorKind::BadInput);
  EXPECT_EQ(kind_of({-1}, "before"), DatabaseErrorKind::BadInput);
  EXPECT_EQ(kind_of({0, BonePoint{0, {0.0, std::nan(""), 0.0}}}, "nowhere"),
            DatabaseErrorKind::BadInput);
  EXPECT_EQ(kind_of({0, BonePoint{-1, {}}}, "on no body"), DatabaseErrorKind::BadInput);
  EXPECT_EQ(kind_of({}, "  \n"), DatabaseErrorKind::BadInput);
  EXPECT_EQ(kind_of({}, std::string(4001, 'a')), DatabaseErrorKind::BadInput);
  EXPECT_EQ(kind_of({}, "\xC3("), DatabaseErrorKind::BadInput);
  EXPECT_EQ(kind_of({}, std::string("a\0b", 3)), DatabaseErrorKind::BadInput);
  EXPECT_EQ(desk.notes(id).size(), 1U);
}

TEST_F(Course, BringsAQuestionToTheInstructorAndTheAnswerBack) {
  const AttemptId id = recorded_by("ada");
  const HelpRequestId first = trainee("ada").ask_for_help({id, {2000}, "too deep here?"});
  trainee("ada").ask_for_help({id, {3000}, "and here?"});
  InstructorDesk desk = instructor("kim", autumn());
  ASSERT_EQ(desk.help_requests(true).size(), 2U);
  EXPECT_EQ(desk.help_requests(true)[0].id, first) << "who waits longest comes first";
  desk.answer(first, "by a millimetre");
  EXPECT_EQ(desk.help_requests(true).size(), 1U);
  const auto own = trainee("ada").help_requests();
  EXPECT_EQ(own[0].attempt_number, 1) << "of her attempts at this operation";
  ASSERT_EQ(own.size(), 2U);
  EXPECT_FALSE(own[0].answer);
  EXPECT_EQ(own[1].answer->text, "by a millimetre");
  EXPECT_EQ(own[1].answer->by_name, "kim");
  EXPECT_EQ(kind_thrown([&] { desk.answer(first, "again"); }), DatabaseErrorKind::BadInput);
  EXPECT_TRUE(trainee("bob").help_requests().empty());
  EXPECT_TRUE(instructor("lee", spring()).help_requests().empty());
  EXPECT_EQ(kind_thrown([&] { instructor("lee", spring()).answer(first, "no"); }),
            DatabaseErrorKind::NotFound);
}

TEST_F(Course, ConfirmsAndOverridesAndKeepsTheMachinesScore) {
  const AttemptId id = scored_by("ada", 61'000);
  InstructorDesk desk = instructor("kim", autumn());
  desk.decide({id, DecisionKind::Confirmed, 0, "seen and agreed"});
  EXPECT_EQ(desk.header(id).decision, DecisionKind::Confirmed);
  EXPECT_EQ(desk.header(id).decided_milli, 61'000);
  desk.decide({id, DecisionKind::Overridden, 72'500, "the slip was the station's"});
  EXPECT_EQ(last_audit().text, "the slip was the station's");
  const AttemptHeader header = trainee("ada").header(id);
  EXPECT_EQ(header.decision, DecisionKind::Overridden);
  EXPECT_EQ(header.decided_milli, 72'500);
  EXPECT_EQ(header.score_milli, 61'000);
  EXPECT_TRUE(header.decision_is_of_score_in_force);
  const auto decisions = trainee("ada").decisions(id);
  ASSERT_EQ(decisions.size(), 2U);
  EXPECT_TRUE(decisions[0].is_in_force);
  EXPECT_EQ(decisions[0].reason, "the slip was the station's");
  EXPECT_EQ(decisions[0].decided_by, "kim");
  EXPECT_FALSE(decisions[1].is_in_force);
  EXPECT_EQ(trainee("ada").operations()[0].standing.best_milli, 72'500);
  store_score(database(), id, card_worth(64'000));
  EXPECT_FALSE(desk.header(id).decision_is_of_score_in_force) << "the machine scored anew since";
  EXPECT_EQ(desk.header(id).decided_milli, 72'500);
}

TEST_F(Course, ASignatureBelongsToTheScoreThatItWasAbout) {
  const AttemptId id = valid_assessment_of("ada");
  InstructorDesk desk = instructor("kim", autumn());
  const auto confirmed_milli = [&] {
    return single<std::optional<std::int64_t>>(database(), "SELECT confirmed_milli FROM standing");
  };
  ScoreCard partial = card_worth(61'000);
  partial.measured_milli = 58'000;
  partial.rubric_version = 1;
  store_score(database(), id, partial);
  desk.decide({id, DecisionKind::Confirmed, 0, "as far as it goes"});
  ScoreCard whole = card_worth(90'000);
  whole.measured_milli = 100'000;
  whole.rubric_version = 2;
  store_score(database(), id, whole);
  AttemptHeader header = desk.header(id);
  EXPECT_FALSE(is_grade(header)) << "what was confirmed was partial, and is another score";
  EXPECT_EQ(header.score_milli, 90'000);
  EXPECT_EQ(header.decided_milli, 61'000);
  EXPECT_EQ(header.rubric_version, 1) << "with the points stand what they were made with";
  EXPECT_EQ(header.pass.measured_milli, 58'000);
  EXPECT_TRUE(header.is_partial);
  EXPECT_EQ(trainee("ada").operations()[0].standing.best_milli, 61'000);
  EXPECT_FALSE(confirmed_milli());
  desk.decide({id, DecisionKind::Confirmed, 0, "seen anew"});
  header = desk.header(id);
  EXPECT_TRUE(is_grade(header));
  EXPECT_EQ(header.rubric_version, 2);
  EXPECT_EQ(confirmed_milli(), 90'000);
  whole.ledger.emplace_back().text = "words";
  whole.ledger.back().weight_milli = 1;
  store_score(database(), id, whole);
  EXPECT_FALSE(is_grade(desk.header(id))) << "no override and no confirmation outlives its score";
}

TEST_F(Course, WordsAreNoScore) {
  const AttemptId id = scored_by("ada", 61'000);
  InstructorDesk desk = instructor("kim", autumn());
  desk.decide({id, DecisionKind::Confirmed, 0, "seen"});
  const auto said_otherwise = [&] {
    ScoreCard card = load_score(database(), id)->card;
    for (LedgerLine& line : card.ledger) line.text += " Said otherwise.";
    for (GateResult& gate : card.gates) gate.text += " Said otherwise.";
    card.sentences.emplace_back("Said otherwise.");
    return card;
  };
  const std::size_t before = kept_scores(database(), id).size();
  store_score(database(), id, said_otherwise());
  EXPECT_EQ(kept_scores(database(), id).size(), before);
  EXPECT_TRUE(desk.header(id).decision_is_of_score_in_force);
  store_score_as_it_was(database(), id, said_otherwise(), std::nullopt);
  EXPECT_EQ(kept_scores(database(), id).size(), before + 1) << "of another directory all is kept";
}

TEST_F(Course, VoidsAnAttemptAndTakesItBack) {
  const AttemptId id = scored_by("ada", 61'000);
  InstructorDesk desk = instructor("kim", autumn());
  desk.decide({id, DecisionKind::Voided, 0, "the power went"});
  EXPECT_EQ(desk.header(id).state, AttemptState::Void);
  EXPECT_FALSE(desk.header(id).decided_milli);
  const OperationStanding standing = trainee("ada").operations()[0].standing;
  EXPECT_EQ(standing.attempts, 1);
  EXPECT_FALSE(standing.best_milli);
  EXPECT_NO_THROW(desk.recording(id)) << "it can still be seen";
  desk.decide({id, DecisionKind::Confirmed, 0, "it was whole after all"});
  EXPECT_EQ(desk.header(id).state, AttemptState::Closed);
  EXPECT_EQ(trainee("ada").operations()[0].standing.best_milli, 61'000);
}

TEST_F(Course, DecidesOnlyAboutWhatHasAResult) {
  const AttemptId unscored = recorded_by("ada");
  const AttemptId scored = scored_by("ada", 61'000);
  const AttemptId interrupted = interrupted_of("ada");
  const WriterLease running = create_attempt(database(), attempt_of("ada"));
  InstructorDesk desk = instructor("kim", autumn());
  const auto kind_of = [&](const AttemptId& id, DecisionKind kind, std::int64_t score_milli,
                           const char* reason) {
    return kind_thrown([&] { desk.decide({id, kind, score_milli, reason}); });
  };
  constexpr auto bad = DatabaseErrorKind::BadInput;
  EXPECT_EQ(kind_of(scored, DecisionKind::Confirmed, 0, ""), bad);
  EXPECT_EQ(kind_of(scored, DecisionKind::Overridden, 100'001, "more than all"), bad);
  EXPECT_EQ(kind_of(scored, DecisionKind::Overridden, -1, "less than none"), bad);
  EXPECT_EQ(kind_of(unscored, DecisionKind::Confirmed, 0, "what?"), bad);
  EXPECT_EQ(kind_of(interrupted, DecisionKind::Overridden, 5000, "half"), bad);
  EXPECT_EQ(kind_of(running.attempt(), DecisionKind::Voided, 0, "stop"), bad);
  EXPECT_NO_THROW(desk.decide({interrupted, DecisionKind::Voided, 0, "it stopped half-way"}));
  EXPECT_EQ(desk.header(interrupted).state, AttemptState::Void);
  EXPECT_TRUE(desk.decisions(scored).empty());
}

TEST_F(Course, CallsAGradeOnlyWhatAnInstructorStoodFor) {
  const AttemptId id = valid_assessment_of("ada");
  InstructorDesk desk = instructor("kim", autumn());
  ScoreCard card = card_worth(61'000);
  card.measured_milli = 99'000;
  store_score(database(), id, card);
  EXPECT_FALSE(is_grade(desk.header(id))) << "advisory until somebody decided";
  desk.decide({id, DecisionKind::Confirmed, 0, "seen"});
  EXPECT_FALSE(is_grade(desk.header(id))) << "partial";
  desk.decide({id, DecisionKind::Overridden, 60'000, "seen, and the rest as well"});
  EXPECT_TRUE(is_grade(desk.header(id)));
  card.measured_milli = 100'000;
  store_score(database(), id, card);
  desk.decide({id, DecisionKind::Confirmed, 0, "seen"});
  EXPECT_TRUE(is_grade(desk.header(id)));
  AttemptHeader incomplete = desk.header(id);
  incomplete.is_complete = false;
  EXPECT_FALSE(is_grade(incomplete));
  AttemptHeader not_valid = desk.header(id);
  EXPECT_EQ(not_valid.is_valid, true);
  not_valid.is_valid = false;
  EXPECT_FALSE(is_grade(not_valid));
  desk.decide({id, DecisionKind::Voided, 0, "no"});
  EXPECT_FALSE(is_grade(desk.header(id)));
  const AttemptId practice = scored_by("ada", 61'000);
  desk.decide({practice, DecisionKind::Confirmed, 0, "seen"});
  EXPECT_FALSE(is_grade(desk.header(practice)));
}

TEST_F(Course, WritesWhatIsDoneToOthersIntoTheAudit) {
  const AttemptId id = scored_by("ada", 61'000);
  InstructorDesk teaching = instructor("kim", autumn());
  teaching.recording(id);
  EXPECT_EQ(last_audit().action, "attempt_viewed");
  teaching.decide({id, DecisionKind::Overridden, 5000, "no"});
  EXPECT_EQ(last_audit().action, "result_overridden");
  EXPECT_EQ(last_audit().actor, id_of("kim"));
  AdministratorDesk desk = administrator();
  desk.set_administrator("kim", true);
  EXPECT_EQ(last_audit().action, "administrator_made");
  desk.retire_scenario(published());
  EXPECT_EQ(last_audit().action, "scenario_retired");
  kind_thrown([&] { trainee("bob").header(id); });
  EXPECT_TRUE(last_audit().was_refused);
  EXPECT_EQ(last_audit().actor, id_of("bob"));
}

}  // namespace

}  // namespace hallux::database
