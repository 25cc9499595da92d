// Measures contacts without a frame: errors of force and spin moment and times over random Hertzian scenes, and a
// vehicle's time loop. Errors are over mu Fn (moments over mu Fn sqrt(a b)); times are of processors by themselves,
// everything included.

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "bench.hpp"
#include "memory.hpp"
#include "statistics.hpp"
#include "support/closed_forms.hpp"
#include "support/frames.hpp"
#include "support/scene.hpp"

extern "C" void dgemm_(const char*, const char*, const int*, const int*, const int*, const double*, const double*,
                       const int*, const double*, const int*, const double*, double*, const int*);

namespace rollcon::bench {
namespace {

using closed_forms::Elastic;
using scenes::RollingPair;

double cpu_seconds() {
  std::timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// Returns the speed of products of matrices of 512 rows, in 1e9 operations a second, by which times are to be scaled.
double dgemm_speed() {
  constexpr int n = 512;
  const std::vector<double> a(n * n, 1.5), b(n * n, 0.5);
  std::vector<double> c(n * n);
  const double one = 1, zero = 0;
  double best = 0;
  for (int i = 0; i < 6; ++i) {
    const double began = cpu_seconds();
    dgemm_("N", "N", &n, &n, &n, &one, a.data(), &n, b.data(), &n, &zero, c.data(), &n);
    best = std::max(best, 2e-9 * n * n * n / (cpu_seconds() - began));
  }
  return best;
}

constexpr double mu = 0.3;
const Elastic steel{.shear = 82000, .poisson = 0.28}, aluminium{.shear = 26000, .poisson = 0.35};

struct Scene {
  std::optional<Elastic> second;
  closed_forms::Hertz hertz{};
  std::array<double, 3> creep{};
  double bound() const { return mu * hertz.load; }
  double arm() const { return std::sqrt(hertz.a * hertz.b); }
};

/// Draws ellipses of ratio 0.2 to 5, and creepages whose linear theory asks for 0.2 to 2.5 of friction's bound, two of
/// three with spin; half of them are of equal bodies, a quarter of steel on aluminium, a quarter on a rigid one.
std::vector<Scene> draw(int count) {
  frames::Random random(20261123);
  std::vector<Scene> all;
  for (int i = 0; i < count; ++i) {
    Scene s;
    if (i % 4 < 2) s.second = steel;
    if (i % 4 == 2) s.second = aluminium;
    const double ratio = std::exp(random.between(std::log(0.2), std::log(5.0)));
    const double e =
        s.second ? closed_forms::effective_modulus(steel, *s.second) : closed_forms::effective_modulus(steel);
    s.hertz = closed_forms::hertz_from_axes(5 * std::sqrt(ratio), 5 / std::sqrt(ratio), 1000, e);
    const double share = std::exp(random.between(std::log(0.2), std::log(2.5)));
    const double direction = random.between(0, 2 * std::numbers::pi), spin = i % 3 == 0 ? 0 : random.between(-1, 1);
    const double area = s.hertz.a * s.hertz.b, unit = s.bound() / (steel.shear * area);
    s.creep = {share * unit / 4 * std::cos(direction), share * unit / 4 * std::sin(direction),
               spin * unit / (1.5 * std::sqrt(area))};
    all.push_back(s);
  }
  return all;
}

std::unique_ptr<RollingPair> make(const Scene& s, double accuracy) {
  auto pair = std::make_unique<RollingPair>(steel, s.second, 1);
  pair->gap_quadratic(s.hertz.A, s.hertz.B).load(s.hertz.load).friction(mu);
  pair->creep(s.creep[0], s.creep[1], s.creep[2]).option("frame_accuracy", accuracy);
  return pair;
}

std::array<double, 3> shares(const RollingPair& pair, double bound, double arm) {
  double force[3], moment[3];
  rollcon_contact_get_resultant(pair.handle(), ROLLCON_LOCAL, force, moment);
  return {force[0] / bound, force[1] / bound, moment[2] / (bound * arm)};
}

struct Figures {
  std::vector<double> force, moment, estimate, cold, warm;
  int inaccurate = 0;
};

double mean(const std::vector<double>& v) {
  double sum = 0;
  for (const double x : v) sum += x;
  return sum / static_cast<double>(v.size());
}

void measure(const Scene& s, const std::array<double, 3>& exact, double accuracy, Figures& f) {
  double began = cpu_seconds();
  const auto pair = make(s, accuracy);
  f.inaccurate += pair->solve() == ROLLCON_INACCURATE;
  f.cold.push_back(cpu_seconds() - began);
  const auto found = shares(*pair, s.bound(), s.arm());
  f.force.push_back(std::hypot(found[0] - exact[0], found[1] - exact[1]));
  f.moment.push_back(std::abs(found[2] - exact[2]));
  f.estimate.push_back(pair->stat("error_estimate"));
  std::vector<double> warm;
  for (int i = 1; i <= 9; ++i) {
    const double change = 1 + 0.003 * i;
    pair->creep(change * s.creep[0], change * s.creep[1], change * s.creep[2]).load(s.hertz.load * change);
    began = cpu_seconds();
    pair->solve();
    warm.push_back(cpu_seconds() - began);
  }
  f.warm.push_back(quantile(warm, 0.5));
}

void run_scenes(Runner& runner) {
  const std::vector<Scene> scenes = draw(runner.quick ? 8 : 40);
  const double speed = dgemm_speed();
  std::vector<std::array<double, 3>> exact;
  for (const Scene& s : scenes) {
    const auto pair = make(s, runner.quick ? 0.002 : 0.0007);
    pair->solve();
    exact.push_back(shares(*pair, s.bound(), s.arm()));
  }
  for (const bool rigid : {false, true})
    for (const double accuracy : {0.06, 0.01, 0.005, 0.002}) {
      Figures f;
      for (std::size_t i = 0; i < scenes.size(); ++i)
        if (scenes[i].second.has_value() != rigid) measure(scenes[i], exact[i], accuracy, f);
      Record r{.case_name = "automatic_frames", .method = "no frame"};
      r.model = rigid ? "steel on rigid" : "steel on steel, aluminium";
      char text[40];
      std::snprintf(text, sizeof text, "frame_accuracy %g", accuracy);
      r.mesh = text;
      r.quantity = "mean error of the force over mu Fn";
      r.against = "frame_accuracy 0.0007";
      r.value = r.error = mean(f.force);
      r.moment_error = mean(f.moment);
      r.seconds = mean(f.cold);
      r.extra = {{"scenes", static_cast<double>(f.force.size())},
                 {"force_worst", quantile(f.force, 1)},
                 {"moment_worst", quantile(f.moment, 1)},
                 {"estimate_mean", mean(f.estimate)},
                 {"inaccurate", f.inaccurate},
                 {"cold_seconds", mean(f.cold)},
                 {"cold_seconds_median", quantile(f.cold, 0.5)},
                 {"warm_seconds", mean(f.warm)},
                 {"warm_seconds_median", quantile(f.warm, 0.5)},
                 {"dgemm_gflops", speed}};
      runner.emit(r);
    }
}

/// Returns a step of a wheel of radius 460 mm: load +- 30 %, radius of curvature across 150 to 550 mm, creepages and
/// spin at their own periods.
Scene step_of_vehicle(int i) {
  const auto wave = [&](double period, double phase) { return std::sin(2 * std::numbers::pi * i / period + phase); };
  Scene s;
  s.second = steel;
  s.hertz =
      closed_forms::hertz_from_load(1 / 920.0, 1 / (2 * (350 + 200 * wave(1900, 0))),
                                    closed_forms::effective_modulus(steel, steel), 1e5 * (1 + 0.3 * wave(700, 0)));
  s.creep = {8e-4 * wave(1100, 0), 1e-3 * wave(830, 1), 2e-4 * wave(1500, 0)};
  return s;
}

void run_loop(Runner& runner) {
  const int steps = runner.quick ? 3000 : 100000, warm_up = 2000, compared = 50;
  for (const double accuracy : {0.06, 0.02}) {
    const auto pair = make(step_of_vehicle(0), accuracy);
    pair->option("tolerance", 1e-6);
    std::vector<double> seconds;
    std::array<double, 3> last{}, before{}, squares{};
    double jump = 0, worst = 0;
    std::int64_t allocations = 0, failed = 0;
    int samples = 0;
    for (int i = -warm_up; i < steps; ++i) {
      const Scene s = step_of_vehicle(i);
      const std::int64_t allocated = heap_allocations();
      const double began = cpu_seconds();
      rollcon_contact* c = pair->handle();
      rollcon_contact_set_gap_quadratic(c, s.hertz.A, s.hertz.B, 0);
      rollcon_contact_prescribe(c, ROLLCON_NORMAL, ROLLCON_BY_FORCE, s.hertz.load);
      rollcon_contact_set_creep(c, s.creep[0], s.creep[1], s.creep[2]);
      const std::int32_t status = rollcon_contact_solve(c);
      const auto now = shares(*pair, s.bound(), s.arm());
      if (i >= 0) {
        const double took = cpu_seconds() - began;
        allocations += heap_allocations() - allocated;
        seconds.push_back(took);
        failed += status != ROLLCON_OK;
        for (std::size_t k = 0; k < 3; ++k) jump = std::max(jump, std::abs(now[k] - 2 * last[k] + before[k]));
      }
      before = last;
      last = now;
      if (i < 0 || i % (steps / compared) != 0) continue;
      const auto fresh = make(s, runner.quick ? 0.002 : 0.0012);
      fresh->solve();
      const auto exact = shares(*fresh, s.bound(), s.arm());
      for (std::size_t k = 0; k < 3; ++k) {
        squares[k] += (now[k] - exact[k]) * (now[k] - exact[k]);
        worst = std::max(worst, std::abs(now[k] - exact[k]));
      }
      ++samples;
    }
    Record r{.case_name = "vehicle_loop", .method = "no frame", .model = "steel on steel"};
    char text[40];
    std::snprintf(text, sizeof text, "frame_accuracy %g", accuracy);
    r.mesh = text;
    r.quantity = "rms error of the force over mu Fn";
    r.against = "a new contact of fine frames";
    const auto rms = [&](std::size_t k) { return std::sqrt(squares[k] / samples); };
    r.value = r.error = std::max(rms(0), rms(1));
    r.moment_error = rms(2);
    r.seconds = mean(seconds);
    std::int64_t nodes = 0;
    rollcon_contact_get_size(pair->handle(), &nodes, nullptr);
    r.nodes = nodes;
    r.extra = {{"steps", steps},
               {"rms_x", rms(0)},
               {"rms_y", rms(1)},
               {"rms_moment", rms(2)},
               {"worst", worst},
               {"second_difference", jump},
               {"seconds_mean", mean(seconds)},
               {"seconds_median", quantile(seconds, 0.5)},
               {"seconds_99", quantile(seconds, 0.99)},
               {"allocations", static_cast<double>(allocations)},
               {"not_ok", static_cast<double>(failed)},
               {"dgemm_gflops", dgemm_speed()}};
    runner.emit(r);
  }
}

}  // namespace

std::vector<Case> automatic_frame_cases() {
  return {{"automatic_frames", "random Hertzian scenes without a frame: errors and times", run_scenes},
          {"vehicle_loop", "a time loop without a frame: load and curvature change", run_loop}};
}

}  // namespace rollcon::bench
