#include "geometry/profile_slices.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "support/error.hpp"

namespace rollcon {
namespace {

/// Holds cubic Hermite functions of both ends, with slopes by the interval's own length, and two derivatives.
struct Hermite {
  std::array<double, 4> f, d, dd;  ///< value at the start, slope at the start, value at the end, slope at the end

  Hermite(double t, double width) {
    const double r = 1 - t, w = width;
    f = {r * r * (1 + 2 * t), w * t * r * r, t * t * (3 - 2 * t), -w * t * t * r};
    d = {-6 * t * r / w, r * (1 - 3 * t), 6 * t * r / w, t * (3 * t - 2)};
    dd = {(12 * t - 6) / (w * w), (6 * t - 4) / w, (6 - 12 * t) / (w * w), (6 * t - 2) / w};
  }
};

/// Finds slopes of a cubic spline through values at places, whose third derivative is continuous at the last places but
/// one; a parabola leads through three, a line through two.
class SplineSlopes {
 public:
  explicit SplineSlopes(const std::vector<double>& u) : n_(u.size()), h_(n_ - 1), low_(n_), middle_(n_), high_(n_) {
    for (std::size_t i = 0; i + 1 < n_; ++i) h_[i] = u[i + 1] - u[i];
    if (n_ < 4) return;
    for (std::size_t i = 1; i + 1 < n_; ++i) {
      low_[i] = h_[i];
      middle_[i] = 2 * (h_[i - 1] + h_[i]);
      high_[i] = h_[i - 1];
    }
    middle_[0] = h_[1];
    high_[0] = h_[0] + h_[1];
    middle_[n_ - 1] = h_[n_ - 3];
    low_[n_ - 1] = h_[n_ - 2] + h_[n_ - 3];
    for (std::size_t i = 1; i < n_; ++i) {
      low_[i] /= middle_[i - 1];
      middle_[i] -= low_[i] * high_[i - 1];
    }
  }
  /// Takes get(i) and calls set(i, slope).
  template <class Get, class Set>
  void find(Get get, Set set) {
    chord_.resize(n_ - 1);
    slope_.resize(n_);
    for (std::size_t i = 0; i + 1 < n_; ++i) chord_[i] = (get(i + 1) - get(i)) / h_[i];
    if (n_ == 2) {
      slope_ = {chord_[0], chord_[0]};
    } else if (n_ == 3) {
      const double bend = (chord_[1] - chord_[0]) / (h_[0] + h_[1]);
      slope_ = {chord_[0] - bend * h_[0], chord_[0] + bend * h_[0], chord_[1] + bend * h_[1]};
    } else {
      const auto end = [](double h, double next, double chord, double after) {
        return ((h + 2 * (h + next)) * next * chord + h * h * after) / (h + next);
      };
      slope_[0] = end(h_[0], h_[1], chord_[0], chord_[1]);
      slope_[n_ - 1] = end(h_[n_ - 2], h_[n_ - 3], chord_[n_ - 2], chord_[n_ - 3]);
      for (std::size_t i = 1; i + 1 < n_; ++i) slope_[i] = 3 * (h_[i] * chord_[i - 1] + h_[i - 1] * chord_[i]);
      for (std::size_t i = 1; i < n_; ++i) slope_[i] -= low_[i] * slope_[i - 1];
      slope_[n_ - 1] /= middle_[n_ - 1];
      for (std::size_t i = n_ - 1; i-- > 0;) slope_[i] = (slope_[i] - high_[i] * slope_[i + 1]) / middle_[i];
    }
    for (std::size_t i = 0; i < n_; ++i) set(i, slope_[i]);
  }

 private:
  std::size_t n_;
  std::vector<double> h_, low_, middle_, high_, chord_, slope_;
};

double feature_of(const ProfileSlice& slice, std::size_t i) {
  return std::min(slice.feature[i], slice.curve->length());
}

bool has(const ProfileSlice& slice, std::size_t i) {
  return slice.feature[i] >= 0;
}

/// Returns fractions of arc length at equal distances, the nearest of which is moved to each place where a curvature
/// jumps: cubics cannot follow a jump between their ends.
std::vector<double> columns_for(const std::vector<ProfileSlice>& rows, std::size_t a, std::size_t b,
                                std::size_t parts) {
  constexpr double least_turn = 1e-5;
  std::vector<double> fraction(parts + 1);
  std::vector<bool> moved(parts + 1, false);
  const auto count = static_cast<double>(parts);
  for (std::size_t j = 0; j <= parts; ++j) fraction[j] = static_cast<double>(j) / count;
  const ProfileCurve* before = nullptr;
  for (const ProfileSlice& s : rows) {
    const double from = feature_of(s, a), length = feature_of(s, b) - from;
    if (s.curve.get() == before || !(length > 0)) continue;
    before = s.curve.get();
    for (std::size_t i = 1; i < before->pieces().size(); ++i) {
      const double place = (before->start(i) - from) / length;
      const double bend = before->at(i, 0).curvature() - before->at(i - 1, before->pieces()[i - 1].length).curvature();
      if (!(place > 0 && place < 1) || std::abs(bend) * length / count < least_turn) continue;
      const auto j = static_cast<std::size_t>(std::lround(place * count));
      if (j == 0 || j == parts || moved[j]) continue;
      fraction[j] = place;
      moved[j] = true;
    }
  }
  return fraction;
}

}  // namespace

ProfileSlices::ProfileSlices(std::vector<ProfileSlice> slice, std::vector<ProfileWave> wave, bool smooth, double period)
    : slice_(std::move(slice)), wave_(std::move(wave)), smooth_(smooth), period_(period) {
  std::sort(slice_.begin(), slice_.end(), [](const auto& a, const auto& b) { return a.u < b.u; });
  constexpr double parts_of_length = 300;
  std::vector<ProfileSlice> all = slice_;
  for (ProfileSlice& s : all) {
    if (s.feature.empty()) s.feature = {0, s.curve->length()};
    spacing_ = std::max(spacing_, s.curve->length() / parts_of_length);
  }
  for (std::size_t i = 1; i < all.size(); ++i) {
    if (!(all[i].u > all[i - 1].u)) fail(Status::err_argument, "two slices are at u = %g; allowed: one", all[i].u);
    if (all[i].feature.size() != all[0].feature.size())
      fail(Status::err_argument, "the slice at u = %g has %d features, the one at %g %d; allowed: as many, -1: missing",
           all[i].u, static_cast<int>(all[i].feature.size()), all[0].u, static_cast<int>(all[0].feature.size()));
  }
  if (period_ > 0 && all.size() > 1) {
    if (!(all.back().u - all.front().u < period_))
      fail(Status::err_argument, "slices are at u = %g and %g; allowed: within one turn, 2 pi", all.front().u,
           all.back().u);
    // A spline forgets what is so many slices away.
    constexpr std::size_t most = 12;
    const std::size_t n = all.size(), more = std::min(n, most);
    std::vector<ProfileSlice> round;
    for (std::size_t i = n - more; i < n; ++i) {
      round.push_back(all[i]);
      round.back().u -= period_;
    }
    round.insert(round.end(), all.begin(), all.end());
    for (std::size_t i = 0; i < more; ++i) {
      round.push_back(all[i]);
      round.back().u += period_;
    }
    all = std::move(round);
  }
  const std::size_t features = all[0].feature.size();
  for (std::size_t a = 0; a < features; ++a)
    for (std::size_t b = a + 1; b < features; ++b) add_sheets(all, a, b);
  if (sheet_.empty())
    fail(Status::err_argument, "no two neighbouring slices have two features in common; allowed: two or more");
}

// Cuts rows of slices in which both features follow each other, in each two neighbours' common features.
void ProfileSlices::add_sheets(const std::vector<ProfileSlice>& all, std::size_t a, std::size_t b) {
  const std::size_t n = all.size();
  if (n == 1) {
    bool between = false;
    for (std::size_t i = a + 1; i < b; ++i) between = between || has(all[0], i);
    if (has(all[0], a) && has(all[0], b) && !between) add_sheet({all[0], all[0]}, a, b, true, true);
    return;
  }
  const auto joined = [&](std::size_t k) {
    const auto common = [&](std::size_t i) { return has(all[k], i) && has(all[k + 1], i); };
    bool between = false;
    for (std::size_t i = a + 1; i < b; ++i) between = between || common(i);
    return common(a) && common(b) && !between;
  };
  for (std::size_t k = 0; k + 1 < n; ++k) {
    if (!joined(k)) continue;
    const std::size_t from = k;
    while (k + 1 < n && joined(k)) ++k;
    add_sheet({all.begin() + static_cast<std::ptrdiff_t>(from), all.begin() + static_cast<std::ptrdiff_t>(k) + 1}, a, b,
              from == 0, k + 1 == n);
  }
}

void ProfileSlices::add_sheet(const std::vector<ProfileSlice>& rows, std::size_t a, std::size_t b, bool begins,
                              bool ends) {
  Sheet sheet;
  sheet.begins = begins;
  sheet.ends = ends;
  double longest = 0;
  for (const ProfileSlice& s : rows) {
    const double length = feature_of(s, b) - feature_of(s, a);
    if (!(length >= 0))
      fail(Status::err_argument, "features %d and %d of the slice at u = %g are at %g and %g; allowed: ascending",
           static_cast<int>(a), static_cast<int>(b), s.u, s.feature[a], s.feature[b]);
    longest = std::max(longest, length);
    sheet.u.push_back(s.u);
  }
  if (!(longest > 0)) return;
  if (sheet.u.size() == 2 && sheet.u[0] == sheet.u[1]) sheet.u[1] += longest;  // one slice serves everywhere
  constexpr double least = 4;
  const double parts = std::max(least, std::ceil(longest / spacing_));
  sheet.columns = static_cast<std::size_t>(parts) + 1;
  sheet.fraction = columns_for(rows, a, b, static_cast<std::size_t>(parts));
  sheet.node.resize(sheet.u.size() * sheet.columns);
  const auto node = [&](std::size_t k, std::size_t j) -> Node& { return sheet.node[k * sheet.columns + j]; };
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const double from = feature_of(rows[k], a), length = feature_of(rows[k], b) - from;
    for (std::size_t j = 0; j < sheet.columns; ++j) {
      const ProfilePoint p = rows[k].curve->at(std::min(from + sheet.fraction[j] * length, rows[k].curve->length()));
      node(k, j).x = p.x;
      node(k, j).f = length * p.tangent();
    }
  }
  if (smooth_) {
    const std::vector<Node> given = sheet.node;
    for (std::size_t k = 1; k + 1 < rows.size(); ++k)
      for (std::size_t j = 0; j < sheet.columns; ++j) {
        const double t = (sheet.u[k] - sheet.u[k - 1]) / (sheet.u[k + 1] - sheet.u[k - 1]);
        const Node &before = given[(k - 1) * sheet.columns + j], &after = given[(k + 1) * sheet.columns + j];
        const auto nearer = [&](const Vec2& own, const Vec2& left, const Vec2& right) {
          return (2.0 / 3) * own + (1.0 / 3) * ((1 - t) * left + t * right);
        };
        node(k, j).x = nearer(node(k, j).x, before.x, after.x);
        node(k, j).f = nearer(node(k, j).f, before.f, after.f);
      }
  }
  SplineSlopes slopes(sheet.u);
  for (std::size_t j = 0; j < sheet.columns; ++j)
    for (std::size_t c = 0; c < 2; ++c) {
      slopes.find([&](std::size_t k) { return node(k, j).x[c]; },
                  [&](std::size_t k, double slope) { node(k, j).u[c] = slope; });
      slopes.find([&](std::size_t k) { return node(k, j).f[c]; },
                  [&](std::size_t k, double slope) { node(k, j).uf[c] = slope; });
    }
  sheet_.push_back(std::move(sheet));
}

double ProfileSlices::within(double u) const {
  if (!(period_ > 0)) return u;
  const double from = slice_.front().u;
  return u - period_ * std::floor((u - from) / period_);
}

double ProfileSlices::most_wave() const {
  double most = 0;
  for (const ProfileWave& w : wave_) most += std::abs(w.amplitude);
  return most;
}

SlicePoint ProfileSlices::at(std::size_t sheet, double u, double v) const {
  const Sheet& s = sheet_[sheet];
  const double place = std::clamp(u, s.u.front(), s.u.back());
  const auto after = std::upper_bound(s.u.begin() + 1, s.u.end() - 1, place);
  const auto k = static_cast<std::size_t>(after - s.u.begin()) - 1;
  const double width = s.u[k + 1] - s.u[k];
  const auto j = static_cast<std::size_t>(std::clamp(std::floor(v), 0.0, s.last() - 1));
  const double column = s.fraction[j + 1] - s.fraction[j];
  const Hermite hu((place - s.u[k]) / width, width), hv(v - static_cast<double>(j), column);
  SlicePoint p;
  for (std::size_t a = 0; a < 2; ++a)
    for (std::size_t b = 0; b < 2; ++b) {
      const Node& n = s.node[(k + a) * s.columns + j + b];
      const std::size_t i = 2 * a, m = 2 * b;
      const auto add = [&](Vec2& to, const std::array<double, 4>& fu, const std::array<double, 4>& fv) {
        const double x = fu[i] * fv[m], du = fu[i + 1] * fv[m], dv = fu[i] * fv[m + 1], duv = fu[i + 1] * fv[m + 1];
        for (std::size_t c = 0; c < 2; ++c) to[c] += x * n.x[c] + du * n.u[c] + dv * n.f[c] + duv * n.uf[c];
      };
      add(p.x, hu.f, hv.f);
      add(p.u, hu.d, hv.f);
      add(p.v, hu.f, hv.d);
      add(p.uu, hu.dd, hv.f);
      add(p.uv, hu.d, hv.d);
      add(p.vv, hu.f, hv.dd);
    }
  for (std::size_t c = 0; c < 2; ++c) {  // by the column instead of the fraction
    p.v[c] *= column;
    p.uv[c] *= column;
    p.vv[c] *= column * column;
  }
  if (place != u) p.u = p.uu = p.uv = {0, 0};
  for (const ProfileWave& w : wave_) {
    const double rate = 2 * std::numbers::pi / w.length, turn = rate * u + w.phase;
    const double height = w.amplitude * std::sin(turn);
    p.x[1] += height;
    p.u[1] += rate * w.amplitude * std::cos(turn);
    p.uu[1] -= rate * rate * height;
  }
  return p;
}

}  // namespace rollcon
