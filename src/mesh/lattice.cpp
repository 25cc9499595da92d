#include "mesh/lattice.hpp"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <utility>

#include "support/index.hpp"

namespace rollcon {
namespace {

struct Direction {
  double x, y;
};

/// Holds what a search found, and the sums of least squares on the way.
class Search {
 public:
  Search(const Frame& frame, Lattice& lattice) : frame_(frame), lattice_(lattice) {}

  bool run() { return take_cell() && number_nodes() && fit() && within_tolerance() && place_cells(); }
  const std::string& why() const { return why_; }

 private:
  bool refuse(const char* format, ...) __attribute__((format(printf, 2, 3))) {
    char text[200];
    std::va_list values;
    va_start(values, format);
    std::vsnprintf(text, sizeof text, format, values);
    va_end(values);
    why_ = text;
    return false;
  }
  long long shown(std::size_t node) const { return static_cast<long long>(node) + frame_.mesh.index_base; }
  double along(std::size_t k) const { return lattice_.ex * frame_.x[k] + lattice_.ey * frame_.y[k]; }
  double across(std::size_t k) const { return lattice_.ex * frame_.y[k] - lattice_.ey * frame_.x[k]; }

  bool take_cell();
  bool number_nodes();
  bool fit();
  void fit_spacings();
  double misfit(std::size_t& worst) const;
  bool within_tolerance();
  bool place_cells();

  const Frame& frame_;
  Lattice& lattice_;
  std::string why_;
  std::vector<std::int32_t> i_, j_;  ///< places of each node that is used
};

/// Takes the sides of the first element as axes of the grid, and their lengths.
bool Search::take_cell() {
  const auto corner = frame_.mesh.element(0);
  const auto side = [&](std::size_t from, std::size_t to) {
    const std::size_t a = at(corner[from]), b = at(corner[to]);
    return Direction{frame_.x[b] - frame_.x[a], frame_.y[b] - frame_.y[a]};
  };
  Direction first = side(0, 1), second = side(1, 2);
  double length[2] = {std::hypot(first.x, first.y), std::hypot(second.x, second.y)};
  if (!(length[0] > 0 && length[1] > 0)) return refuse("its first cell has no area");
  // The longer side tells the direction of both more sharply.
  Direction e{first.x / length[0], first.y / length[0]}, f{-e.y, e.x};
  if (length[1] > length[0]) f = {second.x / length[1], second.y / length[1]}, e = {f.y, -f.x};
  // The axis that leans towards t2 is taken if two axes are equally close to t1.
  const double lean = std::abs(e.x) - std::abs(f.x);
  const bool tie = std::abs(lean) < 1e-6;
  if (tie ? e.x * e.y < 0 : lean < 0) {
    std::swap(e, f);
    std::swap(length[0], length[1]);
  }
  const double sign = e.x < 0 ? -1 : 1;
  lattice_.ex = sign * e.x;
  lattice_.ey = sign * e.y;
  lattice_.dx = length[0];
  lattice_.dy = length[1];
  return true;
}

/// Numbers nodes by whole cells from the outermost nodes.
bool Search::number_nodes() {
  const std::size_t n = frame_.x.size();
  double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
  std::int64_t used = 0;
  for (std::size_t k = 0; k < n; ++k) {
    if (!frame_.used[k]) continue;
    ++used;
    low[0] = std::min(low[0], along(k)), high[0] = std::max(high[0], along(k));
    low[1] = std::min(low[1], across(k)), high[1] = std::max(high[1], across(k));
  }
  double* spacing[2] = {&lattice_.dx, &lattice_.dy};
  double count[2];
  for (std::size_t d = 0; d < 2; ++d) {
    const double cells = std::round((high[d] - low[d]) / *spacing[d]);
    if (!(cells >= 1 && cells < static_cast<double>(used)))
      return refuse("its extent is not a number of cells like the first one");
    *spacing[d] = (high[d] - low[d]) / cells;
    count[d] = cells + 1;
  }
  if (static_cast<double>(used) < least_lattice_fill * count[0] * count[1])
    return refuse("its nodes fill %.3g of a grid of cells like the first one, which is less than %g",
                  static_cast<double>(used) / (count[0] * count[1]), least_lattice_fill);
  lattice_.nx = to_index(count[0]);
  lattice_.ny = to_index(count[1]);
  i_.assign(n, -1);
  j_.assign(n, -1);
  for (std::size_t k = 0; k < n; ++k) {
    if (!frame_.used[k]) continue;
    const double u = (along(k) - low[0]) / lattice_.dx, v = (across(k) - low[1]) / lattice_.dy;
    i_[k] = static_cast<std::int32_t>(to_index(std::round(u)));
    j_[k] = static_cast<std::int32_t>(to_index(std::round(v)));
    const double off = std::max(std::abs(u - i_[k]), std::abs(v - j_[k]));
    if (off > 0.25)
      return refuse("node %lld lies %.2g of a spacing off its place, %g is allowed", shown(k), off, lattice_tolerance);
  }
  return true;
}

/// Fits spacings and origin for the given axes.
void Search::fit_spacings() {
  long double count = 0, i = 0, j = 0, u = 0, v = 0;
  for (std::size_t k = 0; k < i_.size(); ++k) {
    if (i_[k] < 0) continue;
    count += 1, i += i_[k], j += j_[k], u += along(k), v += across(k);
  }
  i /= count, j /= count, u /= count, v /= count;
  long double iu = 0, ii = 0, jv = 0, jj = 0;
  for (std::size_t k = 0; k < i_.size(); ++k) {
    if (i_[k] < 0) continue;
    const long double a = i_[k] - i, b = j_[k] - j;
    ii += a * a, iu += a * (along(k) - u), jj += b * b, jv += b * (across(k) - v);
  }
  lattice_.dx = static_cast<double>(iu / ii);
  lattice_.dy = static_cast<double>(jv / jj);
  const auto u0 = static_cast<double>(u - i * lattice_.dx), v0 = static_cast<double>(v - j * lattice_.dy);
  lattice_.x0 = u0 * lattice_.ex - v0 * lattice_.ey;
  lattice_.y0 = u0 * lattice_.ey + v0 * lattice_.ex;
}

/// Fits by least squares; to what the nodes' places tell, an aligned grid stays aligned.
bool Search::fit() {
  fit_spacings();
  // The products of places and coordinates give the turn that is left.
  long double count = 0, i = 0, j = 0, turn = 0, radius = 0;
  for (std::size_t k = 0; k < i_.size(); ++k)
    if (i_[k] >= 0) count += 1, i += i_[k], j += j_[k];
  i /= count, j /= count;
  for (std::size_t k = 0; k < i_.size(); ++k) {
    if (i_[k] < 0) continue;
    const long double a = (i_[k] - i) * lattice_.dx, b = (j_[k] - j) * lattice_.dy;
    turn += a * across(k) - b * along(k);
    radius += a * along(k) + b * across(k);
  }
  const auto angle = static_cast<double>(turn / radius);
  const double ex = lattice_.ex - angle * lattice_.ey, ey = lattice_.ey + angle * lattice_.ex;
  const double length = std::hypot(ex, ey);
  lattice_.ex = ex / length;
  lattice_.ey = ey / length;
  fit_spacings();
  if (std::abs(lattice_.ey) > 1e-3) return true;
  std::size_t node = 0;
  const Lattice turned = lattice_;
  const double rounding = 1e-10 * static_cast<double>(std::max(lattice_.nx, lattice_.ny));
  const double allowed = std::max(rounding, 2 * misfit(node));
  lattice_.ex = 1, lattice_.ey = 0;
  fit_spacings();
  if (misfit(node) > allowed) lattice_ = turned;
  return true;
}

double Search::misfit(std::size_t& worst) const {
  double largest = 0;
  for (std::size_t k = 0; k < i_.size(); ++k) {
    if (i_[k] < 0) continue;
    const double u = i_[k] * lattice_.dx, v = j_[k] * lattice_.dy;
    const double x = lattice_.x0 + u * lattice_.ex - v * lattice_.ey,
                 y = lattice_.y0 + u * lattice_.ey + v * lattice_.ex;
    const double off = std::max(std::abs(frame_.x[k] - x), std::abs(frame_.y[k] - y));
    if (off > largest) largest = off, worst = k;
  }
  return largest / std::min(lattice_.dx, lattice_.dy);
}

bool Search::within_tolerance() {
  std::size_t worst = 0;
  lattice_.misfit = misfit(worst);
  if (lattice_.misfit <= lattice_tolerance) return true;
  return refuse("node %lld lies %.2g of a spacing off its place, %g is allowed", shown(worst), lattice_.misfit,
                lattice_tolerance);
}

bool Search::place_cells() {
  const std::int64_t nx = lattice_.nx;
  std::vector<std::int32_t> place(i_.size(), -1), low_corner;
  std::vector<std::uint8_t> taken(at(nx * lattice_.ny), 0);
  for (std::size_t k = 0; k < i_.size(); ++k) {
    if (i_[k] < 0) continue;
    place[k] = static_cast<std::int32_t>(j_[k] * nx + i_[k]);
    if (taken[at(place[k])]++) return refuse("node %lld lies where another one does", shown(k));
  }
  for (std::int64_t e = 0; e < frame_.elements(); ++e) {
    std::int32_t corner[4];
    for (std::size_t c = 0; c < 4; ++c) corner[c] = place[at(frame_.mesh.element(e)[c])];
    std::sort(corner, corner + 4);
    const std::int64_t low = corner[0];
    if (low % nx == nx - 1 || corner[1] != low + 1 || corner[2] != low + nx || corner[3] != low + nx + 1)
      return refuse("element %lld is not a cell of the grid", static_cast<long long>(e) + frame_.mesh.index_base);
    low_corner.push_back(corner[0]);
  }
  lattice_.place(nx, lattice_.ny, place, low_corner);
  return true;
}

}  // namespace

std::int64_t Lattice::frame_nodes() const {
  const auto there = std::count_if(node.begin(), node.end(), [](std::int32_t k) { return k >= 0; });
  return there + static_cast<std::int64_t>(loose.size());
}

bool Lattice::has_inner_node() const {
  return std::find(cells.begin(), cells.end(), all) != cells.end();
}

void Lattice::place(std::int64_t columns, std::int64_t lines, const std::vector<std::int32_t>& place_of,
                    const std::vector<std::int32_t>& low_corner) {
  nx = columns;
  ny = lines;
  node.assign(at(nx * ny), -1);
  cells.assign(node.size(), 0);
  loose.clear();
  for (const std::int32_t low : low_corner) {
    const std::size_t k = at(low), row = at(nx);
    cells[k] |= high_high;
    cells[k + 1] |= low_high;
    cells[k + row] |= high_low;
    cells[k + row + 1] |= low_low;
  }
  for (std::size_t k = 0; k < place_of.size(); ++k) {
    const std::int32_t to = place_of[k];
    if (to >= 0 && cells[at(to)] != 0)
      node[at(to)] = static_cast<std::int32_t>(k);
    else
      loose.push_back(static_cast<std::int32_t>(k));
  }
}

std::optional<Lattice> find_lattice(const Frame& frame, std::string* why) {
  const auto refuse = [why](const char* reason) {
    if (why) *why = reason;
    return std::nullopt;
  };
  if (frame.curved()) return refuse("the frame is curved");
  if (frame.elements() == 0) return refuse("it has no element");
  for (const ElementType type : frame.mesh.type)
    if (type != ElementType::quad4) return refuse("it has elements other than quad4");
  Lattice lattice;
  Search search(frame, lattice);
  if (!search.run()) return refuse(search.why().c_str());
  return lattice;
}

bool may_be_lattice(const SurfaceMesh& mesh) {
  constexpr double least = 0.9;  // fraction of a cell's sides: nodes may be a little off their places
  double side[2] = {}, first[2] = {};
  for (std::int64_t e = 0; e < mesh.elements(); ++e) {
    if (mesh.type[at(e)] != ElementType::quad4) return false;
    const auto corner = mesh.element(e);
    for (std::size_t i = 0; i < 2; ++i) {
      const Vec3 along = mesh.node[at(corner[i + 1])] - mesh.node[at(corner[i])];
      side[i] = std::sqrt(dot(along, along));
    }
    if (side[0] > side[1]) std::swap(side[0], side[1]);
    if (e == 0) std::copy(side, side + 2, first);
    for (std::size_t i = 0; i < 2; ++i)
      if (!(side[i] >= least * first[i] && first[i] >= least * side[i])) return false;
  }
  return true;
}

}  // namespace rollcon
