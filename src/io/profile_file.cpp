#include "io/profile_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>
#include <system_error>

#include "io/part_file.hpp"
#include "io/profile_lines.hpp"
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

ProfileFile read_columns(TextLines lines) {
  ProfileFile file;
  for (std::string_view line; lines.next(line);) {
    line = without_comment(line, "!%#");
    if (line.empty()) continue;
    const std::vector<double> value = lines.numbers_in(line);
    if (value.size() != 2) lines.fail_here(std::to_string(value.size()) + " number(s); needed: y and z");
    file.point.push_back({value[0], value[1]});
    file.line.push_back(lines.number());
  }
  require_two_points(file, lines);
  return file;
}

// ------------------------------------------------------------------------------------ Simpack

/// What is done to the points, in this order.
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
  std::vector<std::string> open;  // sections, the innermost last
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
      if (std::find(std::begin(numbers), std::end(numbers), key) != std::end(numbers))
        given[key] = lines.number_in(line.substr(equal + 1));
    }
  }
  if (!open.empty()) lines.fail_whole("it ends before '" + open.back() + ".end': truncated");
  if (!points_seen) lines.fail_whole("it has no section of points");
  change_points(file, given, lines);
  require_two_points(file, lines);
  return file;
}

// ----------------------------------------------------------------------------------- Miniprof

/// Numbers of the columns of y and z in a row.
std::array<std::size_t, 2> columns_of(std::string_view definition, const TextLines& lines) {
  std::array<std::size_t, 2> column{99, 99};
  std::size_t count = 0;
  for (std::size_t from = 0; from <= definition.size(); ++count) {
    const std::size_t to = std::min(definition.find(',', from), definition.size());
    const std::string name = in_lower_case(trimmed(definition.substr(from, to - from)));
    if (name == "x") column[0] = count;
    if (name == "y") column[1] = count;
    from = to + 1;
  }
  if (std::max(column[0], column[1]) == 99) lines.fail_here("ColumnDef names no columns X and Y");
  return column;
}

ProfileFile read_miniprof(TextLines lines) {
  ProfileFile file;
  std::array<double, 2> offset{0, 0};
  std::array<std::size_t, 2> column{0, 1};
  bool header = true;
  for (std::string_view line; lines.next(line);) {
    line = trimmed(line);
    if (!line.empty() && std::string_view("!\"%#").find(line.front()) != std::string_view::npos) continue;
    if (line.empty()) {
      header = false;
      continue;
    }
    if (header) {
      const std::size_t equal = line.find('=');
      if (equal == std::string_view::npos) lines.fail_here("no 'Key=Value'; a blank line ends the header");
      const std::string key = in_lower_case(trimmed(line.substr(0, equal)));
      const std::string_view value = trimmed(line.substr(equal + 1));
      if (key == "columndef") column = columns_of(value, lines);
      if (key == "xoffset") offset[0] = lines.number_in(value);
      if (key == "yoffset") offset[1] = lines.number_in(value);
      continue;
    }
    const std::vector<double> value = lines.numbers_in(line);
    const std::size_t needed = std::max(column[0], column[1]) + 1;
    if (value.size() < needed)
      lines.fail_here(std::to_string(value.size()) + " number(s); needed by ColumnDef: " + std::to_string(needed));
    file.point.push_back({value[column[0]] + offset[0], value[column[1]] + offset[1]});
    file.line.push_back(lines.number());
  }
  require_two_points(file, lines);
  return file;
}

// ------------------------------------------------------------------------------------ writing

/// All digits, with a point in every locale.
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
  if (ends_in(path, {".ban", ".whl"})) return read_miniprof(TextLines(path));
  return read_columns(TextLines(path));
}

void write_profile_file(std::string path, const std::vector<std::array<double, 2>>& point) {
  const std::string text = text_of(point, is_simpack(path));
  const std::string asked = path;
  std::string part;
  const auto failed = [&](int error) {
    if (!part.empty()) unlink(part.c_str());
    fail(Status::err_io, "%s cannot be written: %s", asked.c_str(), std::generic_category().message(error).c_str());
  };
  const int file = open_part(path, part);
  if (file < 0) {
    const int error = errno;
    part.clear();
    failed(error);
  }
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t written = write(file, text.data() + done, text.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) {
      const int error = written < 0 ? errno : EIO;
      close(file);
      failed(error);
    }
    done += static_cast<std::size_t>(written);
  }
  if (close(file) != 0) failed(errno);
  if (std::rename(part.c_str(), path.c_str()) != 0) failed(errno);
}

}  // namespace rollcon
