#include "tables/force_table.hpp"

#include <dlfcn.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>

#include "build_info.hpp"
#include "contact/scene/host_interrupt.hpp"
#include "io/section_file.hpp"
#include "support/error.hpp"
#include "support/index.hpp"
#include "support/input_checks.hpp"
#include "tables/table_samples.hpp"

namespace rollcon {
namespace {

/// Difference of (1 - 2 nu) / (2 G) over the mean of 1 / G that makes no difference.
constexpr double alike = 1e-6;
constexpr const char* maps = "maps";  ///< section of maps of pairs of profiles

void require_between(std::int64_t value, const char* name, std::int64_t low, std::int64_t high) {
  if (value < low || value > high)
    fail(Status::err_argument, "%s is %lld; allowed: %lld to %lld", name, static_cast<long long>(value),
         static_cast<long long>(low), static_cast<long long>(high));
}

/// Returns the folder that this code was loaded from.
std::filesystem::path library_folder() {
  Dl_info info{};
  if (dladdr(reinterpret_cast<const void*>(&library_folder), &info) == 0 || !info.dli_fname) return {};
  std::error_code failed;
  return std::filesystem::weakly_canonical(info.dli_fname, failed).parent_path();
}

void load_maps(SectionReader& file, std::map<std::uint64_t, std::shared_ptr<CreepMap>>& to) {
  file.begin(maps);
  while (file.left() > 0) {
    std::uint64_t key = 0;
    file.read(&key, sizeof key);
    to[key] = std::make_shared<CreepMap>(file);
  }
  file.end();
}

}  // namespace

std::unique_ptr<ForceTable> ForceTable::load(std::shared_ptr<Context> context, const std::string& path) {
  auto table = std::make_unique<ForceTable>(std::move(context));
  table->table_ = std::make_unique<const CreepTable>(CreepTable::load(path, [&](SectionReader& file) {
    if (file.has(maps)) load_maps(file, table->map_);
  }));
  table->grid_ = table->table_->grid();
  table->ready_.store(table->table_.get(), std::memory_order_release);
  return table;
}

// Looks in ROLLCON_DATA, beside the library as installed anywhere, where this build installs, in its sources.
std::unique_ptr<ForceTable> ForceTable::standard(std::shared_ptr<Context> context) {
  constexpr const char* name = "steel.rct";
  std::vector<std::filesystem::path> folders;
  if (const char* given = std::getenv("ROLLCON_DATA")) folders.emplace_back(given);
  for (std::filesystem::path up = library_folder(); up.has_relative_path(); up = up.parent_path())
    folders.push_back(up / "share" / "rollcon");
  folders.emplace_back(ROLLCON_DATA_INSTALLED);
  folders.emplace_back(ROLLCON_DATA_SOURCE);
  for (const auto& folder : folders) {
    std::error_code failed;
    if (std::filesystem::exists(folder / name, failed)) return load(std::move(context), (folder / name).string());
  }
  fail(Status::err_io,
       "%s is not there: looked in %s and beside the library; the environment variable ROLLCON_DATA "
       "may name its folder",
       name, ROLLCON_DATA_INSTALLED);
}

void ForceTable::require_free() const {
  if (ready_.load(std::memory_order_acquire) || !sample_.empty())
    fail(Status::err_state, "the table has samples already: make a new one");
}

void ForceTable::set_ratios(std::int32_t intervals, double least, double greatest) {
  require_free();
  require_between(intervals, "intervals", 4, 100);
  require_ascending(least, "least", greatest, "greatest");
  if (!(least >= 1e-2 && greatest <= 1e2))
    fail(Status::err_argument, "least is %g and greatest is %g; allowed: 0.01 to 100", least, greatest);
  grid_.ratios = intervals;
  grid_.least_ratio = least;
  grid_.greatest_ratio = greatest;
}

void ForceTable::set_resolution(std::int32_t magnitudes, std::int32_t angles, std::int32_t directions) {
  require_free();
  require_between(magnitudes, "magnitudes", 4, 100);
  require_between(angles, "angles", 4, 100);
  require_between(directions, "directions", 4, 32);
  if (directions % 2 != 0) fail(Status::err_argument, "directions is %d; allowed: even numbers", directions);
  grid_.magnitudes = magnitudes;
  grid_.angles = angles;
  grid_.directions = directions;
}

void ForceTable::set_frame(std::int32_t along, std::int32_t across) {
  require_free();
  require_between(along, "along", 6, 100);
  require_between(across, "across", 4, 100);
  grid_.along = along;
  grid_.across = across;
}

void ForceTable::set_poissons(std::int64_t n, const double* poisson) {
  require_free();
  require_between(n, "n", 1, 16);
  require_pointer(poisson, "poisson");
  for (std::int64_t i = 0; i < n; ++i) {
    require_finite(poisson[i], "poisson");
    if (!(poisson[i] > -1 && poisson[i] <= 0.5) || (i > 0 && !(poisson[i] > poisson[i - 1])))
      fail(Status::err_argument, "entry %lld (counting from 0) of poisson is %g; allowed: -1 to 0.5, ascending",
           static_cast<long long>(i), poisson[i]);
  }
  grid_.pair = {};
  grid_.poisson.assign(poisson, poisson + n);
}

void ForceTable::set_bodies(const double* young, const double* poisson, std::int64_t n, const double* friction) {
  require_free();
  require_pointer(young, "youngs");
  require_pointer(poisson, "poissons");
  UnlikePair pair;
  for (std::size_t i = 0; i < 2; ++i) {
    require_finite(young[i], "young");
    require_finite(poisson[i], "poisson");
    if (!(young[i] >= 0))
      fail(Status::err_argument, "young of body %zu is %g; allowed: above 0, or 0 for a rigid body", i + 1, young[i]);
    if (!(poisson[i] > -1 && poisson[i] <= 0.5))
      fail(Status::err_argument, "poisson of body %zu is %g; allowed: -1 to 0.5", i + 1, poisson[i]);
    pair.flexibility[i] = young[i] > 0 ? 2 * (1 + poisson[i]) / young[i] : 0;
    pair.poisson[i] = poisson[i];
  }
  if (young[0] == 0 && young[1] == 0) fail(Status::err_argument, "both bodies are rigid; allowed: one of them");
  const double mean = (pair.flexibility[0] + pair.flexibility[1]) / 2;
  for (double& flexibility : pair.flexibility) flexibility /= mean;
  require_between(n, "n", 1, 16);
  require_pointer(friction, "frictions");
  for (std::int64_t i = 0; i < n; ++i) {
    require_finite(friction[i], "frictions");
    if (!(friction[i] > 0 && friction[i] <= 10) || (i > 0 && !(friction[i] > friction[i - 1])))
      fail(Status::err_argument, "entry %lld (counting from 0) of frictions is %g; allowed: above 0 to 10, ascending",
           static_cast<long long>(i), friction[i]);
  }
  grid_.poisson = {pair.mean_poisson()};
  // Friction counts as in a table of like bodies where pressure strains both alike.
  if (std::abs(pair.strained()) > alike) pair.friction.assign(friction, friction + n);
  grid_.pair = std::move(pair);
}

void ForceTable::set_progress(ProgressFunction function, void* user) {
  progress_ = function;
  progress_user_ = user;
}

Status ForceTable::make(std::int32_t part, std::int32_t parts) {
  if (ready_.load(std::memory_order_acquire)) fail(Status::err_state, "the table is made already");
  if (parts < 1) fail(Status::err_argument, "parts is %d; allowed: 1 or more", parts);
  require_between(part, "part", 0, parts - 1);
  if (sample_.empty()) sample_.assign(at(SampleLayout(grid_).size()), std::numeric_limits<double>::quiet_NaN());
  cancel_.store(false);
  try {
    const HostInterrupt interrupt(progress_, progress_user_, cancel_);
    solve_samples(grid_, part, parts, *context_, sample_);
  } catch (const Cancelled&) {
    return Status::cancelled;
  }
  fit_if_complete();
  return Status::ok;
}

void ForceTable::fit_if_complete() {
  if (sample_.empty() || std::any_of(sample_.begin(), sample_.end(), [](double v) { return std::isnan(v); })) return;
  table_ = std::make_unique<const CreepTable>(CreepTable::fit(grid_, sample_));
  ready_.store(table_.get(), std::memory_order_release);
}

std::int64_t ForceTable::samples(std::int64_t capacity, double* sample) const {
  const auto n = static_cast<std::int64_t>(sample_.size());
  if (capacity >= n && sample) std::copy(sample_.begin(), sample_.end(), sample);
  return n;
}

void ForceTable::add_samples(std::int64_t n, const double* sample) {
  if (ready_.load(std::memory_order_acquire)) fail(Status::err_state, "the table is made already");
  const std::int64_t size = SampleLayout(grid_).size();
  if (n != size)
    fail(Status::err_argument, "n is %lld; a table of this size has %lld numbers", static_cast<long long>(n),
         static_cast<long long>(size));
  require_pointer(sample, "samples");
  constexpr double most = 1e6;  // forces are over mu Fn; coefficients of linear theory are some hundred at most
  for (std::int64_t i = 0; i < n; ++i)
    if (std::abs(sample[i]) > most)
      fail(std::isinf(sample[i]) ? Status::err_nonfinite : Status::err_argument,
           "entry %lld of samples (counting from 0) is %g; allowed: %g to %g, or NaN for none",
           static_cast<long long>(i), sample[i], -most, most);
  if (sample_.empty()) sample_.assign(at(size), std::numeric_limits<double>::quiet_NaN());
  for (std::int64_t i = 0; i < n; ++i)
    if (!std::isnan(sample[i])) sample_[at(i)] = sample[i];
  fit_if_complete();
}

const CreepTable& ForceTable::table() const {
  const CreepTable* ready = ready_.load(std::memory_order_acquire);
  if (!ready)
    fail(Status::err_state, "the table is not made: call rollcon_table_make, or add the samples of all parts");
  return *ready;
}

void ForceTable::evaluate(std::int64_t n, const double* input, double* result, double* derivative) const {
  const CreepTable& ready = table();
  require_count(n, "n");
  if (n == 0) return;
  require_pointer(input, "inputs");
  require_pointer(result, "results");
  for (std::int64_t i = 0; i < n; ++i) {
    const double* v = input + i * static_cast<std::int64_t>(table_inputs);
    ready.evaluate({v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8]}, i, result + 3 * i,
                   derivative ? derivative + 27 * i : nullptr);
  }
  require_finite_results(n, 3, result, "results");
  if (derivative) require_finite_results(n, 27, derivative, "derivatives");
}

void ForceTable::evaluate(const EquivalentEllipse& contact, double* result) const {
  const EquivalentEllipse& c = contact;
  const TableGrid& grid = table().grid();
  TableInput input{c.shear, c.poisson, c.friction, c.a, c.b, c.load, c.creepage[0], c.creepage[1], c.creepage[2]};
  if (!grid.unlike())
    input.longitudinal += strain_creepage(c.strained, c.load, c.a, c.b);
  else if (std::abs(c.strained * c.shear - grid.pair.strained()) > alike)
    fail(Status::err_argument,
         "(1 - 2 nu)/(2 G) of body 1 less that of body 2 is %g over the mean of 1/G; the table's bodies have %g",
         c.strained * c.shear, grid.pair.strained());
  table().evaluate(input, 0, result, nullptr);
  require_finite_results(1, 3, result, "results");
}

std::shared_ptr<CreepMap> ForceTable::map(std::uint64_t key) const {
  const std::lock_guard lock(map_mutex_);
  std::shared_ptr<CreepMap>& map = map_[key];
  if (!map) map = std::make_shared<CreepMap>();
  return map;
}

void ForceTable::save(const std::string& path) const {
  const std::lock_guard lock(map_mutex_);
  table().save(path, [this](SectionWriter& file) {
    if (map_.empty()) return;
    file.begin(maps);
    for (const auto& [key, map] : map_) {
      file.write(&key, sizeof key);
      map->save(file);
    }
  });
}

}  // namespace rollcon
