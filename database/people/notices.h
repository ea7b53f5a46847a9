/// Notices: sentences shown to a person at sign-in until they are acknowledged.
/// Inside this room only.
///
/// A notice holds numbers only, so that nothing of it need be erased with a person. One for all
/// administrators is told to each of them, and each acknowledges it for themself.
#pragma once

#include <cstdint>
#include <vector>

#include "database/records/notice.h"
#include "database/store/connection.h"

namespace hallux::database {

/// What a notice is about: a person, an attempt, or nothing.
struct NoticeSubject {
  std::optional<PersonId> person = {};
  std::optional<AttemptId> attempt = {};
};

// All inside the caller's transaction, or in one of their own.
void tell_person(Database& database, PersonId told, NoticeKind kind,
                 const NoticeSubject& about = {});
void tell_administrators(Database& database, NoticeKind kind, const NoticeSubject& about = {});
/// One more refused sign-in: a notice that was not seen yet counts up, so that there is one however
/// many there were.
void tell_of_refused_sign_in(Database& database, PersonId told);

/// Those told to this person that they did not acknowledge, newest first.
std::vector<Notice> unseen_notices(Database& database, PersonId person);
/// The same of those told to every administrator.
std::vector<Notice> unseen_notices_of_administrators(Database& database, PersonId person);

/// Whether the notice was told to this person alone, or to all administrators; nothing where there
/// is none.
struct NoticeAudience {
  std::optional<PersonId> person;
};
std::optional<NoticeAudience> audience_of(Database& database, NoticeId notice);
/// Twice is once.
void acknowledge_notice(Database& database, NoticeId notice, PersonId person);

}  // namespace hallux::database
