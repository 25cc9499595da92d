// Module 1 against CONTACT's results for the Manchester benchmark.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numeric>
#include <string>

#include "interface.hpp"

namespace {

using cntc_test::Element;
using cntc_test::Found;
using cntc_test::near;

/// S1002 on 60E1, canted 1:40, gauge 1435 mm; 10 kN.
void set_track(Element& e, bool right, double step) {
  static const std::vector<double> wheel = cntc_test::profile_points("s1002"), rail = cntc_test::profile_points("60e1");
  e.flags({{CNTC_if_units, CNTC_un_cntc}, {CNTC_ic_config, right}});
  e.set(cntc_setmaterialparameters, 0, {.28, .28, 82000, 82000});
  e.set(cntc_setfrictionmethod, 0, {.3, .3});
  e.set(cntc_setpotcontact, -1, {step, step, 1.57, 8, 4});
  e.profile(true, wheel);
  e.profile(false, rail);
  e.set(cntc_settrackdimensions, 1, {14, 0, 1435, std::atan(1. / 40), 0});
  e.set(cntc_setwheelsetdimensions, 3, {1360, -70, 460});
  e.vertical_force(10000);
}

void place(Element& e, double y, double roll, double rate) {
  e.set(cntc_setwheelsetposition, 1, {0, y, 0, roll, 2.4e-3 * y, 0});
  e.set(cntc_setwheelsetvelocity, 2, {2000, 0, 0, 0, 0, rate});
}

/// The wheel of the benchmark at y = 2 mm, solved.
class Wheel : public Element {
 public:
  explicit Wheel(double step = .4) : Element(1, 1, -1) {
    set_track(*this, true, step);
    place(*this, 2, -1.128e-4, -4.3459197);
    EXPECT_EQ(calculate(), 0);
  }
};

struct Row {
  bool right;
  double y, roll, rate;
  double z, reference[4];
  double fn, fx, fs, pen, pmax;
};
const Row manchester[] = {
    {true, 0, 0, -4.3481181, .1981, {0, 751.8726, .1252, -.0290}, 9997, .3, -253.6, 1.596e-2, 338.3},
    {true, .5, -2.304e-5, -4.3474134, .1938, {-.861, 744.5026, .4289, -.0568}, 9870, -880.0, -2579, 1.948e-2, 632.5},
    {true, 2, -1.128e-4, -4.3459197, .1529, {-3.368, 740.9147, .6548, -.0806}, 9799, -517.3, -2893, 2.480e-2, 744.8},
    {true, 6.5, -.004376, -4.2748834, -3.0468, {5.801, 718.4931, 10.365, -1.1591}, 15440, -1987, -4170, .03623, 2603},
    {false, 1, -5.049e-5, -4.3465752, .1840, {1.796, -755.2440, .0467, .0176}, 10050, 829.2, -2893, 1.946e-2, 423.9},
};

class wheel_rows : public testing::TestWithParam<int> {};

TEST_P(wheel_rows, manchester) {
  const Row& row = manchester[GetParam()];
  Element e(1, 1, -1);
  set_track(e, row.right, .2);
  place(e, row.y, row.roll, row.rate);
  EXPECT_EQ(e.calculate(), 0);
  ASSERT_EQ(e.patches(), 1);
  const Found f = e.found(1);
  const auto at = e.location(1);
  EXPECT_TRUE(near("z of the wheelset", e.position()[2], row.z, 1e-3));
  for (size_t k = 0; k < 3; ++k) EXPECT_TRUE(near("reference", at[k], row.reference[k], .014));
  EXPECT_TRUE(near("angle", at[3], row.reference[3], 3e-4));
  const double limit = .3 * row.fn;
  EXPECT_TRUE(near("Fn", f.fn, row.fn, .002 * row.fn));
  EXPECT_TRUE(near("Fx", f.tx, row.fx, .01 * limit));
  EXPECT_TRUE(near("Fs", f.ty, row.fs, .01 * limit));
  EXPECT_TRUE(near("penetration", f.pen, row.pen, .003 * row.pen));
  EXPECT_TRUE(near("largest pressure", f.pmax, row.pmax, .02 * row.pmax));
  const auto g = e.global_forces(-1);
  EXPECT_TRUE(near("Fz", g[2], 10000, .1));
  // Axes do not change the size of the force.
  for (size_t k = 0; k < 24; k += 6)
    EXPECT_NEAR(std::hypot(g[k], g[k + 1], g[k + 2]), std::hypot(g[0], g[1], g[2]), 1e-6);
  for (int patch : {2, 99}) {
    EXPECT_EQ(e.location(patch)[1], 0);
    EXPECT_EQ(e.global_forces(patch)[2], 0);
  }
}
INSTANTIATE_TEST_SUITE_P(all, wheel_rows, testing::Range(0, 5));

TEST(wheel, sums_of_the_benchmark) {
  // Forces on the rail of left and right wheels at y = 2 and 6.5 mm.
  const double sums[][5] = {{2, -1.128e-4, -4.3459197, 546.3, -3095.8}, {6.5, -4.376e-3, -4.2748834, 2260.0, -2042.5}};
  const double right[][2] = {{-517.3, -2095.1}, {-1986.7, 12481.4}};
  for (size_t k = 0; k < 2; ++k) {
    for (const bool side : {false, true}) {
      Element e(1, 1, -1);
      set_track(e, side, .2);
      place(e, sums[k][0], sums[k][1], sums[k][2]);
      EXPECT_EQ(e.calculate(), 0);
      const auto f = e.global_forces(-1);
      EXPECT_TRUE(near("Fx on the rail", f[0], side ? right[k][0] : sums[k][3], 30));
      EXPECT_TRUE(near("Fy on the rail", f[1], side ? right[k][1] : sums[k][4], 30));
    }
  }
}

TEST(wheel, left_is_the_mirror_image) {
  Element right(1, 1, -1), left(2, 1, -1);
  set_track(right, true, .4);
  set_track(left, false, .4);
  right.set(cntc_setwheelsetposition, 1, {0, 2, 0, -1e-4, 4.8e-3, 0});
  right.set(cntc_setwheelsetvelocity, 2, {2000, 3, 0, 0, 1e-3, -4.346});
  left.set(cntc_setwheelsetposition, 1, {0, -2, 0, 1e-4, -4.8e-3, 0});
  left.set(cntc_setwheelsetvelocity, 2, {2000, -3, 0, 0, -1e-3, -4.346});
  EXPECT_EQ(right.calculate(), 0);
  EXPECT_EQ(left.calculate(), 0);
  const auto f = right.global_forces(-1), g = left.global_forces(-1);
  for (size_t k = 0; k < 24; ++k) {
    const bool flips = k % 6 == 1 || k % 6 == 3 || k % 6 == 5;
    EXPECT_NEAR(g[k], flips ? -f[k] : f[k], 1e-6 * (1 + std::abs(f[k]))) << k;
  }
  EXPECT_NEAR(left.location(1)[1], -right.location(1)[1], 1e-9);
  EXPECT_NEAR(left.found(1).eta, -right.found(1).eta, 1e-12);
}

TEST(wheel, absolute_placement_and_deviation) {
  Wheel e;
  const auto at = e.location(1);
  const double z = e.position()[2];
  // The rail's origin where the gauge had put it, then moved and turned by its deviation.
  e.set(cntc_settrackdimensions, 1, {0, at[25], at[26], std::atan(1. / 40), 0});
  EXPECT_EQ(e.calculate(), 0);
  EXPECT_NEAR(e.location(1)[1], at[1], 1e-6);
  EXPECT_NEAR(e.position()[2], z, 1e-7);
  e.set(cntc_settrackdimensions, 2, {.3, .2, .001, 0, 0, 0});
  EXPECT_EQ(e.calculate(), 0);
  EXPECT_NEAR(e.location(1)[25], at[25] + .3, 1e-9);
  EXPECT_NEAR(e.location(1)[26], at[26] + .2, 1e-9);
  EXPECT_NEAR(e.location(1)[27], at[27] + .001, 1e-9);
  const double moved = e.position()[2];
  e.set(cntc_settrackdimensions, 1, {14, 0, 1435, std::atan(1. / 40), 0});
  EXPECT_EQ(e.calculate(), 0);
  EXPECT_NEAR(e.position()[2], moved, 1e-5);
}

TEST(wheel, a_bent_wheel_is_a_moved_one) {
  Element e(1, 1, -1);
  set_track(e, true, .4);
  place(e, 2, 0, -4.346);
  EXPECT_EQ(e.calculate(), 0);
  const auto f = e.global_forces(-1);
  place(e, 1.5, 0, -4.346);
  e.set(cntc_setwheelsetposition, 1, {0, 1.5, 0, 0, 4.8e-3, 0});
  e.set(cntc_setwheelsetflexibility, 4, {0, .5, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  EXPECT_EQ(e.calculate(), 0);
  const auto g = e.global_forces(-1);
  for (const size_t k : {0u, 1u, 2u}) EXPECT_NEAR(g[k], f[k], 3);  // the yaw acts on 0.5 mm
  e.set(cntc_setwheelsetflexibility, 1, {});
  place(e, 2, 0, -4.346);
  EXPECT_EQ(e.calculate(), 0);
  EXPECT_NEAR(e.global_forces(-1)[0], f[0], 1e-3);
}

TEST(wheel, given_longitudinal_force) {
  Wheel e;
  e.flags({{CNTC_ic_force, 1}});
  e.forces(-1000, 0);
  EXPECT_EQ(e.calculate(), 0);
  EXPECT_TRUE(near("FX on the rail", e.global_forces(-1)[6], -1000, 1));
  EXPECT_TRUE(near("Fz", e.global_forces(-1)[2], 10000, .1));
  e.forces(-1e5, 0);
  EXPECT_EQ(e.calculate(), CNTC_err_ftot);
}

TEST(wheel, prescribed_height) {
  Wheel e;
  const double z = e.position()[2];
  e.flags({{CNTC_ic_norm, 0}});
  e.set(cntc_setwheelsetposition, 1, {0, 2, z, -1.128e-4, 4.8e-3, 0});
  EXPECT_EQ(e.calculate(), 0);
  EXPECT_TRUE(near("Fz", e.global_forces(-1)[2], 10000, 20));
  e.set(cntc_setwheelsetposition, 1, {0, 2, z - 1, -1.128e-4, 4.8e-3, 0});
  EXPECT_EQ(e.calculate(), 0);  // lifted
  EXPECT_EQ(e.patches(), 0);
  EXPECT_EQ(e.global_forces(-1)[2], 0);
}

TEST(wheel, frames_of_rollcon) {
  for (const bool right : {true, false}) {
    Element e(1, 1, -1);
    set_track(e, right, .2);
    place(e, 2, -1.128e-4, -4.3459197);
    const Found grid = e.solved();
    const auto sums = e.global_forces(-1);
    e.flags({{CNTC_if_frames, 1}});
    const Found frames = e.solved();
    const double limit = .3 * grid.fn;
    EXPECT_TRUE(near("Fn", frames.fn, grid.fn, .001 * grid.fn));
    EXPECT_TRUE(near("Fx", frames.tx, grid.tx, .01 * limit));
    EXPECT_TRUE(near("Fs", frames.ty, grid.ty, .01 * limit));
    EXPECT_TRUE(near("largest pressure", frames.pmax, grid.pmax, .01 * grid.pmax));
    for (const size_t k : {0u, 1u, 2u}) EXPECT_NEAR(e.global_forces(-1)[k], sums[k], 30);
    EXPECT_TRUE(near("area", frames.area, grid.area, .03 * grid.area));
    // Elements belong to the forces found: what is set in between counts from the next solve on.
    e.set(cntc_setfrictionmethod, 0, {.1, .1});
    EXPECT_EQ(e.calculate(), 0);
    const int icp = 1, parameters = 1, three = 3;
    double steps[3] = {}, dx = 0, dy = 0;
    cntc_getparameters(e.ire(), &icp, &parameters, &three, steps);
    EXPECT_EQ(steps[2], .2);
    const double low = e.found(1).ty;
    EXPECT_EQ(e.calculate(), 0);
    e.set(cntc_setfrictionmethod, 0, {.3, .3});
    e.set(cntc_setpotcontact, -1, {.4, .4, 1.57, 8, 4});
    cntc_getgriddiscretization(e.ire(), &icp, &dx, &dy);
    EXPECT_EQ(dx, .2);
    const auto sum = [](const std::vector<double>& v) { return .04 * std::accumulate(v.begin(), v.end(), 0.); };
    EXPECT_TRUE(near("Fs of the elements, friction .1", sum(e.tractions(1)[2]), low, .02 * .1 * grid.fn));
    e.set(cntc_setpotcontact, -1, {.2, .2, 1.57, 8, 4});
    EXPECT_EQ(e.calculate(), 0);
    // Tractions on the caller's grid carry the forces.
    const auto p = e.tractions(1);
    EXPECT_TRUE(near("Fn of the elements", sum(p[0]), grid.fn, .02 * grid.fn));
    EXPECT_TRUE(near("Fs of the elements", sum(p[2]), grid.ty, .02 * limit));
    e.set(cntc_setfrictionmethod, 4, {.14, .19, 1250, 0, 1, 0, 0});
    EXPECT_EQ(e.calculate(), CNTC_err_other);
  }
}

TEST(wheel, slip_of_the_surfaces_and_another_radius) {
  Wheel e(.2);
  const double z = e.position()[2];
  e.flags({{CNTC_ic_discns, 3}});
  EXPECT_EQ(e.calculate(), 0);
  EXPECT_TRUE(near("Fx of the surfaces' slip", e.found(1).tx, -514.2, 3));  // docs/profiles.md
  EXPECT_TRUE(near("ksi", e.found(1).ksi, 8.752e-4, 4e-6));
  // A greater wheel rolls with less creepage; it hangs as high.
  e.set(cntc_setwheelsetdimensions, 3, {1360, -70, 460.2});
  EXPECT_EQ(e.calculate(), 0);
  EXPECT_NEAR(e.position()[2], z, 1e-4);
  EXPECT_TRUE(near("ksi of the greater wheel", e.found(1).ksi, 8.752e-4 + .2 / 460, 5e-6));
  e.set(cntc_setwheelsetdimensions, 3, {1360, -70, 460, 0});  // the radius at the datum
  e.flags({{CNTC_ic_discns, 2}});
  EXPECT_EQ(e.calculate(), 0);
  EXPECT_NEAR(e.position()[2], z, 1e-4);
}

TEST(wheel, simpack_units) {
  Element mm(1, 1, -1), si(2, 1, -1);
  set_track(mm, true, .4);
  place(mm, 2, -1.128e-4, -4.3459197);
  EXPECT_EQ(mm.calculate(), 0);
  set_track(si, true, .4);
  si.flags({{CNTC_if_units, CNTC_un_spck}});
  si.set(cntc_setpotcontact, -1, {.4e-3, .4e-3, 1.57, 8e-3, 4e-3});
  si.set(cntc_settrackdimensions, 1, {14e-3, 0, 1.435, std::atan(1. / 40), 0});
  si.set(cntc_setwheelsetdimensions, 3, {1.36, -.07, .46});
  si.set(cntc_setwheelsetposition, 1, {0, 2e-3, 0, -1.128e-4, 4.8e-3, 0});
  si.set(cntc_setwheelsetvelocity, 2, {2, 0, 0, 0, 0, -4.3459197});
  EXPECT_EQ(si.calculate(), 0);
  const auto f = mm.global_forces(-1), g = si.global_forces(-1);
  for (size_t k = 0; k < 24; ++k) EXPECT_NEAR(g[k], -f[k] / (k % 6 < 3 ? 1 : 1000), 1e-4 * (1 + std::abs(f[k]))) << k;
  EXPECT_NEAR(si.position()[2], mm.position()[2] / 1000, 1e-9);
  EXPECT_NEAR(si.location(1)[1], mm.location(1)[1] / 1000, 1e-9);
  EXPECT_NEAR(si.found(1).ksi, -mm.found(1).ksi, 1e-9);
}

TEST(wheel, subsurface_of_left_and_right) {
  double mises[2][2], sxy[2][2];
  for (const int right : {1, 0}) {
    Element e(1, 1, -1);
    set_track(e, right, .4);
    e.set(cntc_setwheelsetposition, 1, {0, right ? 2. : -2., 0, 0, right ? 4.8e-3 : -4.8e-3, 0});
    e.set(cntc_setwheelsetvelocity, 2, {2000, 0, 0, 0, 0, -4.346});
    const int one = 1, two = 2, nine = 9, all = -1, columns[2] = {8, 14};
    const double x = .3, y = right ? .2 : -.2, z[2] = {-.5, .5};
    subs_addblock(e.ire(), &all, &one, &nine, &one, &one, &two, &x, &y, z);
    EXPECT_EQ(e.calculate(), 0);
    int error = -1;
    subs_calculate(e.ire(), &all, &error);
    EXPECT_EQ(error, 0);
    double v[4];
    subs_getresults(e.ire(), &one, &one, &two, &two, columns, v);
    for (int k = 0; k < 2; ++k) {
      mises[right][k] = v[k];
      sxy[right][k] = v[2 + k];
    }
  }
  for (int k = 0; k < 2; ++k) {
    EXPECT_GT(mises[1][k], 100);
    EXPECT_NEAR(mises[0][k], mises[1][k], 1e-6 * mises[1][k]);
    EXPECT_NEAR(sxy[0][k], -sxy[1][k], 1e-6 * mises[1][k]);
  }
}

TEST(wheel, profile_values) {
  Element e(1, 1, -1);
  set_track(e, true, .4);
  place(e, 2, 0, -4.346);
  EXPECT_EQ(e.calculate(), 0);
  const auto values = [&](int task, std::vector<int> ints, size_t n) {
    std::vector<double> v(n, -777);
    const int count = int(ints.size()), one = 1, length = int(n);
    const double step = 1;
    cntc_getprofilevalues(e.ire(), &task, &count, ints.data(), &one, &step, &length, v.data());
    return v;
  };
  EXPECT_EQ(values(-1, {0}, 2)[0], 0);
  const auto n = size_t(values(0, {0, 1}, 1)[0]);
  ASSERT_GT(n, 50u);
  const auto yz = values(1, {0, 1}, 2 * n), track = values(2, {0, 1}, 2 * n), gauge = values(3, {0, 1}, 6);
  double top = 1e9;
  for (size_t k = 0; k < n; ++k) top = std::min(top, track[n + k]);
  EXPECT_TRUE(near("top of the rail", top, 0, .01));
  // The gauge point is in the rail's axes turned by the cant, which the shift moves to the track.
  EXPECT_TRUE(near("gauge point", gauge[0] + gauge[2], 717.5, 1e-6));
  EXPECT_TRUE(near("its height", gauge[5] + gauge[3], 14, 1e-9));
  EXPECT_TRUE(near("rail's origin, y", gauge[2], e.location(1)[25], .01));
  EXPECT_TRUE(near("rail's origin, z", gauge[3], e.location(1)[26], .01));
  EXPECT_LT(yz[0], yz[n - 1]);
  // Arc lengths are a millimetre apart and count from y = 0.
  const auto arc = values(4, {1, 1}, 3), wheel = values(1, {1, 1}, 2 * n);
  EXPECT_NEAR(arc[2] - arc[0], 2, 1e-12);
  EXPECT_LT(arc[0], wheel[0] + .01);
  EXPECT_EQ(values(0, {0, 3}, 1)[0], 1201);
  EXPECT_EQ(values(3, {1, 0}, 6)[0], CNTC_err_profil);
  EXPECT_EQ(values(6, {0, 1}, 1)[0], -777);  // this rail does not vary
  e.set(cntc_settrackdimensions, 1, {0, 750, 0, std::atan(1. / 40), 0});
  EXPECT_EQ(values(3, {0, 1}, 6)[0], -777);  // it has no gauge now
}

TEST(wheel, steps_of_rolling_come_to_the_steady_state) {
  Wheel e;
  const Found steady = e.found(1);
  e.flags({{CNTC_ic_tang, 2}});
  e.rolling(0, 1);  // steps as long as an element
  const Found first = e.solved();
  e.flags({{CNTC_ic_pvtime, 0}});
  for (int k = 0; k < 40; ++k) EXPECT_EQ(e.calculate(), 0);
  const double limit = .3 * steady.fn;
  EXPECT_GT(std::abs(first.ty - steady.ty), .02 * limit);
  EXPECT_TRUE(near("Fx after 40 steps", e.found(1).tx, steady.tx, .005 * limit));
  EXPECT_TRUE(near("Fs after 40 steps", e.found(1).ty, steady.ty, .005 * limit));
  EXPECT_TRUE(near("Fz", e.global_forces(-1)[2], 10000, .1));
}

TEST(wheel, shifts_of_a_standing_wheel) {
  Element e(1, 1, -1);
  set_track(e, true, .4);
  e.flags({{CNTC_ic_tang, 1}});
  e.set(cntc_setwheelsetposition, 1, {0, 2, 0, 0, 0, 0});
  const auto shift = [&](double along, double across) {
    e.set(cntc_setwheelsetvelocity, 2, {along, across, 0, 0, 0, 0});
    EXPECT_EQ(e.calculate(), 0);
    return e.global_forces(-1);
  };
  const auto pressed = shift(0, 0);
  EXPECT_NEAR(pressed[0], 0, 1);
  const auto moved = shift(1e-3, 0);  // the wheel pushes the rail forward
  EXPECT_GT(moved[0], 100);
  EXPECT_LT(moved[0], 3000);
  e.flags({{CNTC_ic_pvtime, 0}});
  const auto twice = shift(1e-3, 0), back = shift(-2e-3, 0);
  EXPECT_GT(twice[0], moved[0]);
  EXPECT_LT(back[0], moved[0]);
}

TEST(wheel, friction_by_inclination_takes_the_reference) {
  Wheel e;
  e.set(cntc_setfrictionmethod, 10, {2, -.5, .1, .1, .5, .6, .6});
  EXPECT_EQ(e.calculate(), 0);
  const double delta = e.location(1)[3], mu = .1 + (delta + .5) * .5;
  e.set(cntc_setfrictionmethod, 0, {mu, mu});
  const Found by_angle = e.found(1);
  EXPECT_EQ(e.calculate(), 0);
  EXPECT_TRUE(near("Fx", by_angle.tx, e.found(1).tx, 1));
}

TEST(wheel, place_along_the_track_does_not_matter) {
  Wheel e;
  const Found here = e.found(1);
  const auto at = e.location(1);
  e.set(cntc_setwheelsetposition, 1, {5000, 2, 0, -1.128e-4, 4.8e-3, 0});
  EXPECT_EQ(e.calculate(), 0);
  EXPECT_NEAR(e.found(1).tx, here.tx, 1e-3);
  EXPECT_NEAR(e.found(1).ksi, here.ksi, 1e-9);
  for (const size_t k : {0u, 1u, 2u}) EXPECT_NEAR(e.location(1)[k], at[k], 1e-6);
}

/// Solves on the caller's grid, then on rollcon's frames, and tells whether both agree within 1 %.
void expect_frames_agree(Element& e) {
  EXPECT_EQ(e.calculate(), 0);
  const auto grid = e.global_forces(-1);
  const Found patch = e.found(1);
  EXPECT_GT(patch.fn, 1000);
  e.flags({{CNTC_if_frames, 1}});
  EXPECT_EQ(e.calculate(), 0);
  const auto frames = e.global_forces(-1);
  const double limit = .3 * grid[2];
  for (const size_t k : {0u, 1u}) EXPECT_TRUE(near("force", grid[k], frames[k], .012 * limit));
  EXPECT_TRUE(near("Fz", grid[2], frames[2], 1e-4 * grid[2]));
  EXPECT_TRUE(near("ksi", patch.ksi, e.found(1).ksi, 2e-5));
  EXPECT_TRUE(near("pmax", patch.pmax, e.found(1).pmax, .02 * patch.pmax));
  e.flags({{CNTC_if_frames, 0}});
}

TEST(wheel, on_a_roller) {
  Element rail(1, 1, -1), vast(2, 1, -1), left(3, 1, -1);
  const auto stand = [](Element& e, bool right, double radius) {
    set_track(e, right, .2);
    const int config = radius > 0 ? (right ? 5 : 4) : right;
    e.flags({{CNTC_ic_config, config}});
    const double side = right ? 1 : -1;
    e.set(cntc_settrackdimensions, 1, {14, 0, 1435, 0, radius});
    e.set(cntc_setwheelsetposition, 1, {0, side * 2, 0, -1.128e-4 * side, 4.8e-3 * side, 0});
    e.set(cntc_setwheelsetvelocity, 2, {radius > 0 ? 2000 / radius : 2000, 0, 0, 0, 0, -4.3459197});
  };
  stand(rail, true, 0);
  stand(vast, true, 1e7);
  EXPECT_EQ(rail.calculate(), 0);
  EXPECT_EQ(vast.calculate(), 0);
  const Found on_rail = rail.found(1), on_vast = vast.found(1);
  EXPECT_TRUE(near("Fx", on_vast.tx, on_rail.tx, 1));
  EXPECT_TRUE(near("Fs", on_vast.ty, on_rail.ty, 1));
  EXPECT_TRUE(near("pmax", on_vast.pmax, on_rail.pmax, .1));
  EXPECT_NEAR(vast.position()[2], rail.position()[2], 1e-4);
  double velocity[6];
  const int six = 6;
  cntc_getwheelsetvelocity(vast.ire(), &six, velocity);
  EXPECT_EQ(velocity[0], 2e-4);
  // A small roller presses harder; the calls' own contact and rollcon's wheel on a roller agree.
  stand(vast, true, 500);
  stand(left, false, 500);
  EXPECT_EQ(vast.calculate(), 0);
  EXPECT_EQ(left.calculate(), 0);
  EXPECT_GT(vast.found(1).pmax, 1.1 * on_rail.pmax);
  const auto f = vast.global_forces(-1), g = left.global_forces(-1);
  EXPECT_NEAR(g[0], f[0], 1e-3);
  EXPECT_NEAR(g[1], -f[1], 1e-3);
  expect_frames_agree(vast);
  const double x = vast.location(1)[20];
  vast.set(cntc_setwheelsetposition, 1, {3, 2, 0, -1.128e-4, 4.8e-3, 0});
  expect_frames_agree(vast);
  EXPECT_NEAR(vast.location(1)[20], x + 3, 1e-6);  // the wheel's origin, from the roller's axis
  vast.set(cntc_setwheelsetvelocity, 2, {0, 0, 0, 0, 0, -4.3459197});
  EXPECT_EQ(vast.calculate(), CNTC_err_search);
  stand(vast, true, 500);
  vast.set(cntc_settrackdimensions, 1, {14, 0, 1435, 0, 0});
  EXPECT_EQ(vast.calculate(), CNTC_err_search);
  stand(vast, true, 0);
  vast.flags({{CNTC_ic_config, 1}});
  EXPECT_EQ(vast.calculate(), 0);
  EXPECT_NEAR(vast.found(1).tx, on_rail.tx, 1e-3);
}

/// Writes a list of slices of a profile, deeper by `depth` at each place.
std::string write_slices(const std::string& name, const char* shape, const std::vector<double>& place,
                         const std::vector<double>& depth) {
  const auto yz = cntc_test::profile_points(shape);
  const std::string path = cntc_test::folder() + "/" + name;
  std::ofstream list(path);
  list << "0. 1.\n" << place.size() << "\n0 0 0\n1\n";
  for (size_t k = 0; k < place.size(); ++k) {
    const std::string slice = name + std::to_string(k) + ".txt";
    list << place[k] << " '" << slice << "'\n";
    std::ofstream file(cntc_test::folder() + "/" + slice);
    file.precision(15);
    for (size_t i = 0; i + 1 < yz.size(); i += 2) file << yz[i] << " " << yz[i + 1] + depth[k] << "\n";
  }
  return path;
}

void take_profile(Element& e, const std::string& path) {
  const int length = int(path.size()), ints = 4, none = 0, options[4] = {-1, 0, 0, -1};
  const double no = 0;
  cntc_setprofileinputfname(e.ire(), path.c_str(), &length, &ints, options, &none, &no);
}

// A filter of order m keeps 1 / (1 + (length / wave)^2m) of a wave; kind 0 is given by (length / 2 pi)^4.
TEST(wheel, smooths_profiles_by_the_order_of_the_kind) {
  Element e(1, 1, -1);
  const double wave = 12, height = .01, pi = 3.141592653589793, length = 1.3 * wave;
  const std::string path = cntc_test::folder() + "/wave.prr.txt";
  std::ofstream file(path);
  file.precision(15);
  for (int k = -120; k <= 120; ++k) file << .5 * k << " " << height * std::cos(pi * k / wave) << "\n";
  file.close();
  for (const int kind : {0, 1, 2}) {
    const int size = int(path.size()), ints = 6, options[6] = {0, 0, 0, -1, 0, kind}, reals = 2;
    const double real[2] = {1, kind == 0 ? std::pow(length / (2 * pi), 4) : length};
    cntc_setprofileinputfname(e.ire(), path.c_str(), &size, &ints, options, &reals, real);
    const int task = 1, two = 2, type[2] = {0, 1}, count = 482;
    const double step[2] = {.5, 0};
    std::vector<double> yz(482);
    cntc_getprofilevalues(e.ire(), &task, &two, type, &two, step, &count, yz.data());
    double kept = 0;
    for (size_t k = 49; k <= 192; ++k) kept += std::cos(2 * pi * yz[k] / wave) * yz[241 + k] / (72 * height);
    const double expected = 1 / (1 + std::pow(1.3, kind == 2 ? 6 : 4));
    std::printf("kind %d keeps %.4f of a wave, expected %.4f\n", kind, kept, expected);
    EXPECT_NEAR(kept, expected, .02 * expected) << kind;
  }
}

TEST(wheel, on_a_variable_rail) {
  Element e(1, 1, -1);
  set_track(e, true, .2);
  e.set(cntc_settrackdimensions, 1, {0, 753.4, .2, std::atan(1. / 40), 0});
  place(e, 2, -1.128e-4, -4.3459197);
  const Found plain = e.solved();
  const double z = e.position()[2], x = e.location(1)[0];
  take_profile(e, write_slices("equal.slcs", "60e1", {-100, 0, 100}, {0, 0, 0}));
  e.set(cntc_setwheelsetposition, 1, {40, 2, 0, -1.128e-4, 4.8e-3, 0});
  EXPECT_EQ(e.calculate(), 0);
  EXPECT_NEAR(e.position()[2], z, 1e-5);
  EXPECT_TRUE(near("Fx", e.found(1).tx, plain.tx, .5));
  EXPECT_TRUE(near("Fs", e.found(1).ty, plain.ty, .5));
  // Lines of the surface: a section, a line along it, a slice at a y.
  const auto values = [&](int task, std::vector<double> reals, size_t n) {
    std::vector<double> v(n, -777);
    const int type[2] = {0, 1}, two = 2, count = int(reals.size()), length = int(n);
    cntc_getprofilevalues(e.ire(), &task, &two, type, &count, reals.data(), &length, v.data());
    return v;
  };
  const double slope = .02;
  take_profile(e, write_slices("ramp.slcs", "60e1", {-100, 0, 100}, {100 * slope, 0, -100 * slope}));
  const auto points = cntc_test::profile_points("60e1");
  EXPECT_EQ(values(7, {10, 120}, 1)[0], 21);
  EXPECT_EQ(values(6, {1, 50, 1, 61}, 1)[0], 61);
  const auto along = values(7, {10, 120}, 63), slice = values(8, {25, 0, -50, 50}, 15),
             section = values(6, {.5, 50, 1, 5.5}, 30);
  for (size_t k = 0; k < 21; ++k) {
    EXPECT_NEAR(along[k], -100 + 10. * double(k), 1e-9);
    EXPECT_NEAR(along[21 + k], along[21], 1e-9);
    EXPECT_NEAR(along[42 + k] - along[42], -slope * 10 * double(k), 1e-6);
  }
  for (size_t k = 0; k < 5; ++k) EXPECT_NEAR(slice[10 + k], slope * (50 - 25. * double(k)), 1e-3);
  EXPECT_EQ(section[0], 50);
  EXPECT_NEAR(section[10], points[0], 1e-6);
  EXPECT_NEAR(section[20], points[1] - 50 * slope, 1e-6);
  EXPECT_EQ(values(8, {25, 999, -50, 50}, 15)[10], 999);  // there is no such y
  EXPECT_EQ(values(8, {25, 0, -50, 50}, 14)[0], -777);    // the array is too short
  // Sections of tasks 0 to 5 are those at a place.
  const int n = int(values(0, {1, 100}, 1)[0]);
  const auto there = values(1, {1, 100}, 2 * size_t(n)), here = values(1, {1, 0}, 2 * size_t(n));
  EXPECT_NEAR(there[size_t(3 * n / 2)] - here[size_t(3 * n / 2)], -100 * slope, 1e-6);
  // A crest 8 mm ahead of the wheelset lifts it and draws its patch forward.
  const double high = .02;
  take_profile(e, write_slices("crest.slcs", "60e1", {-60, -20, 0, 20, 40, 60, 100},
                               {0, 0, -.25 * high, -high, -.25 * high, 0, 0}));
  e.set(cntc_setwheelsetposition, 1, {12, 2, 0, -1.128e-4, 4.8e-3, 0});
  expect_frames_agree(e);
  EXPECT_GT(e.location(1)[0], x + .3);
  EXPECT_LT(e.position()[2], z);
  e.set(cntc_settrackdimensions, 1, {14, 0, 1435, std::atan(1. / 40), 0});
  EXPECT_EQ(e.calculate(), CNTC_err_profil);  // a variable rail has no gauge
}

TEST(wheel, that_is_out_of_round) {
  Wheel e(.2);
  const Found plain = e.found(1);
  const double z = e.position()[2];
  std::vector<double> place, depth;
  for (int k = 0; k < 64; ++k) {
    place.push_back(-3.141592 + k * .09817477);
    depth.push_back(.05 * std::sin(4 * place.back()));
  }
  take_profile(e, write_slices("round.slcw", "s1002", place, std::vector<double>(64, 0)));
  EXPECT_EQ(e.calculate(), 0);
  EXPECT_TRUE(near("Fx", e.found(1).tx, plain.tx, .5));
  take_profile(e, write_slices("polygon.slcw", "s1002", place, depth));
  for (const double pitch : {.4, -.4}) {
    e.set(cntc_setwheelsetposition, 1, {0, 2, 0, -1.128e-4, 4.8e-3, pitch});
    expect_frames_agree(e);
    // What is below the axle was ahead of it before a wheel turned forward, to negative pitch.
    EXPECT_TRUE(near("z", e.position()[2] - z, -.05 * std::sin(4 * -pitch), 2e-3));
  }
}

TEST(wheel, on_a_massless_rail) {
  Element e(1, 1, -1), left(2, 1, -1);
  for (const bool right : {true, false}) {
    Element& on = right ? e : left;
    const double side = right ? 1 : -1;
    set_track(on, right, .4);
    on.set(cntc_setwheelsetposition, 1, {0, side * 6.5, 0, -4.376e-3 * side, 0, 0});
    on.set(cntc_setwheelsetvelocity, 2, {2000, 0, 0, 0, 0, -4.2748834});
    on.flags({{CNTC_ic_force, 3}});
    on.set(cntc_settrackdimensions, 32, {20000, side * -500, 50000, 1000});
    EXPECT_EQ(on.calculate(), 0);
  }
  const auto f = e.global_forces(-1), g = left.global_forces(-1);
  const double dy = e.location(1)[17], dz = e.location(1)[18];
  EXPECT_GT(dy, .01);
  // Stiffness times deflection is the force of the wheel and that of FYRAIL, FZRAIL.
  EXPECT_TRUE(near("ky dy", 20000 * dy, f[1] - 500, .2));
  EXPECT_TRUE(near("kz dz", 50000 * dz, f[2] + 1000, .2));
  EXPECT_NEAR(left.location(1)[17], -dy, 1e-9);
  EXPECT_NEAR(g[1], -f[1], 1e-3);
  // A rigid rail with this deviation has these forces.
  e.flags({{CNTC_ic_force, 0}});
  e.set(cntc_settrackdimensions, 2, {dy, dz, 0, 0, 0, 0});
  EXPECT_EQ(e.calculate(), 0);
  EXPECT_TRUE(near("Fy", e.global_forces(-1)[1], f[1], .005 * f[1]));
  EXPECT_EQ(e.location(1)[17], 0);
}

TEST(wheel, what_is_absent_is_refused) {
  Element e(1, 1, -1);
  EXPECT_EQ(e.calculate(), CNTC_err_profil);
  set_track(e, true, .5);
  place(e, 2, 0, -4.346);
  e.flags({{CNTC_ic_discns, 8}});
  EXPECT_EQ(e.calculate(), CNTC_err_discr);
  e.flags({{CNTC_ic_discns, 2}});
  e.set(cntc_setwheelsetvelocity, 2, {0, 0, 0, 0, 0, -4.3});
  EXPECT_EQ(e.calculate(), CNTC_err_search);
  place(e, -200, 0, -4.346);
  EXPECT_LT(e.calculate(), 0);  // beside the rail
  const char name[] = "no_such_profile.prr";
  const int length = int(sizeof name) - 1, zero = 0, none = 0;
  const double no = 0;
  place(e, 2, 0, -4.346);
  EXPECT_EQ(e.calculate(), 0);
  cntc_setprofileinputfname(e.ire(), name, &length, &zero, &none, &zero, &no);
  EXPECT_EQ(e.calculate(), CNTC_err_profil);
  const char variable[] = "switch.slcs";
  const int longer = int(sizeof variable) - 1;
  cntc_setprofileinputfname(e.ire(), variable, &longer, &zero, &none, &zero, &no);
  EXPECT_EQ(e.calculate(), CNTC_err_profil);
}

}  // namespace
