/// Answers tractions on faces of the surface that a section sweeps: each stretch of faces between two stations acts as
/// what it has of each harmonic, by integrals that are exact along the way.

#include <algorithm>
#include <cmath>
#include <utility>

#include "bodies/section/plane_point.hpp"
#include "bodies/section/system.hpp"
#include "support/index.hpp"

namespace rollcon::section {
namespace {

/// Lists distinct values, ascending.
template <class T>
std::vector<T> distinct(std::vector<T> all) {
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

/// Holds responses between profile nodes for all offsets that occur: under each function along the way, row by offset.
class Table {
 public:
  Table(const Harmonics& harmonics, const Response& response, std::int64_t width, bool quadratic, double step,
        std::span<const std::int64_t> offset, std::span<const std::int32_t> to, std::span<const std::int32_t> from)
      : from_(std::ssize(from)) {
    const double half = quadratic ? step : 0.5 * step;
    std::vector<double> angle;
    for (const std::int64_t k : offset) angle.push_back(static_cast<double>(k) * step - half);
    const StationWeights weights = station_weights(harmonics, half, angle, false);
    const auto samples = response.part.rows(), pairs = 9 * std::ssize(to) * from_;
    RowMatrix<double> wanted[2], power;  // by kernel; power: rows by monomial and offset
    for (auto& w : wanted) w.resize(samples, pairs);
    for (std::int64_t s = 0; s < samples; ++s) {
      std::int64_t k = 0;
      for (const std::int32_t j : to)
        for (std::int64_t a = 0; a < 3; ++a)
          for (const std::int32_t i : from)
            for (std::int64_t b = 0; b < 3; ++b, ++k) {
              // Forces along the way and displacements across it go with sines of opposite sign; what lags goes with
              // the other kernel.
              const bool odd = (a == 1) != (b == 1);
              const double sign = odd && b == 1 ? -1 : 1;
              const std::int64_t place = ((3 * j + a) * width + i) * 3 + b;
              wanted[odd ? 1 : 0].row(s)[k] = sign * response.part.row(s)[place];
              if (!response.lags.empty())
                wanted[odd ? 0 : 1].row(s)[k] = (odd ? sign : -sign) * response.lags.row(s)[place];
            }
    }
    const RowMatrix<double>* weight[2] = {&weights.cosine, &weights.sine};
    power.resize(weights.cosine.rows(), pairs);
    for (std::size_t kernel = 0; kernel < 2; ++kernel) add_product(*weight[kernel], wanted[kernel], power);
    const std::int64_t count = std::ssize(offset);
    for (std::size_t f = 0; f < (quadratic ? 3 : 2); ++f) {
      value_[f].resize(count, pairs);
      for (std::int64_t m = 0; m < 3; ++m)
        for (std::int64_t k = 0; k < count; ++k)
          axpy(along_the_way(quadratic, f)[at(m)], power.row(m * count + k), value_[f].row(k), pairs);
    }
  }
  /// Returns nine displacements a under b of places in `to` and `from`: [3 * from_count * a + b] from the pointer on.
  const double* pair(std::int32_t function, std::int64_t offset, std::int64_t to, std::int64_t from) const {
    return value_[at(function)].row(offset) + 9 * to * from_ + 3 * from;
  }
  std::int64_t stride() const { return 3 * from_; }

 private:
  std::int64_t from_;
  RowMatrix<double> value_[3];
};

/// Says where the rows and the sources of a response are along the way and across it.
struct Places {
  std::vector<std::int64_t> station, first;  ///< distinct stations of rows; of beginnings of stretches
  std::vector<std::int32_t> to, from;        ///< distinct profile nodes of rows and of sources
  std::vector<std::int64_t> offset;          ///< distinct offsets
  std::vector<std::int64_t> row_station, row_to, source_first, source_from;  ///< place of each in these lists
  std::vector<std::int64_t> between;  ///< place of the offset: [station * first.size() + first]
};

Places find_places(const SweptSection& section, std::span<const std::int32_t> row, std::span<const Source> source) {
  const auto width = static_cast<std::int32_t>(section.profile().size());
  Places p;
  for (const std::int32_t k : row) p.station.push_back(section.station(k / width)), p.to.push_back(k % width);
  for (const Source& s : source) p.first.push_back(section.station(s.station)), p.from.push_back(s.node);
  const auto number = [](auto& all, std::vector<std::int64_t>& place) {
    const auto each = all;
    all = distinct(all);
    for (const auto& value : each) place.push_back(std::lower_bound(all.begin(), all.end(), value) - all.begin());
  };
  number(p.station, p.row_station), number(p.to, p.row_to);
  number(p.first, p.source_first), number(p.from, p.source_from);
  const std::int64_t round = section.stations();
  for (const std::int64_t l : p.station)
    for (const std::int64_t k : p.first) p.offset.push_back(((l - k) % round + round) % round);
  number(p.offset, p.between);
  return p;
}

}  // namespace

std::array<double, 3> along_the_way(bool quadratic, std::size_t function) {
  constexpr std::array<double, 3> of_three[] = {{0, -0.5, 0.5}, {0, 0.5, 0.5}, {1, 0, -1}},
                                  of_two[] = {{0.5, -0.5, 0}, {0.5, 0.5, 0}};
  return quadratic ? of_three[function] : of_two[function];
}

// Tractions become sources: integrals across the way. acting[i] holds source i by column.
void System::find_sources(std::span<const std::int64_t> face, std::span<const std::int32_t> node,
                          const RowMatrix<double>& traction, std::vector<Source>& source,
                          RowMatrix<double>& acting) const {
  const auto width = static_cast<std::int64_t>(section_.profile().size()), edges = std::ssize(section_.swept_edges());
  const std::int64_t per_face = section_.quadratic() ? 2 : 1, more[3] = {0, per_face, 1};
  const std::size_t functions = section_.quadratic() ? 3 : 2;
  std::vector<EdgeMass> mass;
  for (const std::size_t e : section_.swept_edges()) mass.push_back(edge_mass(section_, section_.edges()[e]));
  for (const std::int64_t f : face)
    for (std::size_t a = 0; a < functions; ++a)
      for (std::size_t s = 0; s < functions; ++s)
        source.push_back({f / edges * per_face, section_.of_edge(at(f % edges))[a], static_cast<std::int32_t>(s)});
  source = distinct(std::move(source));
  std::vector<std::int64_t> row_of(at(surface_.nodes()), -1);
  for (std::size_t r = 0; r < node.size(); ++r) row_of[at(node[r])] = static_cast<std::int64_t>(r);
  acting.resize(std::ssize(source), traction.columns());
  for (const std::int64_t f : face)
    for (std::size_t s = 0; s < functions; ++s) {
      const std::size_t e = at(f % edges);
      const std::int64_t station = f / edges * per_face, k = (station + more[s]) % section_.surface_stations();
      for (std::size_t a = 0; a < functions; ++a) {
        const Source own{station, section_.of_edge(e)[a], static_cast<std::int32_t>(s)};
        double* sum = acting.row(std::lower_bound(source.begin(), source.end(), own) - source.begin());
        for (std::size_t b = 0; b < functions; ++b)
          if (const std::int64_t r = row_of[at(k * width + section_.of_edge(e)[b])]; r >= 0)
            axpy(mass[e][a][b], traction.row(r), sum, traction.columns());
      }
    }
}

void System::answer(const Response& response, std::span<const std::int64_t> face, std::span<const std::int32_t> node,
                    const RowMatrix<double>& traction, SurfaceRows& rows) const {
  std::vector<Source> source;
  RowMatrix<double> acting;
  find_sources(face, node, traction, source, acting);
  const Places place = find_places(section_, rows.row, source);
  const Table table(harmonics_, response, std::ssize(section_.profile()), section_.quadratic(), section_.step(),
                    place.offset, place.to, place.from);
  const std::int64_t sources = std::ssize(source), wanted = 3 * std::ssize(rows.row), columns = traction.columns();

  const std::int64_t more[3] = {0, section_.quadratic() ? 2 : 1, 1};
  std::vector<std::array<Vec3, 3>> axes;
  for (const Source& s : source)
    axes.push_back(
        section_.axes(static_cast<double>(section_.station(s.station) + more[at(s.function)]) * section_.step()).all());

  // Displacements along e1, the way and e2 at the row under sources along the body's axes: by_axis[y].
  RowMatrix<double> by_axis[3], moved;
  for (auto& m : by_axis) m.resize(wanted, sources);
  for (std::int64_t r = 0; r < wanted / 3; ++r)
    for (std::int64_t s = 0; s < sources; ++s) {
      const std::int64_t offset =
          place.between[at(place.row_station[at(r)] * std::ssize(place.first) + place.source_first[at(s)])];
      const double* u = table.pair(source[at(s)].function, offset, place.row_to[at(r)], place.source_from[at(s)]);
      for (std::int64_t a = 0; a < 3; ++a)
        for (std::size_t y = 0; y < 3; ++y) {
          double sum = 0;
          for (std::size_t b = 0; b < 3; ++b) sum += u[at(a * table.stride()) + b] * axes[at(s)][b][y];
          by_axis[y].row(3 * r + a)[s] = sum;
        }
    }
  rows.u.resize(wanted, 3 * columns);
  for (std::size_t y = 0; y < 3; ++y) {
    moved.release();
    moved.resize(wanted, columns);
    add_product(by_axis[y], acting, moved);
    for (std::int64_t r = 0; r < wanted / 3; ++r) {
      const auto here =
          section_.axes(static_cast<double>(place.station[at(place.row_station[at(r)])]) * section_.step()).all();
      for (std::size_t x = 0; x < 3; ++x) {
        double* out = rows.u.row(3 * r + static_cast<std::int64_t>(x)) + y;
        for (std::int64_t c = 0; c < columns; ++c) {
          double sum = 0;
          for (std::size_t a = 0; a < 3; ++a) sum += here[a][x] * moved.row(3 * r + static_cast<std::int64_t>(a))[c];
          out[3 * c] = sum;
        }
      }
    }
  }
}

}  // namespace rollcon::section
