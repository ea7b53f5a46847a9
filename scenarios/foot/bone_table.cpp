/// One line is one thing, told by its first word; numbers stand in the order that the refusal
/// shows. A table is read by people who measure bones, so each refusal names the line and what to
/// write there. What must be there once is counted while reading and checked at the end.
#include "scenarios/foot/bone_table.h"

#include <charconv>
#include <cmath>
#include <map>

#include "simulator/base/embedded.h"
#include "simulator/base/units.h"

namespace hallux::scenarios {

std::span<const EmbeddedText> foot_table_files() noexcept;

namespace {

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  std::size_t at = 0;
  while (at < line.size()) {
    const std::size_t first = line.find_first_not_of(" \t\r", at);
    if (first == std::string_view::npos) break;
    const std::size_t last = std::min(line.find_first_of(" \t\r", first), line.size());
    words.push_back(line.substr(first, last - first));
    at = last;
  }
  return words;
}

class TableReader {
 public:
  TableReader(std::string_view text, std::string_view name) : text_(text), name_(name) {}

  BoneTable read() {
    std::size_t at = 0;
    while (at < text_.size()) {
      const std::size_t end = std::min(text_.find('\n', at), text_.size());
      ++line_;
      read_line(text_.substr(at, end - at));
      at = end + 1;
    }
    check_complete();
    if (has_eminence()) table_.eminence = std::move(eminence_);
    return std::move(table_);
  }

 private:
  [[noreturn]] void refuse(const std::string& sentence) const {
    throw ScenarioError(name_ + ", line " + std::to_string(line_) + ": " + sentence);
  }

  void read_line(std::string_view line) {
    words_ = words_of(line.substr(0, line.find('#')));
    if (words_.empty()) return;
    const std::string key(words_.front());
    ++seen_[key];
    if (key == "bone") {
      read_names();
    } else if (key == "credit") {
      const std::size_t start = line.find("credit") + 6;
      table_.credit = std::string(line.substr(std::min(line.size(), start + 1)));
    } else if (key == "length") {
      table_.length_mm = positive(numbers(1, 1, "length MM")[0], "the length");
    } else if (key == "relief") {
      table_.relief_mm = numbers(1, 1, "relief MM")[0];
    } else if (key == "station") {
      read_station();
    } else if (key == "cap") {
      read_cap();
    } else if (key == "bump" || key == "groove") {
      read_feature(key == "bump");
    } else {
      read_head_line(key);
    }
  }

  void read_head_line(const std::string& key) {
    if (key == "cartilage") {
      read_cartilage();
    } else if (key == "eminence") {
      const auto v = numbers(1, 7, "eminence x y z rx ry rz k");
      eminence_.centre_mm = {v[0], v[1], v[2]};
      eminence_.radii_mm = positive_extent(v[3], v[4], v[5]);
      eminence_.blend_mm = positive(v[6], "k");
    } else if (key == "sulcus") {
      const auto v = numbers(1, 3, "sulcus x y z");
      eminence_.sulcus_mm.emplace_back(v[0], v[1], v[2]);
    } else if (key == "sulcus_groove") {
      const auto v = numbers(1, 3, "sulcus_groove r depth k");
      eminence_.sulcus_radius_mm = positive(v[0], "r");
      eminence_.sulcus_depth_mm = positive(v[1], "depth");
      eminence_.sulcus_blend_mm = positive(v[2], "k");
    } else if (key == "cortex") {
      const auto v = numbers(1, 2, "cortex mid floor");
      table_.cortex = {positive(v[0], "mid"), positive(v[1], "floor")};
    } else if (key == "place") {
      const auto v = numbers(1, 6, "place X Y Z X Y Z");
      table_.place = {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}};
    } else {
      refuse(
          "'" + key +
          "' is not a kind of line; use bone, credit, length, relief, station, cap, bump, groove, "
          "cartilage, eminence, sulcus, sulcus_groove, cortex or place");
    }
  }

  void read_names() {
    if (words_.size() != 3) refuse("write: bone NAME SHAPE");
    table_.bone = words_[1];
    table_.shape = words_[2];
  }

  void read_station() {
    const auto v = numbers(1, 10, "station s cy cz a b n tw c3 s3 e1");
    const double before = table_.stations.empty() ? 0.0 : table_.stations.back().position;
    if (!(v[0] > before && v[0] < 1.0)) {
      refuse("a station's s must rise from line to line and stay between 0 and 1");
    }
    if (!(v[5] >= 1.5 && v[5] <= 6.0)) refuse("a station's n must lie between 1.5 and 6");
    if (std::abs(v[7]) + std::abs(v[8]) > 0.5 || std::abs(v[9]) > 0.5) {
      refuse("c3, s3 and e1 above 0.5 make a section that is not star-shaped; use smaller ones");
    }
    table_.stations.push_back({v[0], v[1], v[2], positive(v[3], "a"), positive(v[4], "b"), v[5],
                               radian_from_degree(v[6]), v[7], v[8], v[9]});
  }

  void read_cap() {
    if (words_.size() < 2 || (words_[1] != "base" && words_[1] != "head")) {
      refuse("write: cap base ... or cap head ...");
    }
    const auto v = numbers(2, 10, "cap base|head x R p y0 z0 ty tz kyy kzz kyz");
    const bool is_base = words_[1] == "base";
    ++seen_[is_base ? "cap base" : "cap head"];
    EndCap& cap = is_base ? table_.base : table_.head;
    cap = {v[0], positive(v[1], "R"), positive(v[2], "p"), v[3], v[4], v[5], v[6], v[7], v[8],
           v[9]};
  }

  void read_feature(bool is_bump) {
    Feature feature;
    if (words_.size() < 2) refuse("a feature needs a name after its kind");
    feature.name = words_[1];
    const auto v = is_bump ? numbers(2, 7, "bump NAME x y z sx sy sz height")
                           : numbers(2, 8, "groove NAME x y z x y z r k");
    feature.kind = is_bump ? FeatureKind::Bump : FeatureKind::Groove;
    feature.centre_mm = {v[0], v[1], v[2]};
    if (is_bump) {
      feature.extent_mm = positive_extent(v[3], v[4], v[5]);
      feature.height_mm = v[6];
    } else {
      feature.end_mm = {v[3], v[4], v[5]};
      feature.radius_mm = positive(v[6], "r");
      feature.blend_mm = positive(v[7], "k");
    }
    table_.features.push_back(std::move(feature));
  }

  void read_cartilage() {
    const auto v = numbers(1, 8, "cartilage x y z r medial lateral dorsal plantar");
    for (std::size_t k = 4; k < 8; ++k) {
      if (!(v[k] > 0.0 && v[k] < 170.0)) refuse("cartilage reaches between 0 and 170 degrees");
    }
    table_.cartilage = {{v[0], v[1], v[2]},       positive(v[3], "r"),
                        radian_from_degree(v[4]), radian_from_degree(v[5]),
                        radian_from_degree(v[6]), radian_from_degree(v[7])};
  }

  std::vector<double> numbers(std::size_t first, std::size_t count, const char* form) const {
    if (words_.size() != first + count) {
      refuse("found " + std::to_string(words_.size() - std::min(first, words_.size())) +
             " numbers, needs " + std::to_string(count) + "; write: " + form);
    }
    std::vector<double> values;
    for (std::size_t k = first; k < words_.size(); ++k) {
      double value = 0.0;
      const char* end = words_[k].data() + words_[k].size();
      const auto [stop, error] = std::from_chars(words_[k].data(), end, value);
      if (error != std::errc{} || stop != end || !std::isfinite(value)) {
        refuse("'" + std::string(words_[k]) + "' is not a number; write: " + form);
      }
      values.push_back(value);
    }
    return values;
  }

  double positive(double value, const char* what) const {
    if (!(value > 0.0)) refuse(std::string(what) + " must be above 0");
    return value;
  }

  Vec3 positive_extent(double x, double y, double z) const {
    return {positive(x, "the extent along x"), positive(y, "the extent along y"),
            positive(z, "the extent along z")};
  }

  int seen(const std::string& key) const {
    const auto found = seen_.find(key);
    return found == seen_.end() ? 0 : found->second;
  }

  void check_once(const std::string& key) const {
    if (seen(key) == 1) return;
    throw ScenarioError(name_ + ": has " + std::to_string(seen(key)) + " lines '" + key +
                        "', needs exactly one");
  }

  void check_complete() const {
    for (const char* key :
         {"bone", "length", "relief", "cap base", "cap head", "cartilage", "cortex", "place"}) {
      check_once(key);
    }
    if (table_.stations.size() < 4) throw ScenarioError(name_ + ": needs at least four stations");
    if (!has_eminence()) return;
    check_once("eminence");
    check_once("sulcus_groove");
    if (eminence_.sulcus_mm.size() < 2) {
      throw ScenarioError(name_ + ": needs at least two lines 'sulcus'");
    }
  }

  /// Its lines come all or not at all.
  bool has_eminence() const {
    return seen("eminence") + seen("sulcus") + seen("sulcus_groove") > 0;
  }

  std::string_view text_;
  std::string name_;
  BoneTable table_;
  EminenceShape eminence_;
  std::vector<std::string_view> words_;
  std::map<std::string, int> seen_;
  std::size_t line_ = 0;
};

}  // namespace

BoneTable parse_bone_table(std::string_view text, std::string_view name) {
  return TableReader(text, name).read();
}

BoneTable shipped_bone_table(std::string_view name) {
  std::string known;
  for (const EmbeddedText& file : foot_table_files()) {
    if (file.name == name) return parse_bone_table(file.text, file.name);
    known += (known.empty() ? "" : ", ") + std::string(file.name);
  }
  throw ScenarioError("no bone table '" + std::string(name) + "' is shipped; use one of: " + known);
}

}  // namespace hallux::scenarios
