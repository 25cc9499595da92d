#include "wheelrail/wheel_rail.hpp"
#include <chrono>
#include "support/context.hpp"
#include "support/testing.hpp"
namespace rollcon { namespace {
TEST(sweep, run) {
  auto context = std::make_shared<Context>(); context->set_threads(1);
  const double unit = 1; std::shared_ptr<Body> wheel, rail;
  for (auto* body : {&wheel, &rail}) { *body = std::make_shared<Body>(context, static_cast<std::int32_t>(BodyKind::halfspace)); (*body)->set_elastic(0, 2 * 82000 * 1.28, 0.28); }
  wheel->set_profile_shape("s1002", 1, &unit); rail->set_profile_shape("60e1", 1, &unit);
  WheelRail w(context, wheel, rail, 1);
  w.set_track(1435, 14, std::atan(1.0 / 40)); w.set_wheelset(1360, -70, 460); w.set_friction(0.3);
  const char* a = std::getenv("ACC"); w.set_accuracy(a ? std::atof(a) : 0.01);
  const char* n_ = std::getenv("N"); const int n = n_ ? std::atoi(n_) : 2000;
  const char* every_ = std::getenv("EVERY"); const int every = every_ ? std::atoi(every_) : 100;
  const bool force = std::getenv("FORCE") != nullptr;
  double y0 = std::getenv("Y0") ? std::atof(std::getenv("Y0")) : 0, y1 = std::getenv("Y1") ? std::atof(std::getenv("Y1")) : 6.5;
  if (force) w.prescribe_vertical(2, 10000);
  double f1[3]{}, f2[3]{}, worst = 0; int at = 0; double s0 = 0; std::vector<double> times;
  for (int i = 0; i <= n; ++i) {
    const double y = y0 + (y1 - y0) * i / n;
    const double position[6] = {0, y, 0.19, 0, 2.4e-3 * y, 0}, velocity[6] = {2000, 0, 0, 0, 0, -4.3459};
    w.set_position(position); w.set_velocity(velocity);
    auto t0 = std::chrono::steady_clock::now();
    const Status s = w.solve();
    const double ms = 1e3 * std::chrono::duration<double>(std::chrono::steady_clock::now() - t0).count();
    times.push_back(ms);
    double f[3], m[3]; w.resultant(false, f, m);
    double jump = 0; for (int c = 0; c < 3; ++c) jump = std::max(jump, std::abs(f[c] - 2 * f1[c] + f2[c]));
    if (i > 2 && jump > worst) { worst = jump; at = i; }
    if (i > 2 && jump > 50 && every > 1) std::printf("  jump %g at y %.4f status %d patches %d\n", jump, y, int(s), int(w.patches()));
    std::copy(f1, f1 + 3, f2); std::copy(f, f + 3, f1);
    if (i % every == 0) {
      std::printf("y %.4f status %d patches %d solves %g grown %g  %.3f ms  F %.1f %.1f %.1f z %.5f", y, int(s), int(w.patches()), w.stat("solves") - s0, w.stat("frames_grown"), ms, f[0], f[1], f[2], w.stat("z"));
      for (int k = 0; k < w.patches(); ++k) std::printf(" [%.3f y %.3f p %.0f ov %.4f]", w.patch_stat(k, "share"), w.patch_stat(k, "y"), w.patch_stat(k, "max_pressure"), w.patch_stat(k, "overlap"));
      std::printf("\n");
    }
    s0 = w.stat("solves");
  }
  std::sort(times.begin(), times.end());
  double sum = 0; for (double t : times) sum += t;
  std::printf("worst second difference %g N at step %d; time mean %.3f median %.3f 99 %% %.3f max %.3f\n", worst, at, sum / times.size(), times[times.size() / 2], times[times.size() * 99 / 100], times.back());
}
}}
