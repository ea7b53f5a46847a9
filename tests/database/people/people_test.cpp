#include "database/people/people.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include "tests/database/some_database.h"

namespace hallux::database {

namespace {

constexpr const char* good_password = "a long enough phrase";

PersonId add(Database& database, const std::string& login, bool is_administrator = false) {
  return create_person(database, {login, "", is_administrator}, secret(good_password), cheap);
}

std::string hash_of(Database& database, PersonId id) {
  SQLite::Statement row{database.connection(), "SELECT argon2id FROM password WHERE person_id = ?"};
  row.bind(1, id.number);
  row.executeStep();
  return row.getColumn(0).getString();
}

TEST(People, AreKnownByTheirPassword) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  const PersonId id = add(database, "ada");
  EXPECT_EQ(verify_person(database, "ada", secret(good_password), cheap)->id, id);
  EXPECT_FALSE(verify_person(database, "ada", secret("a long enough Phrase"), cheap));
  EXPECT_FALSE(verify_person(database, "ada", secret(""), cheap));
  EXPECT_FALSE(verify_person(database, "bob", secret(good_password), cheap));
  EXPECT_EQ(hash_of(database, id).rfind("$argon2id$", 0), 0U);
}

TEST(People, HaveTheirHashMadeAnewWhenTheCostChanges) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  const PersonId id = add(database, "ada");
  const std::string before = hash_of(database, id);
  EXPECT_TRUE(verify_person(database, "ada", secret(good_password), {2, 8192}));
  EXPECT_NE(hash_of(database, id), before);
  EXPECT_FALSE(needs_rehash(hash_of(database, id), {2, 8192}));
  EXPECT_TRUE(verify_person(database, "ada", secret(good_password), {2, 8192}));
}

TEST(People, AreRefusedABadLogin) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  const std::string with_umlaut = std::string("\xC3\xA4") + "da";
  for (const std::string& login :
       {std::string(), std::string("a"), std::string("Ada"), std::string("1ada"),
        std::string("ada lovelace"), std::string("ada'--"), std::string("../ada"), with_umlaut}) {
    try {
      add(database, login);
      ADD_FAILURE() << login;
    } catch (const DatabaseError& error) {
      EXPECT_EQ(error.kind(), DatabaseErrorKind::BadInput) << login;
    }
  }
  EXPECT_THROW(add(database, std::string(65, 'a')), DatabaseError);
  EXPECT_FALSE(has_people(database));
}

TEST(People, CannotShareALogin) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  add(database, "ada");
  EXPECT_THROW(add(database, "ada"), DatabaseError);
  EXPECT_EQ(list_people(database).size(), 1U);
}

TEST(People, WhoAreDisabledAreNotKnown) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  add(database, "root", true);
  const PersonId id = add(database, "ada");
  set_disabled(database, id, true);
  EXPECT_FALSE(verify_person(database, "ada", secret(good_password), cheap));
  set_disabled(database, id, false);
  EXPECT_TRUE(verify_person(database, "ada", secret(good_password), cheap));
}

TEST(People, AlwaysHaveAnAdministrator) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  const PersonId first = add(database, "ada", true);
  const PersonId second = add(database, "bob", true);
  set_disabled(database, first, true);
  EXPECT_THROW(set_disabled(database, second, true), DatabaseError);
  EXPECT_FALSE(load_person(database, second).is_disabled);
}

TEST(People, AlwaysHaveAnAdministratorWhoCanSignIn) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  const PersonId only = add(database, "ada", true);
  create_person_without_password(database, {"bob", "", true});
  EXPECT_THROW(set_disabled(database, only, true), DatabaseError);
  EXPECT_THROW(set_administrator(database, only, false), DatabaseError);
  EXPECT_THROW(remove_password(database, only), DatabaseError);
  EXPECT_TRUE(load_person(database, only).is_administrator);
  EXPECT_TRUE(verify_person(database, "ada", secret(good_password), cheap));
}

TEST(People, WithoutAPasswordAreNotKnown) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  create_person_without_password(database, {"ada", "", false});
  EXPECT_FALSE(verify_person(database, "ada", secret(""), cheap));
  EXPECT_FALSE(find_person(database, "ada").has_password);
}

TEST(Passwords, MustBeLongAndUncommon) {
  EXPECT_NO_THROW(check_password_rules(secret("twelve chars")));
  EXPECT_THROW(check_password_rules(secret("eleven char")), DatabaseError);
  EXPECT_THROW(check_password_rules(secret("")), DatabaseError);
  EXPECT_THROW(check_password_rules(secret("Password1234")), DatabaseError);
  EXPECT_THROW(check_password_rules(secret("aaaaaaaaaaaaaaaa")), DatabaseError);
  EXPECT_NO_THROW(check_password_rules(secret(std::string(64, 'a') + std::string(64, 'b'))));
  EXPECT_THROW(check_password_rules(secret(std::string(64, 'a') + std::string(65, 'b'))),
               DatabaseError);
}

TEST(Passwords, AreNotTheLogin) {
  const TemporaryDirectory temporary;
  Database database = Database::open(temporary.data());
  EXPECT_NO_THROW(check_password_rules(secret("adalovelace and more"), "adalovelace"));
  EXPECT_THROW(check_password_rules(secret("adalovelace1"), "adalovelace1"), DatabaseError);
  EXPECT_THROW(check_password_rules(secret("AdaLovelace1"), "adalovelace1"), DatabaseError);
  EXPECT_THROW(check_password_rules(secret("lovelovelove"), "love"), DatabaseError);
  const PersonId id = add(database, "lovelace.ada");
  EXPECT_THROW(set_password(database, id, secret("lovelace.ada"), cheap), DatabaseError);
  EXPECT_THROW(create_person(database, {"ada.lovelace", "", false}, secret("ada.lovelace"), cheap),
               DatabaseError);
}

TEST(Passwords, AreCountedInCharactersNotBytes) {
  // Six characters of two bytes each are no twelve.
  EXPECT_THROW(check_password_rules(secret("\xC3\xA4\xC3\xB6\xC3\xBC\xC3\x9F\xC3\xA9\xC3\xA8")),
               DatabaseError);
}

TEST(SecretText, WipesWhereItCameFrom) {
  std::string source = "a secret that is long enough to live on the heap";
  const char* before = source.data();
  const SecretText taken = SecretText::take(source);
  EXPECT_EQ(taken.view(), "a secret that is long enough to live on the heap");
  EXPECT_TRUE(source.empty());
  EXPECT_EQ(before, source.data());
  EXPECT_EQ(std::string(before + 1, 4), std::string(4, '\0'));
}

}  // namespace

}  // namespace hallux::database
