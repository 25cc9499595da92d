/// Wheel on rail from profiles, position and velocity: forces beside CONTACT's on the Manchester benchmark.

#include "wheelrail/wheel_rail.hpp"

#include <chrono>

#include "manchester.hpp"
#include "support/context.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

/// CONTACT's answers, case, elements of 0.2 mm; creepages of the rail relative to the wheel, forces on the rail.
struct Row {
  double side, y, roll, pitch_rate, z;
  double x, lateral, height, angle;
  double creepage[3], normal, longitudinal, lateral_force, moment, power, overlap, pressure, area;
};
constexpr Row rows[] = {
    {1,
     0,
     0,
     -4.3481181,
     .1981,
     0,
     751.8726,
     .1252,
     -.0290,
     {-5.665e-5, 0, 6.302e-5},
     9997,
     .2783,
     -253.6,
     -4605,
     -.4677,
     1.596e-2,
     338.3,
     51.6},
    {1,
     .5,
     -2.304e-5,
     -4.3474134,
     .1938,
     -.861,
     744.5026,
     .4289,
     -.0568,
     {4.948e-4, 1.202e-3, 1.233e-4},
     9870,
     -880.0,
     -2579,
     -3202,
     -7.427,
     1.948e-2,
     632.5,
     45.9},
    {1,
     2,
     -1.128e-4,
     -4.3459197,
     .1529,
     -3.368,
     740.9147,
     .6548,
     -.0806,
     {8.752e-4, 4.818e-3, 1.746e-4},
     9799,
     -517.3,
     -2893,
     -37.57,
     -28.39,
     2.480e-2,
     744.8,
     20.2},
    {1,
     5,
     -3.554e-4,
     -4.3353637,
     .0015,
     -7.000,
     727.0855,
     3.0041,
     -.2905,
     {4.174e-3, 1.255e-2, 6.188e-4},
     9619,
     -763.3,
     -2738,
     -826.6,
     -75.99,
     2.719e-2,
     1556,
     15.6},
    {1,
     6.5,
     -4.376e-3,
     -4.2748834,
     -3.0468,
     5.801,
     718.4931,
     10.365,
     -1.1591,
     {1.828e-2, 3.905e-2, 1.937e-3},
     15440,
     -1987,
     -4170,
     -728.2,
     -405.1,
     3.623e-2,
     2603,
     10.0},
    {-1,
     1,
     -5.049e-5,
     -4.3465752,
     .1840,
     1.796,
     -755.2440,
     .0467,
     .0176,
     {-6.297e-4, 2.400e-3, -3.848e-5},
     10050,
     829.2,
     -2893,
     376.0,
     -14.45,
     1.946e-2,
     423.9,
     36.6},
};

class manchester_wheel : public ::testing::Test {
 protected:
  void SetUp() override {
    context = std::make_shared<Context>();
    const double unit = 1;
    for (auto* body : {&wheel, &rail}) {
      *body = std::make_shared<Body>(context, static_cast<std::int32_t>(BodyKind::halfspace));
      (*body)->set_elastic(0, 2 * 82000 * 1.28, 0.28);
    }
    wheel->set_profile_shape("s1002", 1, &unit);
    rail->set_profile_shape("60e1", 1, &unit);
  }
  std::unique_ptr<WheelRail> make(double side) const {
    auto w = std::make_unique<WheelRail>(context, wheel, rail, static_cast<std::int32_t>(side));
    w->set_track(1435, 14, std::atan(1.0 / 40));
    w->set_wheelset(1360, -70, 460);
    w->set_friction(0.3);
    return w;
  }
  static void place(WheelRail& w, const Row& r) {
    const double position[6] = {0, r.y, r.z, r.roll, 2.4e-3 * r.y, 0}, velocity[6] = {2000, 0, 0, 0, 0, r.pitch_rate};
    w.set_position(position);
    w.set_velocity(velocity);
  }

  std::shared_ptr<Context> context;
  std::shared_ptr<Body> wheel, rail;
};

TEST_F(manchester_wheel, rows) {
  for (const double accuracy : {0.02, 0.01})
    for (const Row& r : rows) {
      auto w = make(r.side);
      place(*w, r);
      w->set_accuracy(accuracy);
      auto t0 = std::chrono::steady_clock::now();
      const Status s = w->solve();
      auto t1 = std::chrono::steady_clock::now();
      const Status s2 = w->solve();
      auto t2 = std::chrono::steady_clock::now();
      double f[3], m[3];
      w->resultant(false, f, m);
      const auto ms = [](auto d) { return 1e3 * std::chrono::duration<double>(d).count(); };
      std::printf("acc %g side %g y %g status %d %d patches %d grown %g  cold %.2f warm %.3f ms\n", accuracy, r.side,
                  r.y, int(s), int(s2), int(w->patches()), w->stat("frames_grown"), ms(t1 - t0), ms(t2 - t1));
      for (std::int64_t i = 0; i < w->patches(); ++i) {
        const auto v = [&](const char* name) { return w->patch_stat(i, name); };
        std::printf(
            "   share %.3f x %.3f/%.3f y %.4f/%.4f z %.4f/%.4f angle %.4f/%.4f creep %.4g/%.4g %.4g/%.4g %.4g/%.4g\n",
            v("share"), v("x"), r.x, v("y"), r.lateral, v("z"), r.height, v("angle"), r.angle,
            -v("longitudinal_creepage"), r.creepage[0], -v("lateral_creepage"), r.creepage[1], -v("spin"),
            r.creepage[2]);
        const double load = 0.3 * r.normal;
        double ap, cr[3];
        w->contact(i)->motion(&ap, cr);
        std::printf("   motion %.4g %.4g %.4g\n", cr[0], cr[1], cr[2]);
        std::printf(
            "   Fn %.1f/%.1f Fx %.1f/%.1f (%.2f %%) Fs %.1f/%.1f (%.2f %%) M %.1f/%.1f power %.3g/%.3g p %.1f/%.1f A "
            "%.1f/%.1f overlap %.4g/%.4g\n",
            v("normal_force"), r.normal, -v("longitudinal_force"), r.longitudinal,
            100 * (-v("longitudinal_force") - r.longitudinal) / load, -v("lateral_force"), r.lateral_force,
            100 * (-v("lateral_force") - r.lateral_force) / load, -v("spin_moment"), r.moment,
            v("friction_power") / 1e3, r.power, v("max_pressure"), r.pressure, v("area"), r.area, v("overlap"),
            r.overlap);
      }
    }
}

}  // namespace
}  // namespace rollcon
