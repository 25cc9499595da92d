/// Tests contacts whose normals turn within the patch, on half-spaces that follow the profiles.

#include <utility>

#include "framing/makers.hpp"
#include "support/persson.hpp"
#include "wheel_rail_fixture.hpp"

using namespace rollcon;

namespace {

constexpr double degree = std::numbers::pi / 180;

/// Returns the largest pressure in mid-plane of a long pin, relative to the closed form under the same load.
double pressure_of_a_pin(const std::shared_ptr<Context>& context, bool conformal, double sunk, double reach) {
  constexpr double radius = 10, clearance = 0.05, young = 2e5, poisson = 0.3, half_length = 80;
  constexpr std::int64_t nx = 16, ny = 40;
  std::shared_ptr<Body> body[2];
  for (std::size_t b = 0; b < 2; ++b) {
    body[b] = std::make_shared<Body>(context, static_cast<std::int32_t>(BodyKind::halfspace));
    body[b]->set_elastic(0, young, poisson);
    const double arc[2] = {b == 0 ? radius - clearance : radius, 0.95 * radius};
    body[b]->set_profile_shape("arc", 2, arc);
    const double zero[3] = {0, 0, 0}, x[3] = {1, 0, 0}, z[3] = {0, 0, 1};
    body[b]->extrude_profile(zero, x, z);
  }
  Contact contact(context, body[0], body[1]);
  Scene& scene = contact.scene;
  scene.options.set_int("conformal", conformal ? 1 : 0);
  const double none = 0;
  scene.set_friction("coulomb", 1, &none);
  scene.prescribe(static_cast<std::int32_t>(Direction::normal), static_cast<std::int32_t>(How::by_motion), sunk);
  scene.set_made_frame(
      rectangle_mesh(scene.axes(), ElementType::quad4, nx, ny, {-half_length, half_length, -reach, reach}), false,
      true);
  contact.solve();  // RIM_CONTACT: the pin goes on
  std::vector<double> all(static_cast<std::size_t>((nx + 1) * (ny + 1)));
  contact.field(Field::pressure, InAxes::local, std::ssize(all), all.data());
  const auto pressure = [&](std::int64_t j) { return all[static_cast<std::size_t>(j * (nx + 1) + nx / 2)]; };
  double load = 0, largest = 0;
  for (std::int64_t j = 0; j <= ny; ++j) {
    load += pressure(j) * 2 * reach / static_cast<double>(ny);  // along the axes' normal: p cos ds = p dy
    largest = std::max(largest, pressure(j));
  }
  EXPECT_EQ(pressure(0), 0);
  const double wanted = clearance * young / (1 - poisson * poisson) / load;
  double low = 0.01, high = 1.4;
  while (high - low > 1e-12) {
    const double middle = 0.5 * (low + high);
    (Persson(middle).clearance() > wanted ? low : high) = middle;
  }
  report("pin in a plate: angle of contact, degrees", low / degree);
  return largest * radius / load / Persson(low).pressure(0) - 1;
}

/// Makes a wheel whose tread is an arc of radius 10, in a groove of nearly that radius, with a rolling radius of 420.
/// Units are mm, N, s.
class conformal : public wheels {
 protected:
  static constexpr double wide = 9, corner = 1, gauge = 1435;
  double middle = 0, bottom = 0;  ///< places of the groove in the track

  std::unique_ptr<WheelRail> in_groove(double groove, double unit = 1, std::int32_t side = 1) {
    for (auto* body : {&wheel, &rail}) {
      *body = std::make_shared<Body>(context, static_cast<std::int32_t>(BodyKind::halfspace));
      (*body)->set_elastic(0, 2 * 80000 * 1.28 / (unit * unit), 0.28);
    }
    const double tread[2] = {10 * unit, wide * unit};
    wheel->set_profile_shape("arc", 2, tread);
    // The profile goes up the gauge face, round the corner, through the groove.
    const double slope = std::asin(wide / groove);
    const double y = -wide - corner * (1 + std::sin(slope)),
                 z = -(1 - std::cos(slope)) * groove + corner * std::cos(slope);
    const double chain[9] = {y * unit,
                             (z + 20) * unit,
                             -std::numbers::pi / 2,
                             20 * unit,
                             0,
                             corner * (std::numbers::pi / 2 + slope) * unit,
                             1 / (corner * unit),
                             2 * slope * groove * unit,
                             -1 / (groove * unit)};
    rail->set_profile_shape("arcs", 9, chain);
    bottom = corner - z;
    auto w = std::make_unique<WheelRail>(context, wheel, rail, side);
    w->set_track(gauge * unit, 14 * unit, 0);
    w->set_wheelset((gauge - 2 * y) * unit, 0, 420 * unit);
    w->set_friction(mu);
    w->set_real("accuracy", 0.02);
    w->set_int("conformal", 1);
    w->prescribe_vertical(static_cast<std::int32_t>(How::by_force), 10000);
    return w;
  }
  static void move(WheelRail& w, double pitch_rate, double unit = 1, double y = 0, double yaw = 0) {
    const double position[6] = {0, y * unit, 0, 0, yaw, 0}, velocity[6] = {420 * unit, 0, 0, 0, 0, pitch_rate};
    w.set_position(position);
    w.set_velocity(velocity);
  }
  /// Returns by secants the pitch rate at which the wheel rolls freely.
  static double roll_freely(WheelRail& w) {
    double a = -1.0002, b = -1.0008;
    const auto force = [&](double rate) {
      move(w, rate);
      EXPECT_EQ(w.solve(), Status::ok);
      double f[6];
      w.resultant(false, f, f + 3);
      return f[0];
    };
    double fa = force(a), fb = force(b);
    for (int i = 0; i < 20 && std::abs(fb) > 1e-3; ++i) {
      const double next = b - fb * (b - a) / (fb - fa);
      a = std::exchange(b, next);
      fa = std::exchange(fb, force(b));
    }
    return b;
  }
};

using conformal_long = conformal;

}  // namespace

TEST(conformal_pin, in_a_plate_as_in_closed_form) {
  const auto context = std::make_shared<Context>();
  struct Case {
    double sunk, reach, bound, flat;
  };
  // Planar frames have a twentieth too little at 36 degrees.
  for (const auto& [sunk, reach, bound, flat] : {Case{0.03, 6.8, 0.002, 0.02}, Case{0.06, 8.2, 0.002, 0.045}}) {
    expect_error("largest pressure, conformal", pressure_of_a_pin(context, true, sunk, reach), bound);
    EXPECT_LT(pressure_of_a_pin(context, false, sunk, reach), -flat);
  }
}

// CONTACT's numbers have the half-space's influence along and across the curved surface as in a plane, which does not
// turn: the closed form above has its pressures 28 percent too high at 36 degrees. Where wheels roll freely depends on
// which nodes of a lattice lie within the contact: by 1 to 5 % on 16 x 32, 20 x 40 and 32 x 64 intervals.
TEST_F(conformal_long, wheel_in_a_groove_beside_contact) {
  struct Reference {
    double groove, z, pitch_rate, power;
    double z_bound, slip_bound, power_bound;
  };
  for (const Reference& r : {Reference{10.25, 0.0224, -1.0002301, 83.95, 0.01, 0.05, 0.18},
                             {10.05, 0.0174, -1.0006495, 644.4, 0.025, 0.05, 0.12}}) {
    auto w = in_groove(r.groove);
    w->set_real("accuracy", 0.01);
    const double rate = roll_freely(*w);
    const std::string name = "R10 in R" + std::to_string(r.groove).substr(0, 5) + ": ";
    expect_error(name + "height", relative(w->stat("z") - bottom, r.z), r.z_bound);
    expect_error(name + "pitch rate less V / r, of that", relative(rate + 1, r.pitch_rate + 1), r.slip_bound);
    expect_error(name + "power", relative(w->patch_stat(0, "friction_power"), r.power), r.power_bound);
    EXPECT_EQ(w->patches(), 1);
  }
}

TEST_F(conformal, agrees_with_a_plane_where_normals_hardly_turn) {
  // The normals on the tread at y = 2 mm turn by less than 6 degrees.
  auto w = make();
  w->set_real("accuracy", 0.005);
  w->prescribe_vertical(static_cast<std::int32_t>(How::by_force), 10000);
  double total[2][6], pressure[2];
  for (const int on : {0, 1}) {
    w->set_int("conformal", on);
    EXPECT_EQ(w->solve(), Status::ok);
    w->resultant(false, total[on], total[on] + 3);
    pressure[on] = w->patch_stat(0, "max_pressure");
  }
  expect_error("y = 2 mm: longitudinal force over mu N", (total[1][0] - total[0][0]) / (mu * 10000), 1e-3);
  expect_error("y = 2 mm: lateral force over mu N", (total[1][1] - total[0][1]) / (mu * 10000), 1e-3);
  expect_error("y = 2 mm: largest pressure", relative(pressure[1], pressure[0]), 2e-3);  // strips: 0.14 %
  EXPECT_NE(total[1][0], total[0][0]);
}

TEST_F(conformal, does_not_depend_on_side_units_or_what_was_solved_before) {
  const auto result = [&](WheelRail& w, double unit, double side) {
    move(w, -1.0003, unit, 0.1 * side, 2e-4 * side);
    EXPECT_EQ(w.solve(), Status::ok);
    double f[6];
    w.resultant(false, f, f + 3);
    return std::array<double, 6>{f[0], side * f[1], f[2], side * f[3] / unit, f[4] / unit, side * f[5] / unit};
  };
  auto right = in_groove(10.25);
  const auto reference = result(*right, 1, 1);
  EXPECT_GT(std::abs(reference[1]), 100);
  const auto close = [&](const char* name, const std::array<double, 6>& other) {
    for (std::size_t i = 0; i < 6; ++i)
      expect_error(std::string(name) + ", total " + std::to_string(i),
                   (other[i] - reference[i]) / (i < 3 ? 1e4 : 1e4 * 420), 1e-9);
  };
  close("left wheel", result(*in_groove(10.25, 1, -1), 1, -1));
  close("metres", result(*in_groove(10.25, 1e-3), 1e-3, 1));
  // The solve is warm, after another place, a plane and a restored state.
  right->reset();
  EXPECT_EQ(result(*right, 1, 1), reference);
  right->snapshot(0);
  const auto twin = right->copy();
  move(*right, -1.0003, 1, -0.05, 1e-4);
  right->set_int("conformal", 0);
  EXPECT_EQ(right->solve(), Status::ok);
  right->rollback(0);
  double f[6];
  right->resultant(false, f, f + 3);
  EXPECT_EQ(f[2], reference[2]);
  twin->resultant(false, f, f + 3);
  EXPECT_EQ(f[1], reference[1]);
}

TEST_F(conformal, derivatives_are_those_of_differences) {
  auto w = in_groove(10.25);
  const auto lateral = [&](double y) {
    move(*w, -1.0003, 1, y, 1e-4);
    EXPECT_EQ(w->solve(), Status::ok);
    double f[6];
    w->resultant(false, f, f + 3);
    return f[1];
  };
  const double step = 2e-4, difference = (lateral(0.08 + step) - lateral(0.08 - step)) / (2 * step);
  lateral(0.08);
  const WheelRail::Derivative d = w->derivative(1);
  expect_error("lateral force by y", relative(d.force[1], difference), 0.015);
  EXPECT_GT(std::abs(difference), 100);
}

TEST_F(conformal, tables_are_left_aside_and_stresses_inside_refused) {
  auto w = in_groove(10.25);
  move(*w, -1.0003);
  EXPECT_EQ(w->solve(), Status::ok);
  EXPECT_EQ(w->patch_stat(0, "by_table"), 0);
  const double point[3] = {0, 0, -1};
  double stress[6];
  refused([&] { w->contact(0)->fields_at(1, false, 1, point, nullptr, stress); }, Status::err_unsupported,
          {"conformal", "plane"});
  refused([&] { w->set_int("conformal", 2); }, Status::err_option, {"conformal", "0 to 1"});
}

TEST_F(conformal, patches_too_steep_are_named_and_the_wheel_goes_on) {
  auto w = in_groove(10.05);
  move(*w, -1.0005);
  w->prescribe_vertical(static_cast<std::int32_t>(How::by_force), 8e4);
  refused([&] { w->solve(); }, Status::err_mesh, {"60 degrees", "option conformal", "y = "});
  w->prescribe_vertical(static_cast<std::int32_t>(How::by_force), 1e4);
  EXPECT_EQ(w->solve(), Status::ok);
}

// The flange's contact turns by a few degrees, and its rolling radius by the same path.
TEST_F(conformal_long, goes_through_flange_contact) {
  auto plane = make(), along = make();
  along->set_int("conformal", 1);
  double worst = 0, pressure = 0;
  for (double y = 0; y <= 10; y += 1) {
    double f[2][6], p[2] = {};
    for (const std::size_t i : {0U, 1U}) {
      WheelRail& w = i == 0 ? *plane : *along;
      w.set_real("accuracy", 0.01);
      w.prescribe_vertical(static_cast<std::int32_t>(How::by_force), 10000);
      place(w, y);
      EXPECT_EQ(w.solve(), Status::ok) << y;
      w.resultant(false, f[i], f[i] + 3);
      for (std::int64_t k = 0; k < w.patches(); ++k) p[i] = std::max(p[i], w.patch_stat(k, "max_pressure"));
    }
    worst = std::max({worst, std::abs(f[1][0] - f[0][0]), std::abs(f[1][1] - f[0][1])});
    pressure = std::max(pressure, relative(p[1], p[0]));
  }
  expect_error("0 to 10 mm: forces beside those in a plane, over mu N", worst / (mu * 10000), 0.04);
  // At y = 0 the nodes of 20 x 40 intervals are 4.4 % above strips of three counts, which agree to 0.1 %.
  expect_error("0 to 10 mm: largest pressures", pressure, 0.05);
}
