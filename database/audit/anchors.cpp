#include "database/audit/anchors.h"

#include <sstream>

#include "database/store/own_directory.h"
#include "database/store/sql.h"

namespace hallux::database {

namespace {

constexpr std::string_view anchor_word = "hallux-anchor";

Anchor anchor_in(std::string_view line) {
  std::istringstream words{std::string{line}};
  std::string word, head;
  Anchor anchor;
  words >> word >> anchor.directory.text >> anchor.acts >> head >> anchor.at_utc;
  const std::optional<Digest> digest = digest_from_hex(head);
  if (!words || !digest || anchor.acts < 1) {
    throw DatabaseError{DatabaseErrorKind::BadInput,
                        "'" + std::string{line.substr(0, 80)} +
                            "' is no whole anchor; give the line as `hallux anchor` printed it"};
  }
  anchor.head = *digest;
  return anchor;
}

}  // namespace

std::string text_of(const Anchor& anchor) {
  return std::string{anchor_word} + " " + anchor.directory.text + " " +
         std::to_string(anchor.acts) + " " + hex_from_digest(anchor.head) + " " + anchor.at_utc;
}

Anchor take_anchor(Database& database) {
  return translating(database, "read the head of the audit", [&] {
    Anchor anchor;
    anchor.directory = own_directory(database);
    auto last = prepared(database,
                         "SELECT audit_id, link, at_utc FROM audit ORDER BY audit_id DESC LIMIT 1");
    if (last.executeStep()) read_columns(last, 0, anchor.acts, anchor.head, anchor.at_utc);
    return anchor;
  });
}

std::vector<Anchor> anchors_in(std::string_view text) {
  std::vector<Anchor> anchors;
  for (std::size_t at = text.find(anchor_word); at != std::string_view::npos;
       at = text.find(anchor_word, at + 1)) {
    const std::string_view rest = text.substr(at);
    anchors.push_back(anchor_in(rest.substr(0, rest.find_first_of("\r\n<"))));
  }
  if (!anchors.empty()) return anchors;
  throw DatabaseError{DatabaseErrorKind::BadInput,
                      "there is no anchor in it; give a file with a line of `hallux anchor`, a "
                      "report, or the answer of a backup"};
}

void check_anchor(Database& database, const Anchor& anchor) {
  translating(database, "hold the audit against an anchor", [&] {
    if (own_directory(database).text != anchor.directory.text) {
      throw DatabaseError{DatabaseErrorKind::BadInput,
                          "the anchor of " + anchor.at_utc + " is of another directory, " +
                              anchor.directory.text + "; choose that of this one"};
    }
    const auto link =
        found<Digest>(database, "SELECT link FROM audit WHERE audit_id = ?", anchor.acts);
    if (link == anchor.head) return;
    throw DatabaseError{DatabaseErrorKind::Damaged,
                        "the audit in " + database.file().string() + " is not the one of " +
                            anchor.at_utc + ": act " + std::to_string(anchor.acts) +
                            (link ? " was another" : " is missing") +
                            " then; acts were cut off or written anew, restore a backup"};
  });
}

}  // namespace hallux::database
