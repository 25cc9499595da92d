#include "geometry/profile_fit.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "support/error.hpp"

namespace rollcon {
namespace {

struct NamedPoint {
  Vec2 x;
  std::size_t number;  ///< the caller's number of the point
};

void require_points(const std::vector<Vec2>& point, const PointName& name) {
  constexpr double most = 1e30;
  if (point.size() < 2)
    fail(Status::err_argument, "the profile has %d point(s); allowed: 2 or more", static_cast<int>(point.size()));
  for (std::size_t i = 0; i < point.size(); ++i)
    for (std::size_t c = 0; c < 2; ++c)
      if (!(std::abs(point[i][c]) <= most))
        fail(Status::err_argument, "%c of %s is %g; allowed: -%g to %g", "yz"[c], name(i).c_str(), point[i][c], most,
             most);
}

std::vector<NamedPoint> without_close_ones(const std::vector<Vec2>& point) {
  constexpr double close = 1e-3;  // fraction of the usual distance
  std::vector<double> distance;
  for (std::size_t i = 1; i < point.size(); ++i)
    if (const double d = length(point[i] - point[i - 1]); d > 0) distance.push_back(d);
  if (distance.empty())
    fail(Status::err_argument, "all %d points of the profile are one", static_cast<int>(point.size()));
  std::nth_element(distance.begin(), distance.begin() + static_cast<std::ptrdiff_t>(distance.size() / 2),
                   distance.end());
  const double least = close * distance[distance.size() / 2];
  std::vector<NamedPoint> kept{{point.front(), 0}};
  for (std::size_t i = 1; i < point.size(); ++i)
    if (length(point[i] - kept.back().x) > least) kept.push_back({point[i], i});
  // The end points stay where they are.
  if (kept.size() > 1) kept.back() = {point.back(), point.size() - 1};
  if (kept.size() < 2) kept.push_back({point.back(), point.size() - 1});
  return kept;
}

/// Returns the angle by which the path turns at a point, positive from y to z.
double turn(const Vec2& before, const Vec2& x, const Vec2& after) {
  return std::atan2(cross(x - before, after - x), dot(x - before, after - x));
}

constexpr double degree = std::numbers::pi / 180;

/// Replaces by means the points where the path goes forth, back and forth again, because it was measured so or joined
/// from two measurements. The outermost of many points may be wrong. Returns how many were replaced.
std::int64_t straighten_zigzags(std::vector<NamedPoint>& point, double zigzag_angle, const PointName& name,
                                std::string& told) {
  constexpr std::size_t enough = 10;
  constexpr double right_angle = std::numbers::pi / 2;
  const double least = zigzag_angle * degree;
  const auto turn_at = [&](std::size_t i) { return turn(point[i - 1].x, point[i].x, point[i + 1].x); };
  const std::size_t all = point.size(), most = 1 + all / 5;
  std::size_t mended = 0;
  for (std::size_t i = 1; i + 1 < point.size();) {
    const bool first = i == 1, last = i + 2 == point.size();
    const double here = turn_at(i), next = last ? 0 : turn_at(i + 1), less = std::min(std::abs(here), std::abs(next));
    // Turns beyond a right angle may have either sign where the path goes straight back.
    if (!(less > least && (less > right_angle || here * next < 0))) {
      if (std::abs(here) <= std::max(least, right_angle)) {
        ++i;
        continue;
      }
      if ((first || last) && all >= enough) {
        told += "the profile turns back at its end: " + name(point[first ? 0 : i + 1].number) + " is left out; ";
        point.erase(first ? point.begin() : point.end() - 1);
        continue;
      }
      fail(
          Status::err_argument,
          "the profile turns back at %s, y %g, z %g; allowed: points in the order of the path, whose direction changes "
          "by less than %g degrees from point to point",
          name(point[i].number).c_str(), point[i].x[0], point[i].x[1], std::max(zigzag_angle, 90.0));
    }
    if (++mended > most)
      fail(Status::err_argument,
           "the profile goes back and forth more than %d times, again at %s: its points are not in the order of the "
           "path",
           static_cast<int>(most), name(point[i].number).c_str());
    point[i].x = 0.5 * (point[i].x + point[i + 1].x);
    point.erase(point.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    if (i > 1) --i;
  }
  return static_cast<std::int64_t>(mended);
}

/// Replaces points by means of neighbours over a fraction of the filter's length, where points are closer than their
/// noise and the path goes to and fro.
std::vector<NamedPoint> means_over(const std::vector<NamedPoint>& point, double reach) {
  std::vector<NamedPoint> mean{point.front()};
  for (std::size_t i = 1; i + 1 < point.size();) {
    const NamedPoint& first = point[i];
    Vec2 sum{0, 0};
    double n = 0;
    for (; i + 1 < point.size() && (n == 0 || length(point[i].x - first.x) < reach); ++i, ++n) sum = sum + point[i].x;
    mean.push_back({(1 / n) * sum, first.number});
  }
  mean.push_back(point.back());
  return mean;
}

double path_of(const std::vector<NamedPoint>& point) {
  double path = 0;
  for (std::size_t i = 1; i < point.size(); ++i) path += length(point[i].x - point[i - 1].x);
  return path;
}

/// Brings points into the order of the path. Where there is a filter, and noise makes the path longer than that of
/// means, the means stand for the points, because the filter would take the way to and fro for length.
std::vector<NamedPoint> along_the_path(std::vector<NamedPoint> point, const ProfileFit& fit, const PointName& name,
                                       std::string& told, FitReport& report) {
  constexpr double part = 1.0 / 24, longer = 1.01;
  if (fit.filter_length > 0) {
    std::vector<NamedPoint> mean = means_over(point, part * fit.filter_length);
    if (path_of(point) > longer * path_of(mean)) point = std::move(mean);
  }
  report.zigzags = straighten_zigzags(point, fit.zigzag_angle, name, told);
  return point;
}

/// Returns the direction of the line that fits some points best; it goes from the first to the last.
Vec2 direction_of(const Vec2* first, std::ptrdiff_t n) {
  Vec2 mean{0, 0};
  for (std::ptrdiff_t i = 0; i < n; ++i) mean = mean + (1.0 / static_cast<double>(n)) * first[i];
  double yy = 0, yz = 0, zz = 0;
  for (std::ptrdiff_t i = 0; i < n; ++i) {
    const Vec2 off = first[i] - mean;
    yy += off[0] * off[0];
    yz += off[0] * off[1];
    zz += off[1] * off[1];
  }
  const double angle = 0.5 * std::atan2(2 * yz, yy - zz);
  const Vec2 along{std::cos(angle), std::sin(angle)};
  return dot(along, first[n - 1] - first[0]) < 0 ? -1.0 * along : along;
}

/// Says whether the curve turns at a point by as much as lines say that fit what is within reach on both sides; noise
/// does not make it turn so. Fewer than four points tell nothing.
bool turns_by(const std::vector<Vec2>& x, std::size_t k, double reach, double least) {
  constexpr std::ptrdiff_t few = 4;
  const auto n = static_cast<std::ptrdiff_t>(x.size()), at = static_cast<std::ptrdiff_t>(k);
  std::ptrdiff_t from = at, to = at;
  while (from > 0 && length(x[static_cast<std::size_t>(from - 1)] - x[k]) <= reach) --from;
  while (to + 1 < n && length(x[static_cast<std::size_t>(to + 1)] - x[k]) <= reach) ++to;
  if (at - from + 1 < few || to - at + 1 < few) return true;
  const Vec2 before = direction_of(&x[static_cast<std::size_t>(from)], at - from + 1),
             after = direction_of(&x[k], to - at + 1);
  return std::abs(std::atan2(cross(before, after), dot(before, after))) >= least;
}

/// Returns the points at which the curve turns by far more than beside them, in points to be filtered also by what
/// lines over a fourth of that length say.
std::vector<std::size_t> kinks_of(const std::vector<Vec2>& x, const ProfileFit& fit) {
  constexpr double part = 0.25, nearly = 0.8, rounding = 1e-9;
  const double least = fit.kink_angle * degree, others = fit.kink_beside + rounding;
  std::vector<double> angle(x.size(), 0);
  for (std::size_t i = 1; i + 1 < x.size(); ++i) angle[i] = std::abs(turn(x[i - 1], x[i], x[i + 1]));
  std::vector<std::size_t> found;
  for (std::size_t i = 1; i + 1 < x.size(); ++i)
    if (angle[i] >= least && angle[i - 1] <= others * angle[i] && angle[i + 1] <= others * angle[i] &&
        turns_by(x, i, part * fit.filter_length, nearly * least))
      found.push_back(i);
  return found;
}

/// Returns the second derivatives at the knots of the spline that has the given first derivatives at its ends; null
/// stands for a third derivative continuous at the last knot but one.
std::vector<double> second_derivatives(const std::vector<double>& h, const std::vector<double>& y, const double* begin,
                                       const double* end) {
  const std::size_t n = y.size();
  const auto slope = [&](std::size_t i) { return (y[i + 1] - y[i]) / h[i]; };
  struct Row {
    double low, middle, high;
  };
  std::vector<Row> row(n);
  std::vector<double> m(n);
  const double bent = begin ? slope(0) - *begin : 0, bent_last = end ? *end - slope(n - 2) : 0;
  if (n == 2 && begin && end) return {(4 * bent - 2 * bent_last) / h[0], (4 * bent_last - 2 * bent) / h[0]};
  if (n == 2) return std::vector<double>(2, 2 * (bent + bent_last) / h[0]);
  if (n == 3 && !begin && !end) std::fill(m.begin(), m.end(), 2 * (slope(1) - slope(0)) / (h[0] + h[1]));
  if (n == 3 && !begin && !end) return m;
  for (std::size_t i = 1; i + 1 < n; ++i) {
    row[i] = {h[i - 1], 2 * (h[i - 1] + h[i]), h[i]};
    m[i] = 6 * (slope(i) - slope(i - 1));
  }
  const double first = begin || n == 3 ? 0 : h[0] / h[1], last = end || n == 3 ? 0 : h[n - 2] / h[n - 3];
  row[1].middle += begin ? -h[0] / 2 : h[0] * (1 + first);
  row[1].high -= h[0] * first;
  m[1] -= 3 * bent;
  row[n - 2].middle += end ? -h[n - 2] / 2 : h[n - 2] * (1 + last);
  row[n - 2].low -= h[n - 2] * last;
  m[n - 2] -= 3 * bent_last;
  for (std::size_t i = 2; i + 1 < n; ++i) {
    const double factor = row[i].low / row[i - 1].middle;
    row[i].middle -= factor * row[i - 1].high;
    m[i] -= factor * m[i - 1];
  }
  m[n - 2] /= row[n - 2].middle;
  for (std::size_t i = n - 2; i-- > 1;) m[i] = (m[i] - row[i].high * m[i + 1]) / row[i].middle;
  m[0] = begin ? 3 * bent / h[0] - m[1] / 2 : m[1] + first * (m[1] - m[2]);
  m[n - 1] = end ? 3 * bent_last / h[n - 2] - m[n - 2] / 2 : m[n - 2] + last * (m[n - 2] - m[n - 3]);
  return m;
}

/// Solves with a symmetric positive definite matrix whose row i has a[i][k] at column i + k.
using Band = std::array<double, 4>;
void solve_band(std::vector<Band>& a, std::vector<Vec2>& b) {
  const std::size_t n = a.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 1; k < 4 && i + k < n; ++k) {
      const double factor = a[i][k] / a[i][0];
      for (std::size_t j = k; j < 4; ++j) a[i + k][j - k] -= factor * a[i][j];
      b[i + k] = b[i + k] - factor * b[i];
    }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t k = 1; k < 4 && i + k < n; ++k) b[i] = b[i] - a[i][k] * b[i + k];
    b[i] = (1 / a[i][0]) * b[i];
  }
}

}  // namespace

void smooth_points(std::vector<Vec2>& point, const ProfileFit& fit) {
  const std::size_t n = point.size(), order = static_cast<std::size_t>(fit.filter_order);
  if (n < 5 || !(fit.filter_length > 0)) return;
  std::vector<double> s(n, 0), weight(n, 0);
  for (std::size_t i = 1; i < n; ++i) {
    const double h = length(point[i] - point[i - 1]);
    s[i] = s[i - 1] + h;
    weight[i - 1] += h / 2;
    weight[i] += h / 2;
  }
  if (fit.points_alike) std::fill(weight.begin(), weight.end(), s.back() / static_cast<double>(n - 1));
  // Lengths are scaled by the filter's, which keeps the numbers moderate.
  const double unit = fit.filter_length / (2 * std::numbers::pi);
  for (std::size_t i = 0; i < n; ++i) {
    s[i] /= unit;
    weight[i] /= unit;
  }
  // Derivatives of order m are m! times the divided differences of m + 1 points each.
  const std::size_t rows = n - order;
  std::vector<Band> derivative(rows, Band{});
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t k = 0; k <= order; ++k) {
      double product = 1;
      for (std::size_t j = 0; j <= order; ++j)
        if (j != k) product *= s[i + k] - s[i + j];
      derivative[i][k] = (order == 3 ? 6 : 2) / product;
    }
  // The system is (D W^-1 D' + G^-1) v = D x, then x - W^-1 D' v; G holds the length of curve for which a derivative
  // stands.
  std::vector<Band> matrix(rows, Band{});
  std::vector<Vec2> v(rows, Vec2{0, 0});
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t k = 0; k <= order && i + k < rows; ++k)
      for (std::size_t j = k; j <= order; ++j)
        matrix[i][k] += derivative[i][j] * derivative[i + k][j - k] / weight[i + j];
    matrix[i][0] += static_cast<double>(order) / (s[i + order] - s[i]);
    for (std::size_t j = 0; j <= order; ++j) v[i] = v[i] + derivative[i][j] * point[i + j];
  }
  solve_band(matrix, v);
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t j = 0; j <= order; ++j) point[i + j] = point[i + j] - derivative[i][j] / weight[i + j] * v[i];
}

std::vector<ProfilePiece> spline_through(const std::vector<Vec2>& x, const Vec2* begin, const Vec2* end) {
  const std::size_t n = x.size();
  std::vector<double> h(n - 1), y(n);
  for (std::size_t i = 0; i + 1 < n; ++i) h[i] = length(x[i + 1] - x[i]);
  std::vector<ProfilePiece> piece(n - 1);
  // Each round takes the lengths of the pieces from the round before; four are as good as any number of them.
  for (int round = 0; round < 5; ++round) {
    for (std::size_t c = 0; c < 2; ++c) {
      for (std::size_t i = 0; i < n; ++i) y[i] = x[i][c];
      const std::vector<double> m =
          second_derivatives(h, y, begin ? &(*begin)[c] : nullptr, end ? &(*end)[c] : nullptr);
      for (std::size_t i = 0; i + 1 < n; ++i) {
        ProfilePiece& p = piece[i];
        p.length = h[i];
        p.start[c] = y[i];
        p.along[c] = (y[i + 1] - y[i]) / h[i] - h[i] * (2 * m[i] + m[i + 1]) / 6;
        p.square[c] = m[i] / 2;
        p.cube[c] = (m[i + 1] - m[i]) / (6 * h[i]);
      }
    }
    const ProfileCurve curve(piece);
    for (std::size_t i = 0; i + 1 < n; ++i) h[i] = curve.start(i + 1) - curve.start(i);
  }
  return piece;
}

namespace {

/// Lays a spline through each run of points whose distances do not jump. The coarser of two runs that meet takes the
/// finer one's direction there: a continuous curvature would carry a long chord far away.
std::vector<ProfilePiece> splines_of_runs(const std::vector<Vec2>& x, int& jumps) {
  constexpr double jump = 5;
  const auto chord = [&](std::size_t i) { return length(x[i + 1] - x[i]); };
  std::vector<std::size_t> joint{0};
  for (std::size_t i = 1; i + 1 < x.size(); ++i)
    if (std::max(chord(i - 1), chord(i)) > jump * std::min(chord(i - 1), chord(i))) joint.push_back(i);
  jumps += static_cast<int>(joint.size()) - 1;
  joint.push_back(x.size() - 1);
  const std::size_t runs = joint.size() - 1;
  std::vector<std::vector<ProfilePiece>> run(runs);
  // A finer run takes nothing from a coarser one: runs that wait for none on their right come first, from the left.
  for (const bool waits : {false, true})
    for (std::size_t k = 0; k < runs; ++k) {
      const std::size_t r = waits ? runs - 1 - k : k, from = joint[r], to = joint[r + 1];
      const bool left = r > 0 && chord(from - 1) < chord(from), right = r + 1 < runs && chord(to) < chord(to - 1);
      if (right != waits) continue;
      const auto tangent = [](const ProfilePiece& p, double u) { return ProfileCurve({p}).at(0, u).tangent(); };
      const Vec2 begin = left ? tangent(run[r - 1].back(), run[r - 1].back().length) : Vec2{};
      const Vec2 end = right ? tangent(run[r + 1].front(), 0) : Vec2{};
      run[r] = spline_through(
          {x.begin() + static_cast<std::ptrdiff_t>(from), x.begin() + static_cast<std::ptrdiff_t>(to) + 1},
          left ? &begin : nullptr, right ? &end : nullptr);
    }
  std::vector<ProfilePiece> all;
  for (const std::vector<ProfilePiece>& r : run) all.insert(all.end(), r.begin(), r.end());
  return all;
}

/// Returns how far pieces leave their chords.
double farthest(const ProfileCurve& curve) {
  double far = 0;
  for (std::size_t i = 0; i < curve.pieces().size(); ++i) {
    const double whole = curve.pieces()[i].length;
    const Vec2 from = curve.at(i, 0).x, chord = curve.at(i, whole).x - from;
    for (const double part : {0.25, 0.5, 0.75})
      far = std::max(far, std::abs(cross(chord, curve.at(i, part * whole).x - from)) / length(chord));
  }
  return far;
}

/// Tells what the filter did to a part of a profile: to its points, and to curvatures if it is applied once more.
void tell_of_filter(const std::vector<Vec2>& raw, const std::vector<Vec2>& smooth,
                    const std::vector<ProfilePiece>& piece, const ProfileFit& fit, FitReport& report) {
  FitReport here;
  for (std::size_t i = 0; i < raw.size(); ++i) here.moved = std::max(here.moved, length(smooth[i] - raw[i]));
  std::vector<Vec2> again = smooth;
  smooth_points(again, fit);
  int jumps = 0;
  const ProfileCurve once(piece), twice(splines_of_runs(again, jumps));
  for (std::size_t i = 0; i < piece.size(); ++i) {
    const double change = std::abs(twice.at(i, 0).curvature() - once.at(i, 0).curvature());
    if (change > here.curvature) here.curvature = change, here.y = smooth[i][0];
  }
  report.add(here);
}

}  // namespace

void FitReport::add(const FitReport& other) {
  kinks += other.kinks;
  zigzags += other.zigzags;
  moved = std::max(moved, other.moved);
  if (other.curvature > curvature) curvature = other.curvature, y = other.y;
}

ProfileCurve profile_through(const std::vector<Vec2>& point, const ProfileFit& fit, const PointName& name,
                             std::string* told, FitReport* report) {
  std::string unheard, &words = told ? *told : unheard;
  FitReport unread, &found = report ? *report : unread;
  found = {};
  require_points(point, name);
  const std::vector<NamedPoint> kept = along_the_path(without_close_ones(point), fit, name, words, found);
  std::vector<Vec2> x;
  for (const NamedPoint& p : kept) x.push_back(p.x);
  if (x.back()[0] < x.front()[0]) std::reverse(x.begin(), x.end());
  const double path = path_of(kept);
  if (!(fit.filter_length >= 0 && fit.filter_length <= path))
    fail(Status::err_argument, "filter_length is %g; allowed: 0 to the length of the profile, %g", fit.filter_length,
         path);

  std::vector<std::size_t> ends = kinks_of(x, fit);
  found.kinks = std::ssize(ends);
  ends.push_back(x.size() - 1);
  std::vector<ProfilePiece> piece;
  std::size_t from = 0;
  int jumps = 0;
  Vec2 joint = x.front();
  for (const std::size_t to : ends) {
    std::vector<Vec2> part(x.begin() + static_cast<std::ptrdiff_t>(from),
                           x.begin() + static_cast<std::ptrdiff_t>(to) + 1);
    const std::vector<Vec2> raw = part;
    smooth_points(part, fit);
    // Smoothing moves the two curves that meet in a kink by different amounts, so the second goes on from where the
    // first ends.
    if (from > 0) part.front() = joint;
    joint = part.back();
    const std::vector<ProfilePiece> more = splines_of_runs(part, jumps);
    piece.insert(piece.end(), more.begin(), more.end());
    if (fit.filter_length > 0) tell_of_filter(raw, part, more, fit, found);
    from = to;
  }
  ProfileCurve curve(std::move(piece));
  if (jumps > 0) {
    char text[200];
    std::snprintf(
        text, sizeof text,
        "the distances of the profile's points jump fivefold and more at %d place(s), where its curvature may "
        "jump; the curve leaves their chords by up to %.3g; ",
        jumps, farthest(curve));
    words += text;
  }
  return curve;
}

}  // namespace rollcon
