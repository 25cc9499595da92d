/// Answers tractions on faces of the surface that a section sweeps: each stretch of faces between two stations acts as
/// what it has of each harmonic, by integrals that are exact along the way.

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "bodies/section/system.hpp"
#include "linalg/lapack.hpp"
#include "mesh/quadrature.hpp"
#include "support/index.hpp"

namespace rollcon::section {
namespace {

/// Names what acts: the part of tractions that goes with profile node `node` and the shape function `function` along
/// the way, over the stretch of faces that begins at `station` of the surface.
struct Source {
  std::int64_t station = 0;
  std::int32_t node = 0, function = 0;
  auto operator<=>(const Source&) const = default;
};

/// Computes integrals of products of an edge's shape functions, over the way per radian.
std::array<std::array<double, 3>, 3> edge_mass(const SweptSection& section, const SectionEdge& edge) {
  std::array<std::array<double, 3>, 3> mass{};
  const LineRule line = gauss_legendre(6);
  const bool middle = edge.nodes() == 3;
  for (std::size_t g = 0; g < line.x.size(); ++g) {
    const double x = line.x[g], bubble = middle ? 1 - x * x : 0, turn = middle ? x : 0;
    const double value[3] = {0.5 * (1 - x - bubble), 0.5 * (1 + x - bubble), bubble},
                 slope[3] = {-0.5 + turn, 0.5 + turn, -2 * x};
    double p = 0, dp = 0, dq = 0;
    for (std::size_t a = 0; a < edge.nodes(); ++a) {
      const auto& [own_p, own_q] = section.place(edge.node[a]);
      p += value[a] * own_p, dp += slope[a] * own_p, dq += slope[a] * own_q;
    }
    for (std::size_t a = 0; a < edge.nodes(); ++a)
      for (std::size_t b = 0; b < edge.nodes(); ++b)
        mass[a][b] += line.w[g] * std::hypot(dp, dq) * section.way(p) * value[a] * value[b];
  }
  return mass;
}

/// Lists coefficients of 1, x, x^2 in the shape functions along the way: at the first station, the last, the middle.
constexpr double quadratic_functions[3][3] = {{0, -0.5, 0.5}, {0, 0.5, 0.5}, {1, 0, -1}},
                 linear_functions[2][3] = {{0.5, -0.5, 0}, {0.5, 0.5, 0}};

/// Lists distinct values, ascending, and where each is.
template <class T>
std::vector<T> distinct(std::vector<T> all) {
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}
template <class T>
std::int64_t find_in(const std::vector<T>& all, const T& value) {
  return std::lower_bound(all.begin(), all.end(), value) - all.begin();
}

/// Holds responses between profile nodes for all offsets that occur, by kernel.
class Table {
 public:
  Table(const Harmonics& harmonics, const RowMatrix<double>& response, std::int64_t width, double half, double step,
        std::vector<std::int64_t> offset, std::vector<std::int32_t> to, std::vector<std::int32_t> from)
      : offset_(std::move(offset)), to_(std::move(to)), from_(std::move(from)) {
    std::vector<double> angle;
    for (const std::int64_t k : offset_) angle.push_back(static_cast<double>(k) * step - half);
    const StationWeights weights = station_weights(harmonics, half, angle);
    const auto samples = response.rows(), pairs = 9 * std::ssize(to_) * std::ssize(from_);
    RowMatrix<double> wanted[2];
    for (auto& w : wanted) w.resize(samples, pairs);
    columns_ = pairs;
    for (std::int64_t s = 0; s < samples; ++s) {
      std::int64_t k = 0;
      for (const std::int32_t j : to_)
        for (std::int64_t a = 0; a < 3; ++a)
          for (const std::int32_t i : from_)
            for (std::int64_t b = 0; b < 3; ++b, ++k)
              wanted[(a == 1) != (b == 1) ? 1 : 0].row(s)[k] = response.row(s)[((3 * j + a) * width + i) * 3 + b];
    }
    const RowMatrix<double>* weight[2] = {&weights.cosine, &weights.sine};
    value_.resize(weights.cosine.rows(), pairs);
    for (std::size_t kernel = 0; kernel < 2; ++kernel) {
      const int m = static_cast<int>(pairs), n = static_cast<int>(value_.rows()), l = static_cast<int>(samples);
      const double one = 1;
      dgemm_("N", "N", &m, &n, &l, &one, wanted[kernel].data(), &m, weight[kernel]->data(), &l, &one, value_.data(), &m);
    }
  }
  /// Returns the displacement component a of `to` under b at `from`, under a load of these coefficients.
  double at_offset(std::int64_t offset, const double (&coefficient)[3], std::int64_t to, std::size_t a,
                   std::int64_t from, std::size_t b) const {
    const std::int64_t k = find_in(offset_, offset), count = std::ssize(offset_);
    const std::int64_t column = ((3 * to + static_cast<std::int64_t>(a)) * std::ssize(from_) + from) * 3 + static_cast<std::int64_t>(b);
    double sum = 0;
    for (std::int64_t m = 0; m < 3; ++m) sum += coefficient[m] * value_.row(m * count + k)[column];
    // Forces along the way and displacements across it go with sines of opposite sign.
    return b == 1 && a != 1 ? -sum : sum;
  }

 private:
  std::vector<std::int64_t> offset_;
  std::vector<std::int32_t> to_, from_;
  std::int64_t columns_ = 0;
  RowMatrix<double> value_;
};

}  // namespace

void System::answer(std::span<const std::int64_t> face, std::span<const std::int32_t> node,
                    const RowMatrix<double>& traction, SurfaceRows& rows) const {
  const auto width = static_cast<std::int32_t>(section_.profile().size());
  const auto edges = static_cast<std::int64_t>(section_.swept_edges().size());
  const std::int64_t per_face = section_.quadratic() ? 2 : 1, stations = section_.stations();
  const std::size_t functions = section_.quadratic() ? 3 : 2;
  const std::int64_t more[3] = {0, per_face, 1};  // station of each function

  // Tractions become sources: integrals across the way.
  std::vector<std::int64_t> row_of(at(surface_.nodes()), -1);
  for (std::size_t r = 0; r < node.size(); ++r) row_of[at(node[r])] = static_cast<std::int64_t>(r);
  const std::int64_t columns = traction.columns();
  std::map<Source, std::vector<double>> acting;
  std::vector<std::array<std::array<double, 3>, 3>> mass;
  for (const std::size_t e : section_.swept_edges()) mass.push_back(edge_mass(section_, section_.edges()[e]));
  for (const std::int64_t f : face) {
    const std::size_t e = at(f % edges);
    const std::int64_t station = f / edges * per_face;
    for (std::size_t s = 0; s < functions; ++s)
      for (std::size_t b = 0; b < functions; ++b) {
        const std::int64_t k = (station + more[s]) % section_.surface_stations();
        const std::int64_t r = row_of[at(k * width + section_.of_edge(e)[b])];
        if (r < 0) continue;
        for (std::size_t a = 0; a < functions; ++a) {
          std::vector<double>& sum = acting[{station, section_.of_edge(e)[a], static_cast<std::int32_t>(s)}];
          sum.resize(at(columns), 0.0);
          axpy(mass[e][a][b], traction.row(r), sum.data(), columns);
        }
      }
  }

  // Offsets of rows from the stretches' beginnings, once round at most.
  std::vector<std::int64_t> station_of_row, station_of_source, offset;
  std::vector<std::int32_t> to, from;
  for (const std::int32_t k : rows.row) {
    station_of_row.push_back(section_.station(k / width));
    to.push_back(k % width);
  }
  for (const auto& [source, sum] : acting) {
    station_of_source.push_back(section_.station(source.station));
    from.push_back(source.node);
  }
  const auto between = [&](std::int64_t l, std::int64_t k) { return ((l - k) % stations + stations) % stations; };
  for (const std::int64_t l : distinct(station_of_row))
    for (const std::int64_t k : distinct(station_of_source)) offset.push_back(between(l, k));
  to = distinct(to), from = distinct(from);
  const Table table(harmonics_, response_, width, 0.5 * static_cast<double>(per_face) * section_.step(), section_.step(),
                    distinct(offset), to, from);

  const auto sources = static_cast<std::int64_t>(acting.size()), wanted = 3 * std::ssize(rows.row);
  RowMatrix<double> all, matrix, moved;
  all.resize(sources, columns);
  std::int64_t row = 0;
  for (const auto& [source, sum] : acting) std::copy(sum.begin(), sum.end(), all.row(row++));
  RowMatrix<double> by_axis[3];
  for (auto& m : by_axis) m.resize(wanted, sources);
  std::int64_t s = 0;
  for (const auto& [source, sum] : acting) {
    const double(&coefficient)[3] = section_.quadratic() ? quadratic_functions[source.function] : linear_functions[source.function];
    const std::int64_t first = section_.station(source.station), own = first + more[source.function];
    const auto there = section_.axes(static_cast<double>(own) * section_.step()).all();
    const std::int64_t i = find_in(from, source.node);
    for (std::size_t r = 0; r < rows.row.size(); ++r) {
      const std::int64_t l = station_of_row[r], k = between(l, first), j = find_in(to, static_cast<std::int32_t>(rows.row[r] % width));
      const auto here = section_.axes(static_cast<double>(l) * section_.step()).all();
      for (std::size_t a = 0; a < 3; ++a)
        for (std::size_t b = 0; b < 3; ++b) {
          const double u = table.at_offset(k, coefficient, j, a, i, b);
          for (std::size_t x = 0; x < 3; ++x)
            for (std::size_t y = 0; y < 3; ++y)
              by_axis[y].row(static_cast<std::int64_t>(3 * r + x))[s] += here[a][x] * u * there[b][y];
        }
    }
    ++s;
  }
  rows.u.resize(wanted, 3 * columns);
  moved.resize(wanted, columns);
  for (std::int64_t y = 0; y < 3; ++y) {
    const int m = static_cast<int>(columns), n = static_cast<int>(wanted), l = static_cast<int>(sources);
    const double one = 1, zero = 0;
    dgemm_("N", "N", &m, &n, &l, &one, all.data(), &m, by_axis[y].data(), &l, &zero, moved.data(), &m);
    for (std::int64_t r = 0; r < wanted; ++r)
      for (std::int64_t c = 0; c < columns; ++c) rows.u.row(r)[3 * c + y] = moved.row(r)[c];
  }
}

}  // namespace rollcon::section
