#include "contact/operators/hierarchical/hierarchical_operator.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "linalg/blas_threads.hpp"
#include "linalg/lapack.hpp"
#include "mesh/plane_quadrature.hpp"
#include "support/index.hpp"
#include "support/memory_limit.hpp"
#include "support/parallel.hpp"

namespace rollcon {
namespace {

/// Returns how far the samples of each node's slip row lie from it.
std::vector<double> reach_of(const Frame& frame, const Convection& convection) {
  const std::size_t n = frame.x.size();
  std::vector<double> reach(n, 0.0);
  const SparseRows& rows = convection.rows;
  for (std::size_t k = 0; k < n; ++k)
    for (auto m = at(rows.start[k]); m < at(rows.start[k + 1]); ++m) {
      const std::size_t sample = at(rows.column[m]), node = sample % n;
      const double dx = frame.x[node] + (sample < n ? 0 : convection.ahead[node]) - frame.x[k],
                   dy = frame.y[node] - frame.y[k];
      reach[k] = std::max({reach[k], std::abs(dx), std::abs(dy)});
    }
  return reach;
}

/// Holds some elements of a frame with their nodes.
struct Part {
  Frame frame;
  std::vector<std::int32_t> node;  ///< number in the whole frame, ascending
};

Part part_of(const Frame& whole, const std::vector<std::int32_t>& element) {
  Part part;
  for (const std::int32_t e : element)
    for (const std::int32_t k : whole.mesh.element(e)) part.node.push_back(k);
  std::sort(part.node.begin(), part.node.end());
  part.node.erase(std::unique(part.node.begin(), part.node.end()), part.node.end());
  Frame& f = part.frame;
  f.axes = whole.axes;
  for (const std::int32_t k : part.node) {
    f.mesh.node.push_back(whole.mesh.node[at(k)]);
    f.x.push_back(whole.x[at(k)]);
    f.y.push_back(whole.y[at(k)]);
  }
  f.mesh.offset.push_back(0);
  for (const std::int32_t e : element) {
    for (const std::int32_t k : whole.mesh.element(e))
      f.mesh.connectivity.push_back(
          static_cast<std::int32_t>(std::lower_bound(part.node.begin(), part.node.end(), k) - part.node.begin()));
    f.mesh.type.push_back(whole.mesh.type[at(e)]);
    f.mesh.tag.push_back(0);
    f.mesh.offset.push_back(static_cast<std::int64_t>(f.mesh.connectivity.size()));
  }
  return part;
}

/// Computes c += factor a b, or a^T b, for row-major a (rows by columns) and columns b and c of `count` vectors, one
/// after the other.
void add_product(const RowMatrix<double>& a, bool transposed, double factor, const double* b, std::int64_t count,
                 double* c) {
  const int rows = static_cast<int>(a.rows()), columns = static_cast<int>(a.columns()), n = static_cast<int>(count);
  const double one = 1;
  const int out = transposed ? columns : rows, in = transposed ? rows : columns;
  if (n > 0 && out > 0 && in > 0)
    dgemm_(transposed ? "N" : "T", "N", &out, &n, &in, &factor, a.data(), &columns, b, &in, &one, c, &out);
}

}  // namespace

/// Holds moments and series of all squares, by component, and which squares count.
struct HierarchicalOperator::Workspace {
  std::vector<double> moment[3], series[3];
  std::vector<double> carried;
  std::vector<std::uint8_t> wanted, loaded;
};

std::size_t HierarchicalOperator::Leaf::bytes() const {
  std::size_t sum = moments.bytes() + of_displacement.bytes() + of_slip.bytes();
  for (const auto& row_blocks : block)
    for (const auto& b : row_blocks) sum += b.bytes();
  return sum + (row.size() + column.size() + source.size()) * sizeof(std::int32_t);
}

HierarchicalOperator::HierarchicalOperator(const Frame& frame, const Compliance& compliance,
                                           const Convection& convection, bool slip, double accuracy, int threads)
    : kernel_(compliance.translation()),
      cells_(frame, reach_of(frame, convection)),
      series_(accuracy),
      threads_(std::max(1, threads)),
      leaf_(cells_.cells().size()),
      leaf_of_(frame.x.size()),
      row_of_(frame.x.size()) {
  nodes = frame.nodes();
  coupled = slip && kernel_->couples();
  normal = true;
  tangential = slip;
  for (std::size_t k = 0; k < frame.x.size(); ++k) place_.push_back({frame.x[k], frame.y[k]});
  std::vector<std::int32_t> leaves;
  for (std::size_t c = 0; c < leaf_.size(); ++c) {
    const SquareCell& cell = cells_.cells()[c];
    if (!cell.leaf() || (cell.node.empty() && cell.element.empty())) continue;
    leaves.push_back(static_cast<std::int32_t>(c));
    leaf_[c].row = cell.node;
    for (std::size_t a = 0; a < cell.node.size(); ++a) leaf_of_[at(cell.node[a])] = c, row_of_[at(cell.node[a])] = a;
  }
  require_room(frame);
  // The first leaf makes the tables that all threads read.
  if (!leaves.empty()) fill_leaf(frame, compliance, convection, leaves.front());
  parallel_for(static_cast<std::int64_t>(leaves.size()) - 1, 1, threads_,
               [&](std::int64_t i, int) { fill_leaf(frame, compliance, convection, leaves[at(i + 1)]); });
  shift_.resize(cells_.shifts().size());
  parallel_for(static_cast<std::int64_t>(shift_.size()), 1, threads_,
               [&](std::int64_t i, int) { shift_[at(i)] = series_.transfer(*kernel_, cells_.shifts()[at(i)]); });
  if (!slip) return;
  flow_.rows = least_squares(frame, 1, 0);
  flow_.order.resize(frame.x.size());
  std::iota(flow_.order.begin(), flow_.order.end(), 0);
  std::stable_sort(flow_.order.begin(), flow_.order.end(),
                   [&](std::int32_t a, std::int32_t b) { return frame.x[at(a)] > frame.x[at(b)]; });
}

HierarchicalOperator::~HierarchicalOperator() = default;

// Counts the numbers that the leaves will hold, their near blocks and their series, and those of the tables that all
// leaves share. Throws err_memory where there is no room for them.
void HierarchicalOperator::require_room(const Frame& frame) const {
  const double blocks = !tangential ? 1 : coupled ? 9 : 5, points = series_.points();
  double numbers = points * points * point_displacements * static_cast<double>(cells_.shifts().size()) +
                   6 * points * static_cast<double>(cells_.cells().size());
  std::vector<std::int32_t> seen(frame.x.size(), -1);
  std::int32_t leaf = 0;
  const auto nodes_of = [&](std::span<const std::int32_t> elements) {
    std::int64_t count = 0;
    for (const std::int32_t e : elements)
      for (const std::int32_t k : frame.mesh.element(e))
        if (seen[at(k)] != leaf) seen[at(k)] = leaf, ++count;
    return static_cast<double>(count);
  };
  for (const SquareCell& cell : cells_.cells()) {
    if (!cell.leaf()) continue;
    const auto rows = static_cast<double>(cell.node.size());
    numbers += points * (nodes_of(cell.element) + rows * (tangential ? 2 : 1));
    ++leaf;
    double near = 0;
    if (rows > 0)
      for (const std::int32_t s : cell.near) near += nodes_of(cells_.cells()[at(s)].element);
    numbers += blocks * rows * near;
    ++leaf;
  }
  constexpr double lists = 1.1;  // a tenth for lists and for what solves add
  const double bytes = lists * sizeof(double) * numbers;
  require_memory({bytes, bytes}, "take a coarser or smaller frame", "the operators of a frame of %lld nodes need",
                 static_cast<long long>(nodes));
}

void HierarchicalOperator::fill_leaf(const Frame& frame, const Compliance& compliance, const Convection& convection,
                                     std::int32_t index) {
  const SquareCell& cell = cells_.cells()[at(index)];
  Leaf& leaf = leaf_[at(index)];
  const Vec2 centre = cells_.centre(cell);
  const double half = cells_.width(cell) / 2;
  const auto n = static_cast<std::size_t>(nodes);
  const auto place = [&](std::size_t sample) {
    return Vec2{frame.x[sample % n] + (sample < n ? 0 : convection.ahead[sample % n]), frame.y[sample % n]};
  };
  // Moments of what the leaf's own elements carry.
  constexpr int of_series = 9, of_element = 5;  // degrees of what is integrated, over one element
  const Part own = part_of(frame, cell.element);
  leaf.source = own.node;
  leaf.moments.resize(series_.points(), static_cast<std::int64_t>(own.node.size()));
  std::vector<double> value(at(series_.points()));
  integrate_projection(own.frame, of_series + of_element,
                       [&](auto node, const Shape& shape, double x, double y, double area) {
                         std::fill(value.begin(), value.end(), 0.0);
                         series_.add((x - centre[0]) / half, (y - centre[1]) / half, area, value.data());
                         for (std::size_t i = 0; i < node.size(); ++i)
                           for (std::size_t p = 0; p < value.size(); ++p)
                             leaf.moments.row(static_cast<std::int64_t>(p))[node[i]] += shape.value[i] * value[p];
                       });
  if (cell.node.empty()) return;
  // Samples of the leaf's rows: its nodes come first.
  const SparseRows& rows = convection.rows;
  const auto each_term = [&](std::size_t k, auto use) {
    for (auto m = at(rows.start[k]); m < at(rows.start[k + 1]); ++m)
      use(at(rows.column[m]), convection.factor[k] * rows.value[m]);
  };
  std::vector<std::size_t> sample;
  for (const std::int32_t k : cell.node) sample.push_back(at(k));
  if (tangential)
    for (const std::int32_t k : cell.node) each_term(at(k), [&](std::size_t s, double) { sample.push_back(s); });
  std::sort(sample.begin() + static_cast<std::ptrdiff_t>(cell.node.size()), sample.end());
  sample.erase(std::unique(sample.begin() + static_cast<std::ptrdiff_t>(cell.node.size()), sample.end()), sample.end());
  const auto number = [&](std::size_t s) {
    return static_cast<std::size_t>(
        std::lower_bound(sample.begin() + static_cast<std::ptrdiff_t>(cell.node.size()), sample.end(), s) -
        sample.begin());
  };
  // Series at the rows.
  const auto count = static_cast<std::int64_t>(cell.node.size());
  leaf.of_displacement.resize(count, series_.points());
  if (tangential) leaf.of_slip.resize(count, series_.points());
  for (std::int64_t a = 0; a < count; ++a) {
    const auto add = [&](std::size_t s, double factor, RowMatrix<double>& to) {
      const Vec2 p = place(s);
      series_.add((p[0] - centre[0]) / half, (p[1] - centre[1]) / half, factor, to.row(a));
    };
    const std::size_t k = at(cell.node[at(a)]);
    add(k, 1, leaf.of_displacement);
    if (tangential) each_term(k, [&](std::size_t s, double factor) { add(s, factor, leaf.of_slip); });
  }
  // Integrals over elements that are near.
  std::vector<std::int32_t> element;
  for (const std::int32_t s : cell.near) {
    const auto& more = cells_.cells()[at(s)].element;
    element.insert(element.end(), more.begin(), more.end());
  }
  std::sort(element.begin(), element.end());
  const Part near = part_of(frame, element);
  leaf.column = near.node;
  const auto columns = static_cast<std::int64_t>(near.node.size());
  if (columns == 0) return;
  std::vector<double> x, y;
  for (const std::size_t s : sample) x.push_back(place(s)[0]), y.push_back(place(s)[1]);
  const std::unique_ptr<Compliance> bodies = compliance.on_part(near.frame);
  ComplianceBlock wanted;
  double any = 0;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) {
      const bool own_kind = (r == 2) == (c == 2);
      if ((r == 2 && c == 2) || (tangential && (own_kind || coupled))) wanted.a[r][c] = &any;
    }
  const BlockBuffer u(wanted, sample.size(), columns);
  bodies->block({x, y}, u.block());
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) {
      if (!wanted.a[r][c]) continue;
      RowMatrix<double>& to = leaf.block[r][c];
      to.resize(count, columns);
      for (std::int64_t a = 0; a < count; ++a) {
        if (r == 2) {
          std::copy_n(u.row(2, static_cast<std::size_t>(c), at(a)), columns, to.row(a));
          continue;
        }
        const auto row = static_cast<std::size_t>(r), column = static_cast<std::size_t>(c);
        each_term(at(cell.node[at(a)]), [&](std::size_t s, double factor) {
          axpy(factor, u.row(row, column, number(s)), to.row(a), columns);
        });
      }
    }
}

double HierarchicalOperator::near(int r, int c, std::size_t k, std::size_t l) const {
  const Leaf& leaf = leaf_[leaf_of_[k]];
  if (leaf.block[r][c].empty()) return 0;
  const auto found = std::lower_bound(leaf.column.begin(), leaf.column.end(), static_cast<std::int32_t>(l));
  if (found == leaf.column.end() || at(*found) != l) return 0;
  return leaf.block[r][c].row(static_cast<std::int64_t>(row_of_[k]))[found - leaf.column.begin()];
}

double HierarchicalOperator::slip_norm(int r, std::size_t k) const {
  const Leaf& leaf = leaf_[leaf_of_[k]];
  double sum = 0;
  for (int c = 0; c < 2 && !leaf.block[r][c].empty(); ++c) {
    const double* row = leaf.block[r][c].row(static_cast<std::int64_t>(row_of_[k]));
    sum += dot(row, row, leaf.block[r][c].columns());
  }
  return std::sqrt(sum);
}

std::size_t HierarchicalOperator::bytes() const {
  std::size_t sum = 0;
  for (const Leaf& leaf : leaf_) sum += leaf.bytes();
  for (const auto& matrices : shift_)
    for (const auto& m : matrices) sum += m.bytes();
  const std::lock_guard lock(idle_lock_);
  for (const auto& w : idle_)
    for (int c = 0; c < 3; ++c) sum += (w->moment[c].capacity() + w->series[c].capacity()) * sizeof(double);
  return sum;
}

// Says which squares hold nodes that are asked for, and which hold elements that carry tractions.
void HierarchicalOperator::mark(Components columns, std::span<const std::int32_t> asked,
                                const std::vector<double> (&lambda)[3], Workspace& w) const {
  const auto& cells = cells_.cells();
  w.wanted.assign(cells.size(), asked.empty() ? 1 : 0);
  for (const std::int32_t k : asked) w.wanted[leaf_of_[at(k)]] = 1;
  w.loaded.assign(cells.size(), 0);
  for (std::size_t k = cells.size(); k-- > 0;) {
    for (int c = columns.first; c <= columns.last; ++c)
      for (const std::int32_t i : leaf_[k].source) w.loaded[k] |= lambda[c][at(i)] != 0;
    for (const std::int32_t child : cells[k].child)
      if (child >= 0) w.wanted[k] |= w.wanted[at(child)], w.loaded[k] |= w.loaded[at(child)];
  }
}

void HierarchicalOperator::gather_moments(Components columns, const std::vector<double> (&lambda)[3],
                                          Workspace& w) const {
  const auto& cells = cells_.cells();
  const auto points = static_cast<std::size_t>(series_.points());
  for (int c = columns.first; c <= columns.last; ++c) {
    w.moment[c].assign(points * cells.size(), 0.0);
    for (std::size_t k = cells.size(); k-- > 0;) {
      if (!w.loaded[k]) continue;
      double* moment = w.moment[c].data() + k * points;
      const Leaf& leaf = leaf_[k];
      w.carried.resize(leaf.source.size());
      for (std::size_t i = 0; i < w.carried.size(); ++i) w.carried[i] = lambda[c][at(leaf.source[i])];
      add_product(leaf.moments, false, 1, w.carried.data(), 1, moment);
      for (std::size_t q = 0; q < 4 && !cells[k].leaf(); ++q)
        if (const std::size_t child = at(cells[k].child[q]); w.loaded[child])
          add_product(series_.part(static_cast<int>(q)), false, 1, w.moment[c].data() + child * points, 1, moment);
    }
  }
}

// Returns displacements r by tractions c, and their sign; null: none.
const RowMatrix<double>* HierarchicalOperator::kernel_of(std::int32_t shift, int r, int c, double& sign) const {
  const auto& all = shift_[at(shift)];
  sign = r == 2 && c < 2 ? -1 : 1;
  std::size_t k = 0;
  if (r < 2 && r == c)
    k = all[1].empty() ? 0 : 1 + at(r);
  else if ((r == 2) != (c == 2))
    k = 4 + at(std::min(r, c));
  else if (r != c)
    k = 3;
  return all[k].empty() ? nullptr : &all[k];
}

// Adds to the series of some squares what squares far from them do, many pairs of one shift at a time.
void HierarchicalOperator::transfer(Components wanted, Components columns, int share, int shares, Workspace& w) const {
  constexpr std::size_t at_once = 64;
  const auto points = static_cast<std::size_t>(series_.points());
  const auto& cells = cells_.cells();
  const auto& far = cells_.far();
  std::vector<FarCells> pair;
  std::vector<double> from[3], to(points * at_once);
  for (int c = columns.first; c <= columns.last; ++c) from[c].resize(points * at_once);
  for (std::size_t first = 0; first < far.size();) {
    pair.clear();
    std::size_t next = first;
    for (; next < far.size() && far[next].shift == far[first].shift && pair.size() < at_once; ++next)
      if (far[next].target % shares == share && w.wanted[at(far[next].target)] && w.loaded[at(far[next].source)])
        pair.push_back(far[next]);
    const std::int32_t shift = far[first].shift;
    first = next;
    for (std::size_t p = 0; p < pair.size(); ++p) {
      const double unit = 1 / cells_.width(cells[at(pair[p].source)]);
      for (int c = columns.first; c <= columns.last; ++c) {
        const double* moment = w.moment[c].data() + at(pair[p].source) * points;
        for (std::size_t q = 0; q < points; ++q) from[c][p * points + q] = unit * moment[q];
      }
    }
    for (int r = wanted.first; r <= wanted.last && !pair.empty(); ++r) {
      std::fill(to.begin(), to.end(), 0.0);
      for (int c = columns.first; c <= columns.last; ++c) {
        double sign = 1;
        if (const RowMatrix<double>* m = kernel_of(shift, r, c, sign))
          add_product(*m, false, sign, from[c].data(), static_cast<std::int64_t>(pair.size()), to.data());
      }
      for (std::size_t p = 0; p < pair.size(); ++p)
        axpy(1, to.data() + p * points, w.series[r].data() + at(pair[p].target) * points,
             static_cast<std::int64_t>(points));
    }
  }
}

// Hands series down to the leaves.
void HierarchicalOperator::hand_down(Components wanted, Workspace& w) const {
  const auto points = static_cast<std::size_t>(series_.points());
  const auto& cells = cells_.cells();
  for (int r = wanted.first; r <= wanted.last; ++r)
    for (std::size_t k = 0; k < cells.size(); ++k)
      for (std::size_t q = 0; q < 4 && !cells[k].leaf(); ++q)
        if (const std::size_t child = at(cells[k].child[q]); w.wanted[child])
          add_product(series_.part(static_cast<int>(q)), true, 1, w.series[r].data() + k * points, 1,
                      w.series[r].data() + child * points);
}

void HierarchicalOperator::spread(Components wanted, Components columns, std::size_t cell,
                                  const std::vector<double> (&lambda)[3], std::vector<double> (&image)[3],
                                  const Workspace& w) const {
  const Leaf& leaf = leaf_[cell];
  const auto points = static_cast<std::size_t>(series_.points());
  std::vector<double> carried(leaf.column.size()), sum(leaf.row.size());
  for (int r = wanted.first; r <= wanted.last; ++r) {
    const RowMatrix<double>& of = r == 2 ? leaf.of_displacement : leaf.of_slip;
    multiply(of.data(), of.rows(), of.columns(), w.series[r].data() + cell * points, 0, sum.data());
    for (int c = columns.first; c <= columns.last; ++c) {
      const RowMatrix<double>& block = leaf.block[r][c];
      if (block.empty()) continue;
      for (std::size_t j = 0; j < carried.size(); ++j) carried[j] = lambda[c][at(leaf.column[j])];
      multiply(block.data(), block.rows(), block.columns(), carried.data(), 1, sum.data());
    }
    for (std::size_t a = 0; a < leaf.row.size(); ++a) image[r][at(leaf.row[a])] = sum[a];
  }
}

void HierarchicalOperator::apply(Components wanted, Components columns, std::span<const std::int32_t> asked,
                                 const std::vector<double> (&lambda)[3], std::vector<double> (&image)[3],
                                 Workspace& w) const {
  mark(columns, asked, lambda, w);
  gather_moments(columns, lambda, w);
  for (int r = wanted.first; r <= wanted.last; ++r)
    w.series[r].assign(static_cast<std::size_t>(series_.points()) * leaf_.size(), 0.0);
  // Products of matrices round by their sizes: the same shares for any number of threads give the same sums.
  constexpr int shares = 8;
  parallel_for(shares, 1, threads_,
               [&](std::int64_t share, int) { transfer(wanted, columns, static_cast<int>(share), shares, w); });
  hand_down(wanted, w);
  parallel_for(static_cast<std::int64_t>(leaf_.size()), 4, threads_, [&](std::int64_t k, int) {
    if (w.wanted[at(k)] && !leaf_[at(k)].row.empty()) spread(wanted, columns, at(k), lambda, image, w);
  });
}

void HierarchicalOperator::images(Components wanted, Components columns, std::span<const std::int32_t> asked,
                                  const std::vector<double> (&lambda)[3], std::vector<double> (&image)[3]) const {
  ++applications_;
  if (!tangential) wanted = normal_component;
  const BlasThreads blas(1);  // matrices are small
  std::unique_ptr<Workspace> w;
  {
    const std::lock_guard lock(idle_lock_);
    if (!idle_.empty()) w = std::move(idle_.back()), idle_.pop_back();
  }
  if (!w) w = std::make_unique<Workspace>();
  if (coupled) {
    apply(wanted, columns, asked, lambda, image, *w);
  } else {
    for (const Components& part : {slip_components, normal_component}) {
      if (part.first < wanted.first || part.last > wanted.last) continue;
      if (part.first >= columns.first && part.last <= columns.last)
        apply(part, part, asked, lambda, image, *w);
      else
        for (int r = part.first; r <= part.last; ++r) std::fill(image[r].begin(), image[r].end(), 0.0);
    }
  }
  const std::lock_guard lock(idle_lock_);
  idle_.push_back(std::move(w));
}

}  // namespace rollcon
