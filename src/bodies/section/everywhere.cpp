/// Writes what acts on a section's surface as forces of its stretches, and finds what they do everywhere.

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>

#include "bodies/section/fields.hpp"
#include "bodies/section/system.hpp"
#include "linalg/blas_threads.hpp"
#include "linalg/sparse_order.hpp"
#include "mesh/quadrature.hpp"
#include "support/error.hpp"
#include "support/index.hpp"
#include "support/parallel.hpp"

namespace rollcon::section {

// A force along each of the body's axes for each source: number 3 * (((stretch * profile) + node) * 3 + function) +
// axis.
void System::load(const LoadedSurface& surface, SurfaceLoads& loads, int /*threads*/) {
  std::vector<Source> source;
  RowMatrix<double> acting;
  const Acted acted = act(surface, loads);
  find_sources(acted.face, acted.node, acted.traction, source, acting);
  const auto width = std::ssize(section_.profile());
  const std::int64_t per_face = section_.quadratic() ? 2 : 1;
  SparseMatrix& b = loads.load;
  b.begin(9 * width * (section_.surface_stations() / per_face + 1));
  for (std::int64_t column = 0; column < acting.columns(); ++column)
    for (std::int64_t axis = 0; axis < 3; ++axis) {
      for (std::int64_t i = 0; i < acting.rows(); ++i)
        if (const double v = acting.row(i)[column]; v != 0) {
          const Source& s = source[at(i)];
          b.push(3 * ((s.station / per_face * width + s.node) * 3 + s.function) + axis, v);
        }
      b.end_column();
    }
  loads.unknown.assign(3 * loads.row.size(), -1);
}

StationWeights System::at_stations(bool slopes) const {
  const double half = (section_.quadratic() ? 1 : 0.5) * section_.step();
  std::vector<double> offset;
  for (std::int64_t k = 0; k < section_.stations(); ++k)
    offset.push_back(static_cast<double>(k) * section_.step() - half);
  return station_weights(harmonics_, half, offset, slopes);
}

std::vector<double> System::local_forces(std::span<const double> force, std::int64_t stretch,
                                         std::size_t function) const {
  const std::int64_t per_face = section_.quadratic() ? 2 : 1, more[3] = {0, per_face, 1};
  const std::size_t width = section_.profile().size();
  const auto axes =
      section_.axes(static_cast<double>(section_.station(stretch * per_face) + more[function]) * section_.step()).all();
  std::vector<double> local;
  for (std::size_t i = 0; i < width; ++i) {
    const double* given = force.data() + 3 * ((at(stretch) * width + i) * 3 + function);
    for (const Vec3& axis : axes) local.push_back(given[0] * axis[0] + given[1] * axis[1] + given[2] * axis[2]);
  }
  return local;
}

std::vector<double> System::sampled(std::span<const double> force, double angle, bool slopes,
                                    const StationWeights* known, std::int64_t station) const {
  const std::size_t width = section_.profile().size(), samples = harmonics_.samples().size();
  const std::int64_t per_face = section_.quadratic() ? 2 : 1, round = section_.stations();
  const double half = 0.5 * static_cast<double>(per_face) * section_.step();
  std::vector<double> out(12 * width * samples, 0.0), offset;
  std::vector<std::int64_t> stretch, place;  // place: row of the weights
  for (std::int64_t k = 0; 9 * at(k + 1) * width <= force.size(); ++k) {
    const auto own = force.subspan(9 * at(k) * width, 9 * width);
    if (std::all_of(own.begin(), own.end(), [](double v) { return v == 0; })) continue;
    const std::int64_t first = section_.station(k * per_face);
    place.push_back(known ? ((station - first) % round + round) % round : std::ssize(stretch));
    stretch.push_back(k);
    offset.push_back(angle - static_cast<double>(first) * section_.step() - half);
  }
  const StationWeights own = known ? StationWeights{} : station_weights(harmonics_, half, offset, slopes);
  const StationWeights& weights = known ? *known : own;
  const RowMatrix<double>* kernel[4] = {&weights.cosine, &weights.sine, &weights.cosine_slope, &weights.sine_slope};
  const std::int64_t count = known ? round : std::ssize(stretch);
  for (std::size_t k = 0; k < stretch.size(); ++k)
    for (std::size_t f = 0; f < (section_.quadratic() ? 3 : 2); ++f) {
      const std::vector<double> local = local_forces(force, stretch[k], f);
      const std::array<double, 3> coefficient = along_the_way(section_.quadratic(), f);
      for (std::size_t s = 0; s < samples; ++s)
        for (std::size_t v = 0; v < (slopes ? 4 : 2); ++v) {
          double weight = 0;
          for (std::int64_t m = 0; m < 3; ++m) weight += coefficient[at(m)] * kernel[v]->row(m * count + place[k])[s];
          for (std::size_t b = 0; b < 3 * width; ++b) out[4 * (3 * width * s + b) + v] += weight * local[b];
        }
    }
  return out;
}

Displaced System::sample_everywhere(std::size_t s, double rate) const {
  const double n = harmonics_.samples()[s], scale = (n > 0 ? n : 1) / reference_;
  const std::size_t width = section_.profile().size(), unknowns = at(stiffness_.unknowns());
  const auto& of = stiffness_.numbers();
  Displaced out{std::vector<double>(3 * width * of.size(), 0.0), {}};
  if (rate != 0) {
    const auto& [condensed, row] = condensation();
    const auto found = condensed.everywhere(creeping_stiffness(n, rate), scale);
    out.lags = out.part;
    for (std::size_t k = 0; k < row.size(); ++k)
      for (std::size_t i = 0; i < of.size(); ++i)
        if (of[i] >= 0) {
          const std::complex<double> u = found[k * unknowns + at(of[i])];
          out.part[at(row[k]) * of.size() + i] = u.real(), out.lags[at(row[k]) * of.size() + i] = u.imag();
        }
    return out;
  }
  std::call_once(order_found_, [&] { order_ = order_unknowns(stiffness_.matrix(1), {}).unknown; });
  const auto factor = factor_of(n, {}, order_);
  std::vector<double> b(3 * width * unknowns, 0.0);
  for (std::size_t k = 0; k < 3 * width; ++k)
    if (const std::int64_t u = stiffness_.unknown(section_.profile()[k / 3], k % 3); u >= 0)
      b[k * unknowns + at(u)] = scale;
  factor->solve(b.data(), static_cast<std::int64_t>(3 * width));
  for (std::size_t k = 0; k < 3 * width; ++k)
    for (std::size_t i = 0; i < of.size(); ++i)
      if (of[i] >= 0) out.part[k * of.size() + i] = b[k * unknowns + at(of[i])];
  return out;
}

std::size_t System::relaxation_of(std::int64_t element, double rate, Elastic& unit) const {
  unit = material(element);
  std::size_t way = 1;
  for (const Creeping& c : creeping_) {
    if (const double young = c.stiffness.material(element).young; rate != 0 && young > 0) {
      unit.young = young * reference_;
      return way;
    }
    ++way;
  }
  return 0;
}

std::complex<double> System::modulus(std::size_t way, std::size_t sample, double rate) const {
  if (way == 0) return 1;
  return std::next(creeping_.begin(), static_cast<std::ptrdiff_t>(way) - 1)
      ->relaxation.modulus(harmonics_.samples()[sample] * rate);
}

// The power is that of forces on the velocity of the material under them, which is the rate times the derivative of
// displacements by the angle. In each harmonic it belongs to what lags.
void System::find_power(SurfaceState& state, const Response& response) const {
  const std::vector<double>& force = state.layer_traction;
  const std::size_t columns = 3 * section_.profile().size(), functions = section_.quadratic() ? 3 : 2;
  const std::int64_t per_face = section_.quadratic() ? 2 : 1;
  const double half = 0.5 * static_cast<double>(per_face) * section_.step();
  struct Acting {
    double angle;
    std::vector<double> of[3];  ///< local_forces() of each shape function
  };
  std::vector<Acting> acting;
  for (std::int64_t k = 0; 3 * at(k + 1) * columns <= force.size(); ++k) {
    const double* given = force.data() + 3 * at(k) * columns;
    if (std::all_of(given, given + 3 * columns, [](double v) { return v == 0; })) continue;
    const std::int64_t first = section_.station(k * per_face);
    Acting& own = acting.emplace_back();
    own.angle = static_cast<double>(first) * section_.step() + half;
    for (std::size_t f = 0; f < functions; ++f) own.of[f] = local_forces(force, k, f);
  }
  const LineRule rule = gauss_legendre(20);
  state.power.assign(at(harmonics_.most()) + 1, 0.0);
  for (std::int64_t n = 1; n <= harmonics_.most(); ++n) {
    const auto number = static_cast<double>(n);
    std::complex<double> power[3];  // parts of 1, x, x^2
    for (std::size_t g = 0; g < rule.x.size(); ++g) {
      const std::complex<double> own = rule.w[g] * half * std::polar(1.0, -number * half * rule.x[g]);
      power[0] += own, power[1] += rule.x[g] * own, power[2] += rule.x[g] * rule.x[g] * own;
    }
    std::vector<std::complex<double>> q(columns);
    for (const Acting& own : acting) {
      const std::complex<double> turn = std::polar(1.0, -number * own.angle);
      for (std::size_t f = 0; f < functions; ++f) {
        const auto [c0, c1, c2] = along_the_way(section_.quadratic(), f);
        const std::complex<double> part = turn * (c0 * power[0] + c1 * power[1] + c2 * power[2]);
        for (std::size_t b = 0; b < columns; ++b) q[b] += part * own.of[f][b];
      }
    }
    // Forces along the way are a quarter of a wave behind those across it that they go with.
    for (std::size_t b = 1; b < columns; b += 3) q[b] *= std::complex<double>(0, 1);
    const Harmonics::Mix mix = harmonics_.mix(n);
    for (std::size_t i = 0; i < mix.weight.size(); ++i) {
      const double* lags = response.lags.row(static_cast<std::int64_t>(mix.first + i));
      double sum = 0;
      for (std::size_t a = 0; a < columns; ++a)
        for (std::size_t b = 0; b < columns; ++b) sum += lags[a * columns + b] * (std::conj(q[a]) * q[b]).real();
      state.power[at(n)] -= mix.weight[i] * number * state.rate * sum / SweptSection::pi;
    }
  }
}

void System::solve_everywhere(std::span<double> load, SurfaceState& state, int threads) {
  std::unique_lock lock(mutex_);
  const Response& response = this->response(state.rate, threads);
  if (creeping_.empty()) lock.unlock();
  state.layer_traction.assign(load.begin(), load.end());
  if (!creeping_.empty()) find_power(state, response);
  if (state.loads_alone) return;
  state.u.assign(3 * at(surface_.nodes()), 0.0);
  const std::size_t width = section_.profile().size();
  const StationWeights known = at_stations(false);
  parallel_for(section_.surface_stations(), 4, threads, [&](std::int64_t k, int) {
    const double angle = static_cast<double>(section_.station(k)) * section_.step();
    const std::vector<double> q = sampled(load, angle, false, &known, section_.station(k));
    const auto axes = section_.axes(angle).all();
    std::vector<double> local(3 * width, 0.0);
    for (std::size_t s = 0; s < harmonics_.samples().size(); ++s)
      for (std::size_t a = 0; a < 3 * width; ++a) {
        const double* row = response.part.row(static_cast<std::int64_t>(s)) + a * 3 * width;
        const double* lags =
            response.lags.empty() ? nullptr : response.lags.row(static_cast<std::int64_t>(s)) + a * 3 * width;
        double sum = 0;
        for (std::size_t b = 0; b < 3 * width; ++b) {
          const bool odd = (a % 3 == 1) != (b % 3 == 1);
          const double* kernel = &q[4 * (3 * width * s + b)];
          double u = row[b] * kernel[odd ? 1 : 0];
          if (lags) u += odd ? lags[b] * kernel[0] : -lags[b] * kernel[1];
          sum += odd && b % 3 == 1 ? -u : u;
        }
        local[a] += sum;
      }
    for (std::size_t i = 0; i < width; ++i)
      for (std::size_t a = 0; a < 3; ++a)
        for (std::size_t c = 0; c < 3; ++c) state.u[3 * (at(k) * width + i) + c] += local[3 * i + a] * axes[a][c];
  });
}

std::unique_ptr<const BodyFields> System::fields(SurfaceState&& state, const OwnLoads& own) {
  return std::make_unique<SectionFields>(*this, std::move(state.layer_traction), own.traction,
                                         creeping_.empty() ? 0 : state.rate);
}

}  // namespace rollcon::section
