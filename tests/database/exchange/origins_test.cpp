#include "database/exchange/origins.h"

#include <gtest/gtest.h>

#include "database/audit/audit.h"
#include "database/store/own_directory.h"
#include "tests/database/some_course.h"

namespace hallux::database {

namespace {

const DirectoryId elsewhere{std::string(32, 'e')};

TEST(Origins, ADirectoryHasAnIdentityThatStays) {
  const TemporaryDirectory temporary;
  DirectoryId first;
  {
    Database database = Database::open(temporary.data());
    first = own_directory(database);
    EXPECT_EQ(first.text.size(), 32U);
    EXPECT_ANY_THROW(tamper(database, "UPDATE directory SET uuid = '" + elsewhere.text + "'"));
  }
  Database again = Database::open(temporary.data());
  EXPECT_EQ(own_directory(again), first);
}

TEST(Origins, APersonOfAnOriginIsOneNamelessPersonWhoCannotSignIn) {
  SomeCourse course;
  const std::size_t people = course.administrator().people().size();
  const std::int64_t origin = note_origin(course.database(), elsewhere);
  EXPECT_EQ(note_origin(course.database(), elsewhere), origin);
  const PersonId here = note_origin_person(course.database(), origin, {12});
  EXPECT_EQ(note_origin_person(course.database(), origin, {12}), here);
  EXPECT_NE(note_origin_person(course.database(), origin, {13}), here);
  EXPECT_TRUE(load_person(course.database(), here).is_disabled);
  EXPECT_FALSE(load_person(course.database(), here).has_password);
  EXPECT_EQ(course.administrator().people().size(), people);
  const std::vector<Origin> origins = course.administrator().origins();
  ASSERT_EQ(origins.size(), 1U);
  EXPECT_EQ(origins[0].directory, elsewhere);
  EXPECT_EQ(origins[0].people, 2);
  EXPECT_FALSE(origins[0].is_accepted);
}

TEST(Origins, WhoWasErasedDoesNotComeBack) {
  SomeCourse course;
  const std::int64_t origin = note_origin(course.database(), elsewhere);
  const PersonId here = note_origin_person(course.database(), origin, {12});
  tamper(course.database(), "INSERT INTO erasure VALUES (" + std::to_string(here.number) +
                                ", '2026-03-01T00:00:00.000Z')");
  refuse_erased(course.database(), origin, {13});
  EXPECT_EQ(kind_thrown([&] { refuse_erased(course.database(), origin, {12}); }),
            DatabaseErrorKind::Refused);
}

TEST(Origins, WhoWasErasedDoesNotComeBackFromTheOwnExportEither) {
  SomeCourse course;
  const PersonId ada = course.id_of("ada");
  tamper(course.database(), "INSERT INTO erasure VALUES (" + std::to_string(ada.number) +
                                ", '2026-03-01T00:00:00.000Z')");
  const std::int64_t origin = note_origin(course.database(), own_directory(course.database()));
  EXPECT_EQ(kind_thrown([&] { refuse_erased(course.database(), origin, ada); }),
            DatabaseErrorKind::Refused);
}

TEST(Origins, AnIdentityIsRefusedUnlessItIsOne) {
  SomeCourse course;
  for (const std::string& text : {std::string{}, std::string(31, 'a'), std::string(32, 'G'),
                                  std::string{"../../../../etc/passwd/aaaaaaaaa"}}) {
    EXPECT_EQ(kind_thrown([&] { note_origin(course.database(), {text}); }),
              DatabaseErrorKind::BadInput);
  }
}

TEST(Origins, AcceptingIsNotedAndMayBeTakenBack) {
  SomeCourse course;
  note_origin(course.database(), elsewhere);
  course.administrator().set_accepted(elsewhere, true);
  EXPECT_TRUE(course.administrator().origins()[0].is_accepted);
  AdministratorDesk desk = course.administrator();
  desk.set_accepted(elsewhere, false);
  EXPECT_EQ(course.last_audit().action, "origin_unaccepted");
  EXPECT_EQ(course.last_audit().subject_id, elsewhere.text);
  EXPECT_FALSE(desk.origins()[0].is_accepted);
  EXPECT_EQ(kind_thrown([&] { desk.set_accepted({std::string(32, '0')}, true); }),
            DatabaseErrorKind::NotFound);
}

TEST(Origins, AnAttemptFromAnOriginIsAGradeOnlyWhereThatIsAccepted) {
  SomeCourse course;
  NewAttempt attempt = course.attempt_of("ada");
  attempt.kind = AttemptKind::Assessment;
  const AttemptId id = record(course.database(), attempt, some_recording(5));
  store_score(course.database(), id, card_worth(70'000));
  course.instructor("kim", course.autumn()).decide({id, DecisionKind::Overridden, 60'000, "seen"});
  tamper(course.database(),
         "UPDATE attempt SET is_valid = 1, quality_json = '{\"complete\": true}' WHERE uuid = '" +
             id.text + "'");
  EXPECT_TRUE(is_grade(load_header(course.database(), id)));
  const std::int64_t origin = note_origin(course.database(), elsewhere);
  tamper(course.database(), "UPDATE attempt SET origin_id = " + std::to_string(origin));
  EXPECT_FALSE(is_grade(load_header(course.database(), id)));
  EXPECT_EQ(load_header(course.database(), id).origin, elsewhere);
  course.administrator().set_accepted(elsewhere, true);
  EXPECT_TRUE(is_grade(load_header(course.database(), id)));
}

}  // namespace

}  // namespace hallux::database
