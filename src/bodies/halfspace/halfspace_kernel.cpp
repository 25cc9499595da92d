#include "bodies/halfspace/halfspace_kernel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "bodies/halfspace/lag_rule.hpp"
#include "bodies/halfspace/lattice_kernel.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

using namespace halfspace;

int terms_of(const HalfspaceConstants& c) {
  return (c.cv != 0 ? with_shear : 0) + (c.ck != 0 ? with_coupling : 0);
}

/// Returns the terms that displacements wanted are made of.
int terms_for(double* const (&u)[3][3]) {
  const bool tangential = u[0][0] || u[0][1] || u[1][0] || u[1][1];
  const bool mixed = u[0][2] || u[1][2] || u[2][0] || u[2][1];
  return (tangential ? with_shear : 0) + (mixed ? with_coupling : 0);
}

/// Holds the five integrals along a line, zero at first.
struct LineIntegrals {
  std::vector<double> memory;
  double* integral[integral_count];
  explicit LineIntegrals(std::size_t n) : memory(integral_count * n, 0.0) {
    for (std::size_t k = 0; k < integral_count; ++k) integral[k] = memory.data() + k * n;
  }
};

/// Writes, or adds, the displacements that n integrals and a body's constants make.
void displacements(const HalfspaceConstants& of, const LineIntegrals& line, std::size_t n, double* const (&u)[3][3],
                   bool add) {
  const double *i0 = line.integral[0], *xx = line.integral[1], *xy = line.integral[2];
  const double cn = of.cn, cv = of.cv, ck = of.ck;
  const auto fill = [&](int r, int c, auto value) {
    if (u[r][c] == nullptr) return;
    for (std::size_t m = 0; m < n; ++m) u[r][c][m] = (add ? u[r][c][m] : 0.0) + value(m);
  };
  fill(0, 0, [=](std::size_t m) { return cn * i0[m] + cv * xx[m]; });
  fill(1, 1, [=](std::size_t m) { return cn * i0[m] + cv * (i0[m] - xx[m]); });
  fill(2, 2, [=](std::size_t m) { return cn * i0[m]; });
  for (int t = 0; t < 2; ++t) {
    const double* along = line.integral[3 + t];
    fill(t, 1 - t, [=](std::size_t m) { return cv * xy[m]; });
    fill(t, 2, [=](std::size_t m) { return ck * along[m]; });
    fill(2, t, [=](std::size_t m) { return -ck * along[m]; });
  }
}

class HalfspaceRows final : public LatticeRows {
 public:
  HalfspaceRows(HalfspaceConstants c, const LatticeHat& source, double shift_x, double shift_y, OffsetReach reach)
      : c_(c), integrals_(source, shift_x, shift_y, terms_of(c), reach) {}

  void row(std::int64_t j, std::int64_t first, std::int64_t count, double* const (&u)[3][3]) const override {
    LineIntegrals line(at(count));
    integrals_.row(j, first, count, line.integral, terms_for(u));
    displacements(c_, line, at(count), u, false);
  }

 private:
  HalfspaceConstants c_;
  LatticeIntegrals integrals_;
};

class HalfspaceKernel final : public TranslationKernel {
 public:
  explicit HalfspaceKernel(HalfspaceConstants c) : c_(c) {}
  bool scales() const override { return true; }
  bool couples() const override { return c_.ck != 0; }
  bool shears() const override { return c_.cv != 0; }
  std::unique_ptr<LatticeRows> on_lattice(const LatticeHat& source, double shift_x, double shift_y,
                                          OffsetReach reach) const override {
    return std::make_unique<HalfspaceRows>(c_, source, shift_x, shift_y, reach);
  }
  Softness softness(double k) const override {
    const double unit = 2 * std::numbers::pi / k;
    return {unit * c_.cn, unit * c_.cn, unit * (c_.cn + c_.cv)};
  }
  bool knows_points() const override { return true; }
  PointDisplacements of_point(double dx, double dy) const override {
    const double r2 = dx * dx + dy * dy, r = std::sqrt(r2), normal = c_.cn / r, shear = c_.cv / (r * r2);
    return {normal,          normal + shear * dx * dx, normal + shear * dy * dy,
            shear * dx * dy, c_.ck / r2 * dx,          c_.ck / r2 * dy};
  }

 private:
  HalfspaceConstants c_;
};

/// Filters integrals along the lattice's first axis. The mean of weight exp(-s / L) / L over what lies ahead of a point
/// is that ahead of the next point, times exp(-h / L), and the part between them, by a rule on points there. Observers
/// that are shifted divide a cell in two. Beyond the lattice, panels grow with the distance from the source.
class LaggingRows final : public LatticeRows {
 public:
  LaggingRows(HalfspaceConstants c, const std::vector<LaggingBody>& bodies, int terms, const LatticeHat& source,
              double shift_x, double shift_y, OffsetReach reach);
  void row(std::int64_t j, std::int64_t first, std::int64_t count, double* const (&u)[3][3]) const override;

 private:
  /// Points of a part of a cell or of a panel, with both ends; on lines away from the source every second one will do,
  /// far away every fourth.
  static constexpr std::size_t points = 9, levels = 3;
  static constexpr double away[levels - 1] = {6, 36};  ///< distances of such lines, in cells
  static constexpr double accuracy = 1e-11;
  /// Keeps so much of the mean ahead, and adds values at the points with these weights.
  struct Step {
    double decay = 1;
    std::array<double, points> weight{};
  };
  struct Filter {
    double ratio;
    std::vector<Step> part[levels], panel;
  };
  struct Filtered {
    HalfspaceConstants c;
    std::vector<Filter> filter;
  };
  /// Holds values at the points of the parts of cells, and of panels, for the five integrals.
  struct Samples {
    std::vector<LineIntegrals> part;
    LineIntegrals panel;
  };
  static Step make_step(const Lag& lag, double length, std::size_t n);
  Samples sample(std::int64_t j, std::int64_t low, std::size_t n, int terms) const;
  void filter_line(const Filter& f, int integral, const Samples& from, std::size_t level, std::int64_t count,
                   double* sum) const;
  static std::size_t points_of(std::size_t level) { return 1 + ((points - 1) >> level); }

  HalfspaceConstants c_;
  int terms_;
  std::int64_t shifted_;  ///< whole cells by which observers are shifted
  std::int64_t end_;      ///< offset from which the panels begin
  double cells_across_;   ///< spacing of lines, in cells
  std::vector<double>
      part_;  ///< where parts of cells begin, and the end of the last; observers are at the last but one
  std::vector<double> panel_;  ///< where panels begin, and the end of the last
  LatticeIntegrals here_;
  std::vector<LatticeIntegrals> integrals_;  ///< at the points of parts, without their ends
  std::vector<Filtered> body_;
};

LaggingRows::LaggingRows(HalfspaceConstants c, const std::vector<LaggingBody>& bodies, int terms,
                         const LatticeHat& source, double shift_x, double shift_y, OffsetReach reach)
    : c_(c),
      terms_(terms),
      shifted_(to_index(std::floor(shift_x / source.dx))),
      end_(std::max<std::int64_t>(reach.x + shifted_ + 2, points)),
      cells_across_(source.dy / source.dx),
      here_(source, shift_x, shift_y, terms, reach) {
  const OffsetReach further{end_ + std::abs(shifted_), reach.y};
  const double within = shift_x - static_cast<double>(shifted_) * source.dx;
  part_ = within > 0 ? std::vector{0.0, within, source.dx} : std::vector{0.0, source.dx};
  for (std::size_t k = 0; k + 1 < part_.size(); ++k)
    for (std::size_t q = 0; q + 1 < points; ++q)
      integrals_.emplace_back(source, part_[k] + lag_points(points)[q] * (part_[k + 1] - part_[k]), shift_y, terms,
                              further, accuracy);
  constexpr double forgotten = 45;  // lengths after which nothing is left
  constexpr std::size_t most_panels = 200;
  double longest = 0;
  for (const LaggingBody& body : bodies)
    for (const Lag& lag : body.lag) longest = std::max(longest, lag.length);
  panel_.push_back(static_cast<double>(end_) * source.dx);
  while (panel_.back() - panel_[0] < forgotten * longest && panel_.size() <= most_panels)
    panel_.push_back(2 * panel_.back());
  for (const LaggingBody& body : bodies) {
    body_.push_back({body.c, {}});
    for (const Lag& lag : body.lag) {
      Filter f{lag.ratio, {}, {}};
      for (std::size_t k = 0; k + 1 < part_.size(); ++k)
        for (std::size_t level = 0; level < levels; ++level)
          f.part[level].push_back(make_step(lag, part_[k + 1] - part_[k], points_of(level)));
      for (std::size_t k = 0; k + 1 < panel_.size(); ++k)
        f.panel.push_back(make_step(lag, panel_[k + 1] - panel_[k], points));
      body_.back().filter.push_back(std::move(f));
    }
  }
}

LaggingRows::Step LaggingRows::make_step(const Lag& lag, double length, std::size_t n) {
  Step step;
  const std::span<double> weight(step.weight.data(), n);
  step.decay = std::exp(-length / lag.length);
  lag_weights(length / lag.length, weight);
  if (lag.slope) weigh_slopes(length, weight);
  return step;
}

LaggingRows::Samples LaggingRows::sample(std::int64_t j, std::int64_t low, std::size_t n, int terms) const {
  const std::size_t panels = panel_.size() - 1;
  Samples all{{}, LineIntegrals(std::max<std::size_t>(panels * points, 1))};
  for (std::size_t k = 0; k < integrals_.size(); k += (points - 1) / (n - 1)) {
    all.part.emplace_back(at(end_ - low + 1));
    integrals_[k].row(j, low, end_ - low + 1, all.part.back().integral, terms);
  }
  for (std::size_t k = 0; k < panels; ++k)
    for (std::size_t q = 0; q < points; ++q) {
      double* value[integral_count];
      for (std::size_t i = 0; i < integral_count; ++i) value[i] = all.panel.integral[i] + k * points + q;
      integrals_.front().at_place(panel_[k] + lag_points(points)[q] * (panel_[k + 1] - panel_[k]), j, value, terms);
    }
  return all;
}

/// Adds the filtered integral, times the ratio, for `count` observers from the first sample on.
void LaggingRows::filter_line(const Filter& f, int integral, const Samples& from, std::size_t level, std::int64_t count,
                              double* sum) const {
  double mean = 0;  // the mean of what lies ahead of a point that walks from the last panel to the first observer
  for (std::size_t k = f.panel.size(); k-- > 0;) {
    mean *= f.panel[k].decay;
    for (std::size_t q = 0; q < points; ++q)
      mean += f.panel[k].weight[q] * from.panel.integral[integral][k * points + q];
  }
  const std::vector<Step>& part = f.part[level];
  const std::size_t parts = part.size(), inner = points_of(level) - 1;
  const auto cells = static_cast<std::int64_t>(from.part[0].memory.size() / integral_count) - 1;
  for (std::int64_t m = cells - 1; m >= 0; --m)
    for (std::size_t k = parts; k-- > 0;) {
      const Step& step = part[k];
      mean *= step.decay;
      for (std::size_t q = 0; q < inner; ++q) mean += step.weight[q] * from.part[k * inner + q].integral[integral][m];
      mean += step.weight[inner] * (k + 1 < parts ? from.part[(k + 1) * inner].integral[integral][m]
                                                  : from.part[0].integral[integral][m + 1]);
      if (k + 1 == parts && m < count) sum[m] += f.ratio * mean;
    }
}

void LaggingRows::row(std::int64_t j, std::int64_t first, std::int64_t count, double* const (&u)[3][3]) const {
  LineIntegrals line(at(count));
  const int terms = terms_ & terms_for(u);
  here_.row(j, first, count, line.integral, terms);
  displacements(c_, line, at(count), u, false);
  const double apart = std::abs(static_cast<double>(j)) * cells_across_;
  const auto level = static_cast<std::size_t>(std::upper_bound(away, away + levels - 1, apart) - away);
  const Samples from = sample(j, first + shifted_, points_of(level), terms);
  for (const Filtered& body : body_) {
    LineIntegrals lagging(at(count));
    for (int i = 0; i < integral_count; ++i) {
      if ((terms & integral_terms(i)) != integral_terms(i)) continue;
      for (const Filter& f : body.filter) filter_line(f, i, from, level, count, lagging.integral[i]);
    }
    displacements(body.c, lagging, at(count), u, true);
  }
}

class LaggingKernel final : public TranslationKernel {
 public:
  LaggingKernel(HalfspaceConstants c, std::vector<LaggingBody> bodies) : c_(c), body_(std::move(bodies)) {
    // Bodies that are alike when they are loaded at once may creep differently.
    all_ = c_;
    for (const LaggingBody& body : body_) {
      if (body.c.ck != 0) all_.ck = body.c.ck;
      if (body.c.cv != 0) all_.cv = body.c.cv;
    }
  }
  bool couples() const override { return all_.ck != 0; }
  bool turns() const override { return false; }
  bool shears() const override { return all_.cv != 0; }
  std::unique_ptr<LatticeRows> on_lattice(const LatticeHat& source, double shift_x, double shift_y,
                                          OffsetReach reach) const override {
    return std::make_unique<LaggingRows>(c_, body_, terms_of(all_), source, shift_x, shift_y, reach);
  }
  Softness softness(double k) const override {
    const double unit = 2 * std::numbers::pi / k;
    return {unit * c_.cn, unit * c_.cn, unit * (c_.cn + c_.cv)};
  }
  std::complex<double> delay(double k1) const override {
    std::complex<double> factor = 1;
    for (const LaggingBody& body : body_)
      for (const Lag& lag : body.lag)
        factor += lag.ratio * body.c.cn / c_.cn / std::complex<double>(1, -k1 * lag.length);
    return factor;
  }

 private:
  HalfspaceConstants c_, all_;
  std::vector<LaggingBody> body_;
};

}  // namespace

std::shared_ptr<const TranslationKernel> make_halfspace_kernel(HalfspaceConstants c) {
  return std::make_shared<HalfspaceKernel>(c);
}

std::shared_ptr<const TranslationKernel> make_lagging_kernel(HalfspaceConstants c, std::vector<LaggingBody> bodies) {
  return std::make_shared<LaggingKernel>(c, std::move(bodies));
}

}  // namespace rollcon
