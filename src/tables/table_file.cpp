/// Saves tables to files and loads them. Sections: "grid", how fine the table is, where its planes are, and for unlike
/// bodies their constants; "linear" and "spline", its coefficients.

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "build_info.hpp"
#include "io/section_file.hpp"
#include "rollcon.h"
#include "support/index.hpp"
#include "tables/creep_table.hpp"

namespace rollcon {
namespace {

/// Version of the format, raised whenever sections or coordinates change.
constexpr std::uint32_t table_format = 2;

constexpr FileKind table_file{{0x89, 'R', 'C', 'T', '\r', '\n', 0x1a, '\n'},
                              "a creep-force table of rollcon",
                              table_format,
                              ROLLCON_ABI,
                              ROLLCON_VERSION_TEXT};

struct GridRecord {
  std::int64_t ratios, magnitudes, angles, directions, along, across, planes;
  double least_ratio, greatest_ratio, stretched;
};

bool sound(const GridRecord& g) {
  const auto within = [](std::int64_t v, std::int64_t low, std::int64_t high) { return v >= low && v <= high; };
  return within(g.ratios, 4, 200) && within(g.magnitudes, 4, 200) && within(g.angles, 4, 200) &&
         within(g.directions, 4, 32) && g.directions % 2 == 0 && within(g.along, 2, 1000) &&
         within(g.across, 2, 1000) && within(g.planes, 1, 16) && g.least_ratio > 0 &&
         g.least_ratio < g.greatest_ratio && std::isfinite(g.greatest_ratio) && g.stretched >= 0 && g.stretched <= 0.5;
}

/// Counts bytes of the splines alone; nothing is allocated for a file that is smaller.
std::uint64_t bytes_of(const GridRecord& g, std::int64_t parities) {
  const std::int64_t numbers =
      g.planes * (g.ratios + 3) * (g.magnitudes + 3) * (g.angles + 3) * 3 * parities * g.directions;
  return static_cast<std::uint64_t>(numbers) * sizeof(float);
}

/// Holds the constants of unlike bodies, which follow the planes in the section "grid".
struct PairRecord {
  double flexibility[2], poisson[2];
};

bool sound(const PairRecord& pair) {
  const auto elastic = [](double nu) { return nu > -1 && nu <= 0.5; };
  return pair.flexibility[0] >= 0 && pair.flexibility[1] >= 0 &&
         std::abs(pair.flexibility[0] + pair.flexibility[1] - 2) < 1e-9 && elastic(pair.poisson[0]) &&
         elastic(pair.poisson[1]);
}

void take(const PairRecord& record, TableGrid& grid) {
  std::copy_n(record.flexibility, 2, grid.pair.flexibility);
  std::copy_n(record.poisson, 2, grid.pair.poisson);
  grid.poisson = {grid.pair.mean_poisson()};
}

template <class T>
void read_all(SectionReader& file, const char* name, std::vector<T>& v) {
  file.begin(name);
  if (file.left() != v.size() * sizeof(T)) file.fail_here("the section has another length than its table needs");
  file.read(v.data(), v.size() * sizeof(T));
  file.end();
  for (const T value : v)
    if (!std::isfinite(value)) file.fail_here("a number is not finite");
}

}  // namespace

void CreepTable::save(const std::string& path, const std::function<void(SectionWriter&)>& more) const {
  SectionWriter file(path, table_file);
  const GridRecord record{grid_.ratios,
                          grid_.magnitudes,
                          grid_.angles,
                          grid_.directions,
                          grid_.along,
                          grid_.across,
                          static_cast<std::int64_t>(grid_.planes().size()),
                          grid_.least_ratio,
                          grid_.greatest_ratio,
                          grid_.stretched};
  file.begin("grid");
  file.write(&record, sizeof record);
  file.write(grid_.planes().data(), grid_.planes().size() * sizeof(double));
  if (grid_.unlike()) {
    const UnlikePair& p = grid_.pair;
    const PairRecord pair{{p.flexibility[0], p.flexibility[1]}, {p.poisson[0], p.poisson[1]}};
    file.write(&pair, sizeof pair);
  }
  file.begin("linear");
  file.write(linear_.data(), linear_.size() * sizeof(double));
  file.begin("spline");
  file.write(coefficient_.data(), coefficient_.size() * sizeof(float));
  if (more) more(file);
  file.commit();
}

CreepTable CreepTable::load(const std::string& path, const std::function<void(SectionReader&)>& more) {
  SectionReader file(path, table_file);
  file.begin("grid");
  GridRecord record{};
  file.read(&record, sizeof record);
  if (!sound(record)) file.fail_here("the table's size is out of range");
  const std::uint64_t of_planes = static_cast<std::uint64_t>(record.planes) * sizeof(double);
  const bool unlike = file.left() == of_planes + sizeof(PairRecord);
  if (!unlike && file.left() != of_planes) file.fail_here("the section has another length");
  if (std::filesystem::file_size(path) < bytes_of(record, unlike ? 2 : 1))
    file.fail_here("the file is shorter than its table");
  TableGrid grid;
  grid.ratios = record.ratios;
  grid.magnitudes = record.magnitudes;
  grid.angles = record.angles;
  grid.directions = record.directions;
  grid.along = record.along;
  grid.across = record.across;
  grid.least_ratio = record.least_ratio;
  grid.greatest_ratio = record.greatest_ratio;
  grid.stretched = record.stretched;
  std::vector<double>& plane = unlike ? grid.pair.friction : grid.poisson;
  plane.resize(at(record.planes));
  file.read(plane.data(), of_planes);
  double last = unlike ? 0 : -1;
  for (const double v : plane) {
    if (!(v > last && v <= (unlike ? 10 : 0.5))) file.fail_here("the table's planes are out of order or range");
    last = v;
  }
  if (unlike) {
    PairRecord pair{};
    file.read(&pair, sizeof pair);
    if (!sound(pair)) file.fail_here("the bodies' constants are out of range");
    take(pair, grid);
  }
  file.end();
  CreepTable table(std::move(grid));
  read_all(file, "linear", table.linear_);
  read_all(file, "spline", table.coefficient_);
  if (more) more(file);
  file.verify_rest();
  return table;
}

}  // namespace rollcon
