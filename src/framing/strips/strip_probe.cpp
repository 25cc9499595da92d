#include "framing/strips/strip_probe.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rollcon::strips {
namespace {

constexpr int most_lattices = 8, most_rounds = 40;

// Computes the fourth antiderivative of 1/r, see strip_kernels.hpp.
double primitive(double x, double y) {
  const double r = std::hypot(x, y);
  if (r == 0) return 0;
  return (x == 0 ? 0 : x * x * y * std::asinh(y / std::abs(x)) / 2) +
         (y == 0 ? 0 : x * y * y * std::asinh(x / std::abs(y)) / 2) - r * r * r / 6;
}

}  // namespace

// Finds pressures nowhere below 0 with gaps nowhere below 0: the signs of both change the set of nodes in contact until
// it stays.
bool StripProbe::press(const StripScene& scene) {
  columns_ = cells_.along - 1;
  lines_ = cells_.across - 1;
  const int n = columns_ * lines_;
  const double hx = (box_.x_greatest - box_.x_least) / cells_.along,
               hy = (box_.y_greatest - box_.y_least) / cells_.across;
  point_.resize(n);
  gap_.resize(n);
  pressure_.assign(n, 0);
  for (int j = 0; j < lines_; ++j)
    for (int i = 0; i < columns_; ++i)
      point_[j * columns_ + i] = Vec2{box_.x_least + (i + 1) * hx, box_.y_least + (j + 1) * hy};
  scene.gap->at(point_, gap_.data(), nullptr);
  // Influence of a hat at an offset, from primitives at the offsets' neighbours.
  std::vector<double>& corner = right_;
  const int width = columns_ + 1, corners = columns_ + 2;  // offsets of nodes along, and of their neighbours
  corner.resize(corners * (lines_ + 2));
  const auto f = [&](int i, int j) { return corner[std::abs(j) * corners + std::abs(i)]; };
  for (int j = 0; j <= lines_ + 1; ++j)
    for (int i = 0; i <= columns_ + 1; ++i) corner[j * corners + i] = primitive(i * hx, j * hy);
  influence_.resize(width * (lines_ + 1));
  for (int j = 0; j <= lines_; ++j)
    for (int i = 0; i <= columns_; ++i)
      influence_[j * width + i] = scene.bodies.cn / (hx * hy) *
                                  (f(i - 1, j - 1) + f(i + 1, j - 1) + f(i - 1, j + 1) + f(i + 1, j + 1) -
                                   2 * (f(i - 1, j) + f(i + 1, j) + f(i, j - 1) + f(i, j + 1)) + 4 * f(i, j));
  const auto between = [&](int a, int b) {
    return influence_[std::abs(a / columns_ - b / columns_) * width + std::abs(a % columns_ - b % columns_)];
  };
  active_.clear();
  for (int i = 0; i < n; ++i)
    if (scene.by_load || gap_[i] < scene.value) active_.push_back(i);
  for (int round = 0; round < most_rounds && !active_.empty(); ++round) {
    const int size = static_cast<int>(active_.size()), border = size + scene.by_load;
    double* row = lu_.prepare(border, n + 1 - border);
    right_.assign(n + 1, 0);
    for (int i = 0; i < size; ++i, row += border) {
      for (int j = 0; j < size; ++j) row[j] = between(active_[i], active_[j]);
      right_[i] = -gap_[active_[i]];
      if (scene.by_load)
        row[size] = -influence_[0];
      else
        right_[i] += scene.value;
    }
    if (scene.by_load) {
      std::fill(row, row + size, influence_[0]);
      row[size] = 0;
      right_[size] = influence_[0] * scene.value / (hx * hy);
    }
    if (!lu_.factor()) return false;
    lu_.solve(right_.data());
    approach_ = scene.by_load ? right_[size] * influence_[0] : scene.value;
    pressure_.assign(n, 0);
    for (int i = 0; i < size; ++i) pressure_[active_[i]] = right_[i];
    bool changed = false;
    part_.assign(n, 0);
    for (int i = 0; i < size; ++i) part_[active_[i]] = 1;
    stack_.clear();
    for (int i = 0; i < n; ++i) {
      bool on = part_[i] != 0;
      if (on) {
        on = pressure_[i] > 0;
      } else {
        double gap = gap_[i] - approach_;
        for (int j = 0; j < size; ++j) gap += between(i, active_[j]) * right_[j];
        on = gap < 0;
      }
      changed |= on != (part_[i] != 0);
      if (on) stack_.push_back(i);
    }
    if (!changed) return true;
    active_.swap(stack_);
  }
  return false;
}

bool StripProbe::close_in() {
  int low[2] = {columns_, lines_}, high[2] = {-1, -1};
  for (const int i : active_)
    for (int d = 0; d < 2; ++d) {
      const int at = d == 0 ? i % columns_ : i / columns_;
      low[d] = std::min(low[d], at);
      high[d] = std::max(high[d], at);
    }
  const double hx = (box_.x_greatest - box_.x_least) / cells_.along,
               hy = (box_.y_greatest - box_.y_least) / cells_.across;
  const bool closer = high[0] - low[0] < columns_ - 2 || high[1] - low[1] < lines_ - 2;
  // Nodes count from one cell inside.
  box_ = {box_.x_least + low[0] * hx, box_.x_least + (high[0] + 2) * hx, box_.y_least + low[1] * hy,
          box_.y_least + (high[1] + 2) * hy};
  return closer;
}

void StripProbe::find_parts() {
  parts_ = 0;
  part_.assign(columns_ * lines_, -1);
  for (const int first : active_) {
    if (part_[first] >= 0) continue;
    stack_.assign(1, first);
    part_[first] = parts_;
    while (!stack_.empty()) {
      const int at = stack_.back(), i = at % columns_, j = at / columns_;
      stack_.pop_back();
      for (int dj = -1; dj <= 1; ++dj)
        for (int di = -1; di <= 1; ++di) {
          const int to = at + dj * columns_ + di;
          if (i + di < 0 || i + di >= columns_ || j + dj < 0 || j + dj >= lines_) continue;
          if (part_[to] >= 0 || !(pressure_[to] > 0)) continue;
          part_[to] = parts_;
          stack_.push_back(to);
        }
    }
    ++parts_;
  }
}

// Returns how far beyond its last row a part ends, over the distance of rows: where the pressure p before that row and
// the gap g of the row beyond fit the edge of one contact, p = A sqrt(1 + d), g = 4/3 A/E* (1 - d)^(3/2).
double StripProbe::beyond(const StripScene& scene, int part, int outer, int to) const {
  const double hy = (box_.y_greatest - box_.y_least) / cells_.across;
  int column = 0;
  while (part_[outer * columns_ + column] != part) ++column;
  for (int i = 0; i < columns_; ++i)
    if (part_[outer * columns_ + i] == part && pressure_[outer * columns_ + i] > pressure_[outer * columns_ + column])
      column = i;
  const Vec2 at = {point_[outer * columns_ + column][0], point_[outer * columns_ + column][1] + to * hy};
  double gap = 0;
  scene.gap->at({&at, 1}, &gap, nullptr);
  gap -= approach_;
  for (const int node : active_)
    gap += pressure_[node] *
           influence_[std::abs(node / columns_ - outer - to) * (columns_ + 1) + std::abs(node % columns_ - column)];
  const int inner = outer - to;
  double p = inner >= 0 && inner < lines_ ? pressure_[inner * columns_ + column] : 0;
  p = std::max(p, pressure_[outer * columns_ + column]);
  const double modulus = 1 / (std::numbers::pi * scene.bodies.cn);
  double low = 0, high = 1;
  for (int i = 0; i < 20; ++i) {
    const double d = (low + high) / 2;
    (p * hy * std::pow(1 - d, 1.5) > 0.75 * modulus * std::max(gap, 0.0) * std::sqrt(1 + d) ? low : high) = d;
  }
  return low;
}

// Gives a row without pressures, between two parts that are taken for one, a load by which its chord is a waist.
void StripProbe::fill_waist(int row) {
  constexpr double waist = 0.4;
  int below = row, above = row;
  while (line_[below].nodes == 0) --below;
  while (line_[above].nodes == 0) ++above;
  const double t = static_cast<double>(row - below) / (above - below);
  line_[row].load = waist * ((1 - t) * line_[below].load + t * line_[above].load);
  line_[row].middle = (1 - t) * line_[below].middle + t * line_[above].middle;
}

// Half chords are the roots of a row's load times a ratio, which the variance of rows with four nodes tells (an ellipse
// of pressure has a fourth of its squared half chord), smoothed along y and constant beyond.
void StripProbe::fit(const StripScene& scene, int part, const StripLayout& l, std::vector<double>& geometry) {
  const double hx = (box_.x_greatest - box_.x_least) / cells_.along,
               hy = (box_.y_greatest - box_.y_least) / cells_.across;
  line_.assign(lines_, Line{});
  int first = lines_, last = -1;
  double load = 0, moment_x = 0, slant = 0, spread = 0, moment_y = 0;
  for (int j = 0; j < lines_; ++j) {
    Line& line = line_[j];
    double second = 0;
    for (int i = 0; i < columns_; ++i) {
      const double p = part_[j * columns_ + i] == part ? pressure_[j * columns_ + i] : 0,
                   x = box_.x_least + (i + 1) * hx;
      if (!(p > 0)) continue;
      ++line.nodes;
      line.load += p;
      line.middle += p * x;
      second += p * x * x;
    }
    if (!(line.load > 0)) continue;
    first = std::min(first, j);
    last = j;
    line.middle /= line.load;
    // A hat of pressures adds its own variance.
    line.variance = std::max(second / line.load - line.middle * line.middle, 0.0) + hx * hx / 6;
    const double y = box_.y_least + (j + 1) * hy;
    load += line.load;
    moment_x += line.load * line.middle;
    moment_y += line.load * y;
    slant += line.load * line.middle * y;
    spread += line.load * y * y;
  }
  for (int j = first + 1; j < last; ++j)
    if (!(line_[j].load > 0)) fill_waist(j);
  const double mean_x = moment_x / load, mean_y = moment_y / load;
  const double variance_y = spread / load - mean_y * mean_y + hy * hy / 6;
  const double lean = (slant / load - mean_x * mean_y) / variance_y;
  double end[2];
  for (int side = 0; side < 2; ++side) {
    const int outer = side == 0 ? first : last, to = side == 0 ? -1 : 1;
    end[side] = box_.y_least + (outer + 1 + to * beyond(scene, part, outer, to)) * hy;
  }
  const double centre = (end[0] + end[1]) / 2, width = (end[1] - end[0]) / 2;
  geometry[l.centre_of(part)] = centre;
  geometry[l.width_of(part)] = width;
  double all = 0, count = 0;
  for (int j = first; j <= last; ++j)
    if (line_[j].nodes >= 4) {
      all += 2 * std::sqrt(line_[j].variance);
      count += std::sqrt(line_[j].load);
    }
  if (count == 0)
    for (int j = first; j <= last; ++j) {
      all += 2 * std::sqrt(line_[j].variance);
      count += std::sqrt(line_[j].load);
    }
  const double ratio = all / count;
  for (int k = 0; k < l.rows_each; ++k) {
    const int row = part * l.rows_each + k;
    const double u = l.across[k + 1], y = centre + width * u, at = (y - box_.y_least) / hy - 1;
    const int below = std::clamp(static_cast<int>(std::floor(at)), first, std::max(first, last - 1)),
              above = std::min(below + 1, last);
    const double t = std::clamp(at - below, 0.0, 1.0);
    // Load over that of an ellipse, and the middle over a straight line, are smooth; rows may end abruptly.
    const auto place = [&](int j) { return (box_.y_least + (j + 1) * hy - centre) / width; };
    const auto ellipse = [](double v) { return std::max(1 - v * v, 0.15); };
    double q = ((1 - t) * line_[below].load / ellipse(place(below)) + t * line_[above].load / ellipse(place(above))) *
               ellipse(u);
    const double outer = at < first ? place(first) : at > last ? place(last) : u;
    if (outer * outer < u * u) q = line_[at < first ? first : last].load * (1 - u * u) / (1 - outer * outer);
    const auto off = [&](int j) { return line_[j].middle - mean_x - lean * (box_.y_least + (j + 1) * hy - mean_y); };
    geometry[row] = mean_x + lean * (y - mean_y) + (1 - t) * off(below) + t * off(above);
    geometry[l.half_of(row)] = ratio * std::sqrt(q);
  }
}

bool StripProbe::halves(Vec2& first, Vec2& second) const {
  std::vector<double> load(static_cast<std::size_t>(lines_));
  for (int i = 0; i < columns_ * lines_; ++i) load[i / columns_] += std::max(pressure_[i], 0.0);
  int cut = -1;
  double least = 1;
  for (int j = 1; j + 1 < lines_; ++j) {
    const double left = *std::max_element(load.begin(), load.begin() + j),
                 right = *std::max_element(load.begin() + j + 1, load.end());
    if (left > 0 && right > 0 && load[j] < least * std::min(left, right))
      least = load[j] / std::min(left, right), cut = j;
  }
  if (cut < 0) return false;
  for (Vec2* half : {&first, &second}) {
    double sum = 0;
    *half = {};
    for (int i = 0; i < columns_ * lines_; ++i) {
      if ((i / columns_ < cut) != (half == &first) || i / columns_ == cut) continue;
      *half = *half + std::max(pressure_[i], 0.0) * point_[i];
      sum += std::max(pressure_[i], 0.0);
    }
    *half = (1 / sum) * *half;
  }
  return true;
}

Rectangle StripProbe::loads_beside(int part, std::vector<std::array<double, 3>>& loads) const {
  const double hx = (box_.x_greatest - box_.x_least) / cells_.along,
               hy = (box_.y_greatest - box_.y_least) / cells_.across;
  Rectangle box{box_.x_greatest, box_.x_least, box_.y_greatest, box_.y_least};
  loads.clear();
  for (const int i : active_) {
    const Vec2 at = point_[i];
    if (part_[i] != part) {
      loads.push_back({at[0], at[1], pressure_[i] * hx * hy});
      continue;
    }
    box = {std::min(box.x_least, at[0] - hx), std::max(box.x_greatest, at[0] + hx), std::min(box.y_least, at[1] - hy),
           std::max(box.y_greatest, at[1] + hy)};
  }
  return box;
}

StripStatus StripProbe::start(const StripScene& scene, const Rectangle& box, StripCounts counts, StripState& state,
                              ProbeCells cells) {
  box_ = box;
  cells_ = cells;
  for (int lattice = 0; lattice < most_lattices; ++lattice) {
    const bool pressed = press(scene);
    if (active_.empty()) return StripStatus::no_contact;
    if (!pressed) return StripStatus::unfit;
    find_parts();
    const Rectangle now = box_;
    if (!close_in()) {
      box_ = now;
      break;
    }
    if (lattice + 1 == most_lattices) box_ = now;
  }
  lay(scene, counts, state);
  return StripStatus::solved;
}

void StripProbe::lay(const StripScene& scene, StripCounts counts, StripState& state) {
  if (!(state.layout.counts == counts) || state.layout.parts != parts_) state.layout = StripLayout(counts, parts_);
  state.geometry.assign(state.layout.geometry, 0);
  state.approach = approach_;
  for (int part = 0; part < parts_; ++part) fit(scene, part, state.layout, state.geometry);
}

void StripProbe::join(const StripScene& scene, StripState& state) {
  for (int& part : part_) part = std::min(part, 0);
  parts_ = 1;
  lay(scene, state.layout.counts, state);
}

}  // namespace rollcon::strips
