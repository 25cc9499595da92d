#include "framing/patch_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "contact/scene/geometry.hpp"
#include "support/index.hpp"
#include "support/interrupt.hpp"

namespace rollcon {
namespace {

constexpr std::int64_t usual_intervals = 32, most_intervals = 128;
constexpr std::int64_t enough = 12;  // nodes across the smallest patch

struct Extent {
  double least = INFINITY, greatest = -INFINITY;
  void take(double v) {
    least = std::min(least, v);
    greatest = std::max(greatest, v);
  }
  double half() const { return 0.5 * (greatest - least); }
  double middle() const { return 0.5 * (greatest + least); }
};

// Returns the angle of one of the principal axes; that of the lattice where they are about equal, or nearly along it.
double principal_angle(const std::vector<EdgePoint>& point, double before) {
  constexpr double slender = 2;  // square root of the ratio of moments
  double x = 0, y = 0, xx = 0, yy = 0, xy = 0;
  const double share = 1 / static_cast<double>(point.size());
  for (const EdgePoint& p : point) x += share * p.x, y += share * p.y;
  for (const EdgePoint& p : point) {
    xx += share * (p.x - x) * (p.x - x);
    yy += share * (p.y - y) * (p.y - y);
    xy += share * (p.x - x) * (p.y - y);
  }
  const double mean = 0.5 * (xx + yy), off = std::hypot(0.5 * (xx - yy), xy);
  if (!(mean + off > slender * slender * (mean - off))) return before;
  const double turn = std::remainder(0.5 * std::atan2(2 * xy, xx - yy) - before, 0.5 * std::numbers::pi);
  constexpr double least_turn = 0.1;
  return std::abs(turn) < least_turn ? before : before + turn;
}

// Returns the lattice whose axes are turned by `angle` and that holds the points with a margin.
SearchGrid around(const std::vector<EdgePoint>& point, double angle, double margin_along, double margin_across,
                  std::int64_t intervals) {
  const double c = std::cos(angle), s = std::sin(angle);
  Extent u, v;
  for (const EdgePoint& p : point) {
    u.take(c * p.x + s * p.y);
    v.take(c * p.y - s * p.x);
  }
  SearchGrid lattice;
  lattice.angle = angle;
  lattice.half_length = u.half() + margin_along;
  lattice.half_width = v.half() + margin_across;
  lattice.x = c * u.middle() - s * v.middle();
  lattice.y = s * u.middle() + c * v.middle();
  lattice.intervals = intervals;
  return lattice;
}

// Clips the lattice so that it lies over the bodies, if its sides are parallel to the axes.
void clip(SearchGrid& lattice, const Rectangle& bounds) {
  if (lattice.angle != 0) return;
  constexpr double rounding = 1e-6;
  const auto cut = [](double& middle, double& half, double least, double greatest) {
    const double inset = rounding * (greatest - least);
    const double low = std::max(middle - half, least + inset), high = std::min(middle + half, greatest - inset);
    middle = 0.5 * (low + high);
    half = 0.5 * (high - low);
  };
  cut(lattice.x, lattice.half_length, bounds.x_least, bounds.x_greatest);
  cut(lattice.y, lattice.half_width, bounds.y_least, bounds.y_greatest);
}

// Refuses bodies that lie where their partners should: gaps fall from within to the ends of such bodies.
void refuse_exchanged(const std::vector<double>& gap, std::size_t n) {
  std::vector<std::uint8_t> rim(n * n, 0);
  for (std::size_t k = 0; k < rim.size(); ++k)
    rim[k] = k < n || k + n >= n * n || k % n == 0 || k % n == n - 1 ||
             !std::isfinite(gap[k - 1] + gap[k + 1] + gap[k - n] + gap[k + n]);
  if (is_turned(gap, rim)) fail(Status::err_argument, "%s", exchange_bodies);
}

// Says whether the contact goes on beyond the lattice.
bool at_rim(const SearchGrid& lattice, const std::vector<EdgePoint>& point) {
  const double c = std::cos(lattice.angle), s = std::sin(lattice.angle);
  return std::any_of(point.begin(), point.end(), [&](const EdgePoint& p) {
    const double x = p.x - lattice.x, y = p.y - lattice.y;
    return !p.ends_body &&
           (std::abs(c * x + s * y) > lattice.half_length || std::abs(c * y - s * x) > lattice.half_width);
  });
}

}  // namespace

// Takes the gaps at the lattice's nodes; where there are none, more than any approach.
void PatchSearch::lay(const SearchGrid& lattice, const PatchScene& scene) {
  lattice_ = lattice;
  pressed_ = false;
  const std::int64_t n = lattice.lines();
  gap_.resize(at(n * n));
  for (std::int64_t j = 0; j < n; ++j)
    for (std::int64_t i = 0; i < n; ++i) {
      const EdgePoint p = lattice.point(static_cast<double>(i), static_cast<double>(j));
      gap_[at(j * n + i)] = scene.gap(p.x, p.y);
    }
}

// Solves for the pressures.
void PatchSearch::press(const PatchScene& scene) {
  if (std::exchange(pressed_, true)) return;
  Extent known;
  for (const double g : gap_)
    if (std::isfinite(g)) known.take(g);
  const double far = known.greatest + 100 * (known.greatest - known.least + lattice_.half_length + lattice_.half_width);
  std::vector<double> gap = gap_;
  for (double& g : gap)
    if (!std::isfinite(g)) g = far;
  Scene& on = half_space_->scene;
  const Rectangle sides{-lattice_.half_length, lattice_.half_length, -lattice_.half_width, lattice_.half_width};
  on.set_made_frame(rectangle_mesh(on.axes(), ElementType::quad4, lattice_.intervals, lattice_.intervals, sides), false,
                    true);
  on.set_gap(static_cast<std::int64_t>(gap.size()), gap.data());
  on.prescribe(static_cast<std::int32_t>(Direction::normal),
               static_cast<std::int32_t>(scene.by_force ? How::by_force : How::by_motion), scene.value);
  solve(*half_space_);
}

void PatchSearch::solve(Solver& solver) {
  const Status status = solver.solve();
  if (status == Status::cancelled) throw Cancelled();
  const std::vector<double>& normal = solver.solution().iterate.lambda[2];
  pressure_.resize(normal.size());
  std::transform(normal.begin(), normal.end(), pressure_.begin(), [](double l) { return std::max(-l, 0.0); });
  deformed_.resize(normal.size());
  derive_gap(solver.solution(), deformed_.data());
  depth_ = solver.motions()[approach];
}

// Lays a lattice about what half-spaces touch on the bodies themselves, because thin bodies touch elsewhere; it grows
// while it cuts the contact off, and closes in on it. Returns false where it does not fit on them.
bool PatchSearch::press_bodies(Solver& contact, const PatchScene& scene, std::vector<PatchEdge>& edge) {
  constexpr std::int64_t intervals = 16;
  constexpr double larger = 1.25, filled = 0.6;
  constexpr int most_rounds = 8;
  SearchGrid lattice = lattice_;
  lattice.half_length *= larger;
  lattice.half_width *= larger;
  lattice.intervals = intervals;
  const std::unique_ptr<Solver> bodies = contact.another();
  bodies->take_over(contact);
  const double none = 0;
  bodies->scene.set_friction("coulomb", 1, &none);
  for (const Direction d : {Direction::longitudinal, Direction::lateral, Direction::spin})
    bodies->scene.prescribe(static_cast<std::int32_t>(d), static_cast<std::int32_t>(How::by_motion), 0);
  for (int round = 0; round < most_rounds; ++round) {
    if (contact.host.cancelled()) throw Cancelled();
    clip(lattice, scene.bounds);
    lay(lattice, scene);
    if (!std::all_of(gap_.begin(), gap_.end(), [](double g) { return std::isfinite(g); })) return false;
    const Axes& axes = bodies->scene.axes();
    const double c = std::cos(lattice.angle), s = std::sin(lattice.angle);
    const Axes turned{axes.origin + lattice.x * axes.t1 + lattice.y * axes.t2, c * axes.t1 + s * axes.t2,
                      c * axes.t2 - s * axes.t1, axes.n};
    bodies->scene.set_made_frame(
        rectangle_mesh(turned, ElementType::quad4, intervals, intervals,
                       {-lattice.half_length, lattice.half_length, -lattice.half_width, lattice.half_width}),
        false, true);
    solve(*bodies);
    edge = contact_edges(lattice_, pressure_, deformed_, scene.modulus, scene.gap);
    std::vector<EdgePoint> all;
    for (const PatchEdge& e : edge) all.insert(all.end(), e.point.begin(), e.point.end());
    if (all.empty()) return false;
    SearchGrid next = around(all, lattice.angle, 2 * lattice.spacing_along(), 2 * lattice.spacing_across(), intervals);
    clip(next, scene.bounds);
    const double along = next.half_length / lattice.half_length, across = next.half_width / lattice.half_width;
    if (along > filled && across > filled && !at_rim(lattice, all)) return true;
    lattice = next;
  }
  return true;
}

// Closes in on the contact, where the gap is less than the approach, as long as the lattice is much wider.
SearchGrid PatchSearch::close_in(Solver& contact, const PatchScene& scene) {
  constexpr double filled = 0.6, filled_by_contact = 0.5;
  constexpr int most_rounds = 60;
  SearchGrid next;
  next.half_length = 0.5 * (scene.bounds.x_greatest - scene.bounds.x_least);
  next.half_width = 0.5 * (scene.bounds.y_greatest - scene.bounds.y_least);
  next.x = 0.5 * (scene.bounds.x_greatest + scene.bounds.x_least);
  next.y = 0.5 * (scene.bounds.y_greatest + scene.bounds.y_least);
  next.intervals = usual_intervals;
  const std::int64_t n = next.lines();
  std::vector<EdgePoint> near, touching;
  for (int round = 0; round < most_rounds; ++round) {
    if (contact.host.cancelled()) throw Cancelled();
    lay(next, scene);
    if (std::none_of(gap_.begin(), gap_.end(), [](double g) { return std::isfinite(g); }))
      fail(Status::err_argument, "the gap is nowhere finite on a lattice of %lld x %lld points over its bounds",
           static_cast<long long>(n), static_cast<long long>(n));
    if (round == 0 && scene.no_inside) refuse_exchanged(gap_, at(n));
    depth_ = scene.value;
    if (scene.by_force) press(scene);
    near.clear();
    touching.clear();
    double least = INFINITY;
    EdgePoint nearest;
    for (std::int64_t j = 0; j < n; ++j)
      for (std::int64_t i = 0; i < n; ++i) {
        const double g = gap_[at(j * n + i)];
        if (!std::isfinite(g)) continue;
        const EdgePoint p = next.point(static_cast<double>(i), static_cast<double>(j));
        if (g < least) least = g, nearest = p;
        // Between nodes the gap may be less by half of what it changes by up to the next one.
        double change = 0;
        for (std::int64_t dj = -1; dj <= 1; ++dj)
          for (std::int64_t di = -1; di <= 1; ++di)
            if (i + di >= 0 && j + dj >= 0 && i + di < n && j + dj < n)
              if (const double beside = gap_[at((j + dj) * n + i + di)]; std::isfinite(beside))
                change = std::max(change, std::abs(beside - g));
        if (g - 0.5 * change <= depth_) near.push_back(p);
        if (scene.by_force && pressure_[at(j * n + i)] > 0) touching.push_back(p);
      }
    if (near.empty()) near.push_back(nearest);
    const double along = next.spacing_along(), across = next.spacing_across();
    const double angle = near.size() > 8 && scene.speed == 0 ? principal_angle(near, next.angle) : next.angle;
    SearchGrid closer = around(near, angle, along, across, usual_intervals);
    if (angle == next.angle && closer.half_length > filled * next.half_length &&
        closer.half_width > filled * next.half_width) {
      // What touches is less than what overlaps; with several lattice lines of it the pressures tell how much.
      if (!scene.by_force || touching.size() < 30) break;
      closer = around(touching, angle, 3 * along, 3 * across, usual_intervals);
      if (closer.half_length > filled_by_contact * next.half_length &&
          closer.half_width > filled_by_contact * next.half_width)
        break;
    }
    const double size = std::max(next.half_length, next.half_width);
    if (std::max(closer.half_length, closer.half_width) < 1e-9 * (std::hypot(closer.x, closer.y) + 1e-3 * size)) break;
    next = closer;
  }
  return next;
}

// Closes in on the contact on finer lattices until its smallest patch has enough nodes; returns the edges of all
// patches.
std::vector<PatchEdge> PatchSearch::look(Solver& contact, const PatchScene& scene) {
  SearchGrid lattice = close_in(contact, scene);
  std::vector<PatchEdge> edge;
  for (int round = 0;; ++round) {
    press(scene);
    edge = contact_edges(lattice_, pressure_, deformed_, scene.modulus, scene.gap);
    std::vector<EdgePoint> all;
    std::int64_t least = most_intervals;
    for (const PatchEdge& e : edge) {
      all.insert(all.end(), e.point.begin(), e.point.end());
      least = std::min(least, e.least_nodes_across);
    }
    if (edge.empty() || round == 2) break;
    // The next lattice covers the contact alone, as fine as its smallest patch needs.
    SearchGrid next =
        around(all, lattice.angle, 2 * lattice.spacing_along(), 2 * lattice.spacing_across(), lattice.intervals);
    const bool closer = next.half_length < 0.7 * lattice.half_length || next.half_width < 0.7 * lattice.half_width;
    if (!closer && (least >= enough || lattice.intervals == most_intervals)) break;
    if (!closer) {
      next = lattice;
      next.intervals = std::min(most_intervals, lattice.intervals * ((enough + least - 1) / least));
    }
    lattice = next;
    lay(lattice, scene);
  }
  return edge;
}

void PatchSearch::add_outlines(const std::vector<PatchEdge>& edge, const EdgePoint& cell, const Rectangle& b,
                               Patches& found) {
  for (const PatchEdge& e : edge)
    if (e.point.size() >= 4) {
      found.outline.emplace_back(e.point, e.load, cell);
      for (const EdgePoint& p : e.point) {
        const double rounding = 1e-6 * std::max(cell.x, cell.y);
        found.at_bounds = found.at_bounds || p.x < b.x_least + rounding || p.x > b.x_greatest - rounding ||
                          p.y < b.y_least + rounding || p.y > b.y_greatest - rounding;
      }
    }
}

// Loads of the other patches widen the gap as they do from afar.
PatchSearch::Inclined PatchSearch::inclined(const PatchScene& scene, std::size_t which,
                                            const std::function<double(double x, double y)>& cosine) const {
  const double area = lattice_.spacing_along() * lattice_.spacing_across();
  const EdgePoint cell = lattice_.cell();
  Inclined one;
  one.scene = scene;
  one.scene.no_inside = false;
  std::vector<std::array<double, 3>> beside;
  for (std::size_t k = 0; k < edge_.size(); ++k) {
    Extent x, y;
    for (const EdgePoint& p : edge_[k].point) x.take(p.x), y.take(p.y);
    const double c = cosine(x.middle(), y.middle());
    double load = 0;
    for (const LoadAt& l : edge_[k].load) load += area * l.load / c;
    if (k != which) {
      beside.push_back({x.middle(), y.middle(), load});
      continue;
    }
    one.middle = y.middle();
    one.cosine = c;
    // Patches in inclined planes are longer and wider than in that of the axes.
    const double more_x = 2 * cell.x + (1 / c - 1) * x.half(), more_y = 2 * cell.y + (1 / c - 1) * y.half();
    const Rectangle& b = scene.bounds;
    const auto in_plane = [&](double at) { return one.middle + (at - one.middle) / c; };
    one.scene.bounds = {std::max(b.x_least, x.least - more_x), std::min(b.x_greatest, x.greatest + more_x),
                        in_plane(std::max(b.y_least, y.least - more_y)),
                        in_plane(std::min(b.y_greatest, y.greatest + more_y))};
    one.scene.value = scene.by_force ? load : c * scene.value;
  }
  one.scene.gap = [&scene, beside, at = one](double x, double y_in_plane) {
    const double y = at.back(y_in_plane);
    double gap = at.cosine * scene.gap(x, y);
    for (const auto& [at_x, at_y, load] : beside)
      gap += load / (std::numbers::pi * scene.modulus * std::hypot(x - at_x, y - at_y));
    return gap;
  };
  return one;
}

Patches PatchSearch::find_inclined(Solver& contact, const PatchScene& scene,
                                   const std::function<double(double x, double y)>& cosine) {
  std::vector<Inclined> each;
  for (std::size_t k = 0; k < edge_.size(); ++k) each.push_back(inclined(scene, k, cosine));
  Patches found;
  for (const Inclined& one : each) {
    std::vector<PatchEdge> edge = look(contact, one.scene);
    for (PatchEdge& e : edge) {
      for (EdgePoint& p : e.point) p.y = one.back(p.y);
      for (LoadAt& l : e.load) l.y = one.back(l.y);
    }
    EdgePoint cell = lattice_.cell();
    cell.y *= one.cosine;
    add_outlines(edge, cell, scene.bounds, found);
  }
  return found;
}

Patches PatchSearch::find(Solver& contact, const PatchScene& scene) {
  if (!half_space_ || modulus_ != scene.modulus || speed_ != scene.speed) {
    half_space_ = contact.make_half_space(scene.modulus);
    modulus_ = scene.modulus;
    speed_ = scene.speed;
    const double none = 0;
    half_space_->scene.set_friction("coulomb", 1, &none);
  }
  edge_ = look(contact, scene);
  if (contact.pair().meshed() && !edge_.empty()) {
    const std::vector<PatchEdge> of_half_spaces = edge_;
    const SearchGrid before = lattice_;
    if (!press_bodies(contact, scene, edge_)) {
      edge_ = of_half_spaces;
      lattice_ = before;
    }
  }
  Patches found;
  add_outlines(edge_, lattice_.cell(), scene.bounds, found);
  if (found.outline.empty()) {
    const auto nearest = std::min_element(gap_.begin(), gap_.end()) - gap_.begin();
    const auto row = nearest / lattice_.lines();
    const EdgePoint cell = lattice_.cell(),
                    p = lattice_.point(static_cast<double>(nearest - row * lattice_.lines()), static_cast<double>(row));
    constexpr double least = 1e-6;  // a fraction of what the gap is known on
    const Rectangle& b = scene.bounds;
    const double size = std::min(b.x_greatest - b.x_least, b.y_greatest - b.y_least);
    found.outline.emplace_back(p.x, p.y, std::max({cell.x, cell.y, least * size}));
  }
  return found;
}

}  // namespace rollcon
