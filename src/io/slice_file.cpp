#include "io/slice_file.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "io/profile_lines.hpp"

namespace rollcon {
namespace {

/// Gives the lines of the list that say something, without comments.
class SliceLines {
 public:
  explicit SliceLines(const std::string& path) : lines_(path) {}

  std::string_view next(const char* what) {
    for (std::string_view line; lines_.next(line);) {
      line = trimmed(line.substr(0, line.find_first_of("%!#")));
      if (!line.empty()) return line;
    }
    lines_.fail_whole(std::string("it ends before ") + what);
  }
  /// Returns the numbers with which the next line begins; words may follow.
  std::vector<double> numbers(std::size_t least, const char* what) {
    const std::string_view line = next(what);
    std::size_t end = 0;
    while (end < line.size() && !begins_word(line, end)) ++end;
    const std::string_view numbers = trimmed(line.substr(0, end));
    std::vector<double> value = numbers.empty() ? std::vector<double>{} : lines_.numbers_in(numbers);
    if (value.size() < least) lines_.fail_here(std::to_string(value.size()) + " number(s); needed: " + what);
    return value;
  }
  std::int64_t count(double value, double most, const char* what) const {
    if (!(value >= 0 && value <= most && value == std::floor(value)))
      lines_.fail_here(std::string(what) + " is no whole number from 0 to " + std::to_string(static_cast<int>(most)));
    return static_cast<std::int64_t>(value);
  }
  const TextLines& lines() const { return lines_; }

 private:
  static bool begins_word(std::string_view line, std::size_t i) {
    const bool letter = std::isalpha(static_cast<unsigned char>(line[i])) != 0 || line[i] == '\'' || line[i] == '"';
    return letter && (i == 0 || std::isspace(static_cast<unsigned char>(line[i - 1])) != 0 || line[i - 1] == ',');
  }

  TextLines lines_;
};

std::string quoted_name(std::string_view line, const SliceLines& lines) {
  const std::size_t from = line.find_first_of("'\"");
  const std::size_t to = from == line.npos ? from : line.find(line[from], from + 1);
  if (to == line.npos || to == from + 1) lines.lines().fail_here("no file's name in quotes");
  return std::string(line.substr(from + 1, to - from - 1));
}

}  // namespace

SliceFile read_slice_file(const std::string& path) {
  constexpr double most_slices = 1e5, most_features = 1000, most_waves = 1000, turn = 2 * std::numbers::pi;
  SliceLines lines(path);
  SliceFile file;
  file.round = in_lower_case(path).ends_with(".slcw");
  const auto offset = lines.numbers(2, "offset and scale of places");
  const auto slices = lines.count(lines.numbers(1, "the number of slices")[0], most_slices, "the number of slices");
  const auto counts = lines.numbers(1, "numbers of features, kinks and accelerations");
  const auto features = lines.count(counts[0], most_features, "the number of features");
  const auto how = lines.numbers(1, "the interpolation, 1 or 2");
  if (how[0] != 1 && how[0] != 2) lines.lines().fail_here("the interpolation is neither 1 nor 2");
  file.smooth = how[0] == 2;
  if (slices < 1) lines.lines().fail_whole("it has no slices");
  const std::size_t slash = path.find_last_of('/');
  const std::string folder = slash == path.npos ? "" : path.substr(0, slash + 1);
  std::vector<double> given;
  for (std::int64_t i = 0; i < slices; ++i) {
    const std::string_view line = lines.next("the last slice");
    const std::string name = quoted_name(line, lines);
    const double place = lines.lines().number_in(trimmed(line.substr(0, line.find_first_of("'\""))));
    const double u = offset[1] * (offset[0] + place);
    if (offset[1] == 0 || !std::isfinite(u))
      lines.lines().fail_here("scale times offset and place is " + std::to_string(u) + "; the scale may not be 0");
    given.push_back(place);
    file.slice.push_back({u, name.front() == '/' ? name : folder + name, {}});
  }
  for (std::size_t i = 1; i < counts.size() && i < 3; ++i)
    if (counts[i] > 0) lines.next("parts with kinks or accelerations");
  for (std::int64_t i = 0; features > 1 && i < slices; ++i) {
    auto value = lines.numbers(static_cast<std::size_t>(features) + 1, "the place and a length for each feature");
    value.resize(static_cast<std::size_t>(features) + 1);
    constexpr double rounding = 1e-3;
    const double place = given[static_cast<std::size_t>(i)];
    if (!(std::abs(value[0] - place) <= rounding * std::max(1.0, std::abs(place))))
      lines.lines().fail_here("features at " + std::to_string(value[0]) + "; the slice is at " + std::to_string(place));
    file.slice[static_cast<std::size_t>(i)].feature.assign(value.begin() + 1, value.end());
  }
  const double kind = how.size() > 1 ? how[1] : 0;
  if (kind != 0 && kind != 1 && kind != 2) lines.lines().fail_whole("the kind of waves is not 0, 1 or 2");
  if (kind == 0) return file;
  const auto waves = lines.count(lines.numbers(1, "the number of waves")[0], most_waves, "the number of waves");
  for (std::int64_t i = 0; i < waves; ++i) {
    const auto v = lines.numbers(3, "amplitude, wavelength or order, phase");
    if (!(v[1] > 0)) lines.lines().fail_here("a wavelength or order is not > 0");
    file.wave.push_back({v[0], kind == 2 ? turn / v[1] : v[1], v[2]});
  }
  return file;
}

}  // namespace rollcon
