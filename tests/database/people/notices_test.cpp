#include "database/people/notices.h"

#include <gtest/gtest.h>

#include "tests/database/some_course.h"

namespace hallux::database {

namespace {

class Notices : public testing::Test, protected SomeCourse {
 protected:
  std::vector<Notice> told_to(const std::string& login) { return sign_in_as(login).notices(); }
};

TEST_F(Notices, AreToldUntilTheyAreAcknowledged) {
  administrator().set_password("ada", secret(good_password), cheap);
  Session ada = sign_in_as("ada");
  const auto told = ada.notices();
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0].kind, NoticeKind::PasswordSet);
  EXPECT_EQ(told[0].login, "root");
  EXPECT_FALSE(told[0].is_for_administrators);
  EXPECT_EQ(told_to("ada").size(), 1U);
  ada.acknowledge(told[0]);
  ada.acknowledge(told[0]);
  EXPECT_TRUE(told_to("ada").empty());
  EXPECT_TRUE(told_to("bob").empty());
}

TEST_F(Notices, OfACodeNameWhoMadeIt) {
  AddedPerson added = administrator().add_person_with_code({"new", "", false}, cheap);
  redeem_code(database(), "new", added.issued.code, secret(good_password), cheap);
  EXPECT_TRUE(told_to("new").empty());
  IssuedCode issued = administrator().reset("new", cheap);
  Session session =
      redeem_code(database(), "new", issued.code, secret("another long phrase"), cheap);
  ASSERT_EQ(session.notices().size(), 1U);
  EXPECT_EQ(session.notices()[0].kind, NoticeKind::CodeIssued);
  EXPECT_EQ(session.notices()[0].login, "root");
}

TEST_F(Notices, TellATraineeThatAResultWasChangedAndNotThatItStands) {
  const AttemptId attempt = scored_by("ada", 50'000);
  InstructorDesk desk = instructor("kim", autumn());
  desk.decide({attempt, DecisionKind::Confirmed, 0, "seen"});
  EXPECT_TRUE(told_to("ada").empty());
  desk.decide({attempt, DecisionKind::Overridden, 60'000, "the guide slipped"});
  desk.decide({attempt, DecisionKind::Voided, 0, "the saw was broken"});
  const auto told = told_to("ada");
  ASSERT_EQ(told.size(), 2U);
  EXPECT_EQ(told[0].kind, NoticeKind::ResultVoided);
  EXPECT_EQ(told[1].kind, NoticeKind::ResultOverridden);
  EXPECT_EQ(told[1].attempt, attempt);
  for (const Notice& notice : told) EXPECT_EQ(notice.login, "kim") << "who decided";
}

TEST_F(Notices, CountRefusedSignInsInOneLine) {
  for (int i = 0; i < 3; ++i) {
    EXPECT_THROW(sign_in(database(), "ada", secret("not the password"), cheap), DatabaseError);
  }
  database().pretend_to_be("another station");
  Session ada = sign_in_as("ada");
  ASSERT_EQ(ada.notices().size(), 1U);
  EXPECT_EQ(ada.notices()[0].kind, NoticeKind::SignInsRefused);
  EXPECT_EQ(ada.notices()[0].count, 3);
  ada.acknowledge(ada.notices()[0]);
  EXPECT_THROW(sign_in(database(), "ada", secret("not the password"), cheap), DatabaseError);
  ASSERT_EQ(ada.notices().size(), 1U);
  EXPECT_EQ(ada.notices()[0].count, 1);
}

TEST_F(Notices, ForAdministratorsAreToldToEachOfThem) {
  administrator().set_administrator("kim", true);
  Session root = sign_in_as("root"), max = sign_in_as("max");
  ASSERT_EQ(root.notices().size(), 1U);
  EXPECT_EQ(root.notices()[0].kind, NoticeKind::AdministratorMade);
  EXPECT_EQ(root.notices()[0].login, "kim");
  EXPECT_TRUE(root.notices()[0].is_for_administrators);
  root.acknowledge(root.notices()[0]);
  EXPECT_TRUE(root.notices().empty());
  EXPECT_EQ(max.notices().size(), 1U);
  EXPECT_TRUE(told_to("ada").empty());
}

TEST_F(Notices, OfOthersAndThoseThatAreNotAreRefusedAlike) {
  tell_person(database(), id_of("bob"), NoticeKind::PasswordSet);
  Notice of_bob = unseen_notices(database(), id_of("bob")).front();
  Notice of_nobody = of_bob;
  of_nobody.id = {99};
  Session ada = sign_in_as("ada");
  EXPECT_EQ(kind_thrown([&] { ada.acknowledge(of_bob); }), DatabaseErrorKind::Refused);
  EXPECT_EQ(kind_thrown([&] { ada.acknowledge(of_nobody); }), DatabaseErrorKind::Refused);
  EXPECT_EQ(unseen_notices(database(), id_of("bob")).size(), 1U);
}

}  // namespace

}  // namespace hallux::database
