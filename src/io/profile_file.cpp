#include "io/profile_file.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>

#include "io/profile_lines.hpp"
#include "io/whole_file.hpp"
#include "support/error.hpp"

namespace rollcon {
namespace {

std::string_view without_comment(std::string_view line, std::string_view marks) {
  return trimmed(line.substr(0, line.find_first_of(marks)));
}

bool ends_in(const std::string& path, std::initializer_list<const char*> endings) {
  const std::string name = in_lower_case(path);
  return std::any_of(endings.begin(), endings.end(), [&](const char* e) { return name.ends_with(e); });
}

bool is_simpack(const std::string& path) {
  return ends_in(path, {".prr", ".prw"});
}

void require_two_points(const ProfileFile& file, const TextLines& lines) {
  if (file.point.size() < 2)
    lines.fail_whole("it has " + std::to_string(file.point.size()) + " point(s); needed: 2 or more");
}

// ------------------------------------------------------------------------------------ Simpack

/// Applies what the file says is to be done to the points, in this order.
void change_points(ProfileFile& file, std::map<std::string, double>& given, const TextLines& lines) {
  const auto value = [&](const char* key, double standard) {
    const auto found = given.find(key);
    return found == given.end() ? standard : found->second;
  };
  const double units = value("units.len.f", 1000), angle_units = value("units.ang.f", 1);
  if (!(units > 0)) lines.fail_whole("units.len.f is not > 0");
  if (!(angle_units > 0)) lines.fail_whole("units.ang.f is not > 0");
  const double least = value("point.dist.min", 0), angle = value("rotate", 0) / angle_units;
  const double c = std::cos(angle), s = std::sin(angle);
  const std::array<double, 2> shift{value("shift.y", 0), value("shift.z", 0)};
  const std::array<double, 2> low{value("bound.y.min", 0), value("bound.z.min", 0)};
  const std::array<double, 2> high{value("bound.y.max", 0), value("bound.z.max", 0)};
  const std::array<bool, 2> bounded{given.contains("bound.y.min") && given.contains("bound.y.max") && low[0] < high[0],
                                    given.contains("bound.z.min") && given.contains("bound.z.max") && low[1] < high[1]};
  const double mirror_y = value("mirror.y", 0) != 0 ? -1 : 1, mirror_z = value("mirror.z", 0) != 0 ? -1 : 1;
  ProfileFile changed;
  std::optional<std::array<double, 2>> before;
  for (std::size_t i = 0; i < file.point.size(); ++i) {
    std::array<double, 2> x = file.point[i];
    if (before && std::hypot(x[0] - (*before)[0], x[1] - (*before)[1]) < least) continue;
    before = x;
    x = {x[0] + shift[0], x[1] + shift[1]};
    x = {c * x[0] - s * x[1], s * x[0] + c * x[1]};
    bool outside = false;
    for (std::size_t k = 0; k < 2; ++k) outside = outside || (bounded[k] && (x[k] < low[k] || x[k] > high[k]));
    if (outside) continue;
    const double mm = 1000 / units;
    changed.point.push_back({mm * mirror_y * x[0], mm * mirror_z * x[1]});
    changed.line.push_back(file.line[i]);
  }
  if (value("inversion", 0) != 0) {
    std::reverse(changed.point.begin(), changed.point.end());
    std::reverse(changed.line.begin(), changed.line.end());
  }
  file = std::move(changed);
}

ProfileFile read_simpack(TextLines lines) {
  constexpr const char* numbers[] = {"point.dist.min", "shift.y",     "shift.z",     "rotate",   "bound.y.min",
                                     "bound.y.max",    "bound.z.min", "bound.z.max", "mirror.y", "mirror.z",
                                     "inversion",      "units.len.f", "units.ang.f"};
  ProfileFile file;
  std::map<std::string, double> given;
  std::vector<std::string> open;  // open sections, the innermost last
  bool points_seen = false;
  for (std::string_view line; lines.next(line);) {
    line = without_comment(line, "!%");
    if (line.empty()) continue;
    const std::string word = in_lower_case(line);
    if (word.ends_with(".begin")) {
      open.push_back(word.substr(0, word.size() - 6));
      if (open.back() == "point" && points_seen) lines.fail_here("a second section of points; needed: one");
      points_seen = points_seen || open.back() == "point";
    } else if (word.ends_with(".end")) {
      if (open.empty() || open.back() != word.substr(0, word.size() - 4))
        lines.fail_here("'" + word.substr(0, 40) + "' ends a section that is not open");
      open.pop_back();
    } else if (!open.empty() && open.back() == "point") {
      const std::vector<double> value = lines.numbers_in(line);
      if (value.size() < 2) lines.fail_here("1 number; needed: y and z");
      file.point.push_back({value[0], value[1]});
      file.line.push_back(lines.number());
    } else {
      const std::size_t equal = line.find('=');
      if (equal == std::string_view::npos) lines.fail_here("neither a section nor 'key = value'");
      const std::string key = in_lower_case(trimmed(line.substr(0, equal)));
      const std::string_view value = trimmed(line.substr(equal + 1));
      if (!value.empty() && std::find(std::begin(numbers), std::end(numbers), key) != std::end(numbers))
        given[key] = lines.number_in(value);
    }
  }
  if (!open.empty()) lines.fail_whole("it ends before '" + open.back() + ".end': truncated");
  if (!points_seen) lines.fail_whole("it has no section of points");
  change_points(file, given, lines);
  require_two_points(file, lines);
  return file;
}

// --------------------------------------------------------------------- columns, Miniprof, VAMPIRE

/// Reads rows of numbers below headings of any kind.
class RowReader {
 public:
  RowReader(const std::string& path, bool miniprof) : lines_(path), miniprof_(miniprof) {}

  ProfileFile read() {
    for (std::string_view line; lines_.next(line);) {
      line = trimmed(line);
      if (line.empty()) heading_open_ = false;
      if (!line.starts_with('"')) line = without_comment(line, "!%#");
      if (line.empty() || line.front() == '"') continue;
      if (line.front() == '[')
        begin_part(in_lower_case(line));
      else if (!over_)
        take(line);
    }
    finish();
    return std::move(file_);
  }

 private:
  void begin_part(const std::string& name) {
    heading_open_ = false;
    over_ = !file_.point.empty();
    if (over_ && name.find("points") != name.npos) ++more_parts_;
  }

  void take(std::string_view line) {
    const std::size_t equal = file_.point.empty() ? line.find('=') : line.npos;
    if (equal != line.npos)
      take_key(in_lower_case(trimmed(line.substr(0, equal))), trimmed(line.substr(equal + 1)));
    else if (!heading_open_ && may_be_number(line))
      take_row(without_comment(line, "\""));
    else if (file_.point.empty() && announced_ < 0)
      take_heading(line);
    else
      lines_.fail_here("'" + printable(line) + "' among the points");
  }

  /// Says whether a line begins like a number, however spoilt, and is therefore no heading.
  static bool may_be_number(std::string_view line) {
    const std::string word = in_lower_case(line.substr(0, line.find_first_of(" \t,;")));
    const std::size_t first = std::min(word.find_first_not_of("+-."), word.size());
    return first == word.size() || (word[first] >= '0' && word[first] <= '9') ||
           static_cast<unsigned char>(word[first]) >= 0x80 || word.substr(first) == "nan" ||
           word.substr(first) == "inf";
  }

  /// Takes a heading; in old files of Miniprof headings have numbers, and a blank line ends them.
  void take_heading(std::string_view line) {
    const std::string word = in_lower_case(line);
    vampire_ = vampire_ || word.starts_with("railprofile") || word.starts_with("wheelprofile");
    heading_open_ = miniprof_ && !keyed_;
    ++headings_;
  }

  void take_key(const std::string& key, std::string_view value) {
    keyed_ = true;
    if (key == "columndef") define_columns(value);
    if (key == "xoffset" && !value.empty()) offset_[0] = lines_.number_in(value);
    if (key == "yoffset" && !value.empty()) offset_[1] = lines_.number_in(value);
  }

  void define_columns(std::string_view definition) {
    column_ = {99, 99};
    for (std::size_t from = 0, count = 0; from <= definition.size(); ++count) {
      const std::size_t to = std::min(definition.find(',', from), definition.size());
      const std::string name = in_lower_case(trimmed(definition.substr(from, to - from)));
      if (name == "x") column_[0] = count;
      if (name == "y") column_[1] = count;
      from = to + 1;
    }
    if (std::max(column_[0], column_[1]) == 99) lines_.fail_here("ColumnDef names no columns X and Y");
    defined_ = true;
  }

  void take_row(std::string_view line) {
    const std::vector<double> value = lines_.numbers_in(line);
    const std::size_t rows = file_.point.size(), n = value.size();
    if (n == 1 && rows == 0 && announced_ < 0 && value[0] >= 2 && value[0] == std::floor(value[0])) {
      announced_ = value[0];
      return;
    }
    const bool loose = defined_ || miniprof_;
    if (rows == 0 && !loose) {
      width_ = n;
      if (n == 3) column_ = {1, 2};
      if (n == 4) column_ = {2, 3};
      first_ = n > 0 ? value[0] : 0;
    }
    const bool counts = n == 3 && (first_ == 0 || first_ == 1) && value[0] == first_ + static_cast<double>(rows);
    const std::size_t needed = std::max(column_[0], column_[1]) + 1;
    if (loose ? n < needed : n != width_ || !(n == 2 || counts || (n == 4 && vampire_)))
      lines_.fail_here(std::to_string(n) + " number(s); needed" +
                       (loose ? " by ColumnDef: " + std::to_string(needed)
                              : ": y and z; a third one before them may count the points from 0 or 1") +
                       "; seen: '" + printable(line) + "'");
    if (n == 4 && vampire_) other_rail_ = other_rail_ || value[0] != value[2] || value[1] != value[3];
    file_.point.push_back({value[column_[0]], value[column_[1]]});
    file_.line.push_back(lines_.number());
  }

  void finish() {
    const auto rows = static_cast<double>(file_.point.size());
    if (announced_ >= 0 && announced_ != rows)
      lines_.fail_whole("it announces " + std::to_string(static_cast<long long>(announced_)) + " points and has " +
                        std::to_string(file_.point.size()));
    if (file_.point.empty() && headings_ > 0)
      lines_.fail_whole("it has headings and no point below them; in files of Miniprof a blank line ends them");
    require_two_points(file_, lines_);
    for (auto& x : file_.point) x = {x[0] + offset_[0], x[1] + offset_[1]};
    if (more_parts_ > 0)
      file_.told = "it has " + std::to_string(more_parts_) + " more profile(s) behind the first, which alone is read";
    if (other_rail_) file_.told = "its two rails differ; columns 3 and 4, the right one, are read";
    if (width_ == 3 && !defined_) file_.told = "its first column counts the points and is passed over";
  }

  TextLines lines_;
  bool miniprof_;
  ProfileFile file_;
  std::array<double, 2> offset_{0, 0};
  std::array<std::size_t, 2> column_{0, 1};
  bool keyed_ = false, defined_ = false, heading_open_ = false, over_ = false, vampire_ = false, other_rail_ = false;
  std::size_t width_ = 0;
  double first_ = 0, announced_ = -1;
  int headings_ = 0, more_parts_ = 0;
};

// ------------------------------------------------------------------------------------ writing

/// Writes all digits, with a point in every locale.
std::string digits(double value) {
  char text[40];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  return {text, end};
}

std::string text_of(const std::vector<std::array<double, 2>>& point, bool simpack) {
  std::string text =
      simpack ? "header.begin\n  version = 1\nheader.end\nspline.begin\n  units.len.f = 1000\n  point.begin\n"
              : "! y z\n";
  for (const auto& x : point) {
    text += simpack ? "    " : "";
    text += digits(x[0]);
    text += ' ';
    text += digits(x[1]);
    text += '\n';
  }
  if (simpack) text += "  point.end\nspline.end\n";
  return text;
}

}  // namespace

ProfileFile read_profile_file(const std::string& path) {
  if (is_simpack(path)) return read_simpack(TextLines(path));
  return RowReader(path, ends_in(path, {".ban", ".whl", ".mpt"})).read();
}

void write_profile_file(const std::string& path, const std::vector<std::array<double, 2>>& point) {
  write_whole_file(path, text_of(point, is_simpack(path)));
}

}  // namespace rollcon
