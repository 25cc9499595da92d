// Tests bodies given by sections against closed forms and Fourier series.

#include <cmath>
#include <numbers>

#include "bodies/body.hpp"
#include "support/loaded_ring.hpp"
#include "support/section_bodies.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

namespace loaded_ring = statics::loaded_ring;
using loaded_ring::Load;
using sections::SectionBody;

constexpr double pi = std::numbers::pi;

/// Makes a layer of the patch |s| <= 1 over the whole width, at the top.
SurfaceMesh patch(int parts) {
  SurfaceMesh layer;
  layer.offset = {0};
  const int n = 2 * parts;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      const double a = (2.0 * i / n - 1) / loaded_ring::outer, y = loaded_ring::side * (2.0 * j / n - 1);
      layer.node.push_back({loaded_ring::outer * std::sin(a), y, loaded_ring::outer * std::cos(a)});
    }
  const auto id = [&](int i, int j) { return static_cast<std::int32_t>(i * (n + 1) + j); };
  for (int i = 0; i < n; i += 2)
    for (int j = 0; j < n; j += 2)
      surfaces::add_element(layer, ElementType::quad9,
                            {id(i, j), id(i + 2, j), id(i + 2, j + 2), id(i, j + 2), id(i + 1, j), id(i + 2, j + 1),
                             id(i + 1, j + 2), id(i, j + 1), id(i + 1, j + 1)});
  return layer;
}

loaded_ring::Answer loaded(SectionBody& ring, Load kind, int parts) {
  const SurfaceMesh layer = patch(parts);
  loaded_ring::Answer a;
  a.mesh = &ring.surface();
  a.node = loaded_ring::nodes_near_patch(ring.surface());
  const auto rows = ring.body().response()->rows({{}, layer, a.node}, 1);
  std::vector<double> t;
  for (const Vec3& x : layer.node) {
    const Vec3 value = loaded_ring::traction(kind, x);
    t.insert(t.end(), value.begin(), value.end());
  }
  std::vector<double> u(3 * a.node.size());
  multiply(rows->u.data(), rows->u.rows(), rows->u.columns(), t.data(), 0, u.data());
  for (std::size_t k = 0; k < a.node.size(); ++k) a.u.push_back({u[3 * k], u[3 * k + 1], u[3 * k + 2]});
  return a;
}

TEST(Section, moves_the_ring_under_a_patch_as_listed) {
  const sections::Rectangle shape{sections::fine_at_ends(12, -4, 4), sections::fine_at_ends(12, 25, 50)};
  for (const double poisson : {0.3, 0.49}) {
    SectionBody ring(sections::rectangle(shape, ElementType::quad8), loaded_ring::young, poisson);
    ring.tag_sides(shape).contact(4).turn_about_y();
    ring.body().set_int("stations", 3000);
    ring.hold([](const Vec3& x) { return x[2] < 25 + 1e-9; }).prepare();
    report("surface nodes", static_cast<double>(ring.surface().nodes()));
    for (const Load kind : {Load::normal, Load::tangential, Load::axial}) {
      if (poisson > 0.3 && kind != Load::normal) continue;
      const auto answer = loaded(ring, kind, 8);
      for (const auto& e : loaded_ring::listed_errors(answer, kind, poisson))
        if (e.what.find("mean") == std::string::npos)
          expect_error(e.what, e.error, e.what.find(",4)") == std::string::npos ? 1.5e-3 : 4e-3);
    }
  }
}

double near(double a, double b) {
  return std::abs(a - b);
}

/// Returns the section of a tube between radii 1 and 2, y from 0 to 1, tags as Rectangle.
SectionBody tube(ElementType type, int n, double poisson = 0.3) {
  sections::Rectangle shape;
  for (int k = 0; k <= n; ++k) shape.z.push_back(1 + static_cast<double>(k) / n);
  for (int k = 0; k <= n / 2; ++k) shape.y.push_back(2.0 * k / n);
  SectionBody body(sections::rectangle(shape, type), 1000, poisson);
  body.tag_sides(shape);
  return body;
}

/// Observes the order at which the error of radial displacements falls with 4 and 8 elements through the wall.
template <class Error>
void expect_falls(const std::string& what, const Error& error, double bound, double least) {
  const double coarse = error(4), fine = error(8);
  expect_error(what + ", 4 elements", coarse, 20 * bound);
  expect_error(what + ", 8 elements", fine, bound);
  expect_order(what, observed_order(coarse, fine, 2, 1), least);
}

// Lame's ring in plane strain: u = (1 + nu) p / (3 E) ((1 - 2 nu) r + 4 / r) under pressure p at radius 1 of 1 to 2.
TEST(Section, lame) {
  for (const double nu : {0.3, 0.4999})
    for (const ElementType type : {ElementType::quad8, ElementType::tri6}) {
      const auto error = [&](int n) {
        SectionBody body = tube(type, n, nu);
        body.turn_about_y().contact(4).hold([](const Vec3&) { return true; }, 2);
        body.hold([](const Vec3& x) { return near(x[1], 0) < 1e-9 && near(x[2], 1) < 1e-9; }, 1);
        body.body().set_pressure(3, 60);
        body.prepare();
        const double exact = (1 + nu) * 60 / (3 * 1000) * ((1 - 2 * nu) * 2 + 4.0 / 2);
        return body.displacement({0, 0, 2})[2] / exact - 1;
      };
      expect_falls("Lame, " + surfaces::name_of(type) + ", nu " + std::to_string(nu).substr(0, 6), error, 1e-4, 2.4);
    }
}

// A rotating annular disc, free to become thinner: u(1) = rho w^2 / (4 E) ((1 - nu) r_i^3 + (3 + nu) r_i r_o^2) for a
// thin one; a section with nu = 0 has exactly that.
TEST(Section, rotating_disc) {
  const auto error = [](int n) {
    SectionBody body = tube(ElementType::quad8, n, 0);
    body.turn_about_y().contact(4);
    body.hold([](const Vec3& x) { return near(x[1], 0) < 1e-9 && near(x[2], 1) < 1e-9; }, 3);
    const double origin[] = {0, 3, 0}, rate[] = {0, 2, 0};
    body.body().set_rotation(0, 5, origin, rate);
    body.prepare();
    const double exact = 5 * 4 / (4 * 1000.0) * (8 + 3 * 2);  // at r = 2: (1 - nu) r_o^3 + (3 + nu) r_o r_i^2
    return body.displacement({0, 0.5, 2})[2] / exact - 1;
  };
  expect_falls("rotating disc", error, 1e-4, 2.7);
}

// A tube twisted by its end: u_theta = theta r y, exact in quadratic elements.
TEST(Section, torsion_and_uniform_strain) {
  for (const ElementType type : surfaces::all_types) {
    SectionBody body = tube(type, 4);
    body.turn_about_y().contact(4);
    const auto ends = [](const Vec3& x) { return near(x[1], 0) < 1e-9 || near(x[1], 1) < 1e-9; };
    // x is along the way: positive towards a x e_r.
    const double sign = cross(Vec3{0, 1, 0}, Vec3{0, 0, 1})[0];
    body.hold(ends, 7, [&](const Vec3& x) { return Vec3{sign * 0.01 * x[2] * x[1], 0.02 * x[1], -0.3 * 0.02 * x[2]}; });
    body.prepare();
    const Vec3 u = body.displacement({0, 0.5, 2});
    const std::string name = surfaces::name_of(type) + ": ";
    if (is_quadratic(type)) expect_error(name + "twist", u[0] / (sign * 0.01) - 1, 1e-10);
    expect_error(name + "stretch", u[1] / 0.01 - 1, 1e-10);
    expect_error(name + "contraction", u[2] / (-0.3 * 0.02 * 2) - 1, 1e-10);
  }
}

// A body drawn along a line under an even pressure is in plane strain.
TEST(Section, plane_strain_limit) {
  const double nu = 0.3;
  sections::Rectangle shape{{-1, 0, 1}, {-1, 0, 1}};
  SectionBody body(sections::rectangle(shape, ElementType::quad8), 1000, nu);
  body.tag_sides(shape).contact(4).draw_along_x(50);
  body.hold([](const Vec3& x) { return x[2] < -1 + 1e-9; }, 4).hold([](const Vec3& x) { return length(x) < 1e-9; }, 3);
  body.body().set_pressure(4, 7);
  body.prepare();
  expect_error("plane strain: depth", body.displacement({0, 0, 1})[2] / (-2 * 7 * (1 - nu * nu) / 1000) - 1, 1e-10);
  expect_error("plane strain: width", body.displacement({0, 1, 1})[1] / (7 * nu * (1 + nu) / 1000) - 1, 1e-10);
  const auto reaction = body.body().own().reaction;
  expect_error("reaction of a period", reaction.force[2] / (7 * 2 * 50) - 1, 1e-10);
}

/// Adds the displacement of a body under tractions on a layer to a state.
SurfaceState state_under(SectionBody& body, const SurfaceMesh& layer, const std::vector<std::int32_t>& row,
                         const std::function<Vec3(const Vec3&)>& traction) {
  AsEquations& equations = *body.body().response()->as_equations();
  const auto loads = equations.loads({{}, layer, row}, 1);
  std::vector<double> force(surfaces::at(loads->load.rows), 0.0);
  for (std::size_t k = 0; k < 3 * layer.node.size(); ++k)
    for (std::int64_t i = loads->load.start[k]; i < loads->load.start[k + 1]; ++i)
      force[surfaces::at(loads->load.row[surfaces::at(i)])] +=
          traction(layer.node[k / 3])[k % 3] * loads->load.value[surfaces::at(i)];
  SurfaceState state;
  equations.solve_everywhere(force, state, 1);
  return state;
}

// What a frame's tractions do everywhere is what they do at the rows of its response; the surface's stresses balance.
TEST(Section, fields_under_a_layer) {
  const sections::Rectangle shape{sections::fine_at_ends(4, -4, 4), sections::fine_at_ends(6, 25, 50)};
  SectionBody ring(sections::rectangle(shape, ElementType::quad8), loaded_ring::young, 0.3);
  ring.tag_sides(shape).contact(4).turn_about_y();
  ring.body().set_int("stations", 600);
  ring.hold([](const Vec3& x) { return x[2] < 25 + 1e-9; }).prepare();
  const SurfaceMesh layer = patch(4);
  const auto pressure = [](const Vec3& x) { return loaded_ring::traction(Load::normal, x); };
  const auto answer = loaded(ring, Load::normal, 4);
  SurfaceState state = state_under(ring, layer, answer.node, pressure);
  double error = 0, most = 0;
  for (std::size_t k = 0; k < answer.node.size(); ++k)
    for (std::size_t c = 0; c < 3; ++c) {
      error = std::max(error, std::abs(state.u[3 * surfaces::at(answer.node[k]) + c] - answer.u[k][c]));
      most = std::max(most, std::abs(answer.u[k][c]));
    }
  expect_error("displacements everywhere beside those of the response", error / most, 1e-12);
  const Vec3 top = state.u.empty() ? Vec3{} : Vec3{state.u[0], state.u[1], state.u[2]};
  const auto fields = ring.body().response()->fields(std::move(state), {});
  const Vec3 first = ring.surface().node[0];
  double u[6] = {}, s[12] = {};
  const double points[] = {first[0], first[1], first[2], 0, 0, 45};
  fields->at_points(2, points, u, s, 1);
  expect_error("displacement at a node of the surface", length(Vec3{u[0], u[1], u[2]} - top) / length(top), 1e-10);
  // Below the patch the stress is between that of a half-space under the strip, and more.
  const double a = std::atan(1.0 / 5), strip = -100 / pi * (2 * a + std::sin(2 * a));
  expect_error("stress 5 below the middle, beside a strip's on a half-space", s[8] / strip - 1, 0.1);
}

// A layer nu = 0 on springs under its own pressure: u = p / k + p d / E.
TEST(Section, springs) {
  sections::Rectangle shape{{-1, 0, 1}, {-1, 0, 1}};
  SectionBody body(sections::rectangle(shape, ElementType::quad8), 1000, 0);
  body.tag_sides(shape).contact(1).draw_along_x(50);
  body.hold([](const Vec3& x) { return length(x) < 1e-9; }, 3);
  const double stiffness[] = {0, 0, 40};
  body.body().set_springs(3, stiffness);
  body.body().set_pressure(4, 7);
  body.prepare();
  expect_error("pressed on springs", body.displacement({0, -1, 1})[2] / (-7.0 / 40 - 7 * 2 / 1000.0) - 1, 1e-10);
}

// Radial tractions cos 2 phi bend a thin ring: u = q R^4 / (9 E I), less parts of (t / R)^2.
TEST(Section, thin_ring_bends) {
  constexpr double thick = 0.02, young = 1000;
  sections::Rectangle shape{{0, thick}, {1 - thick / 2, 1 + thick / 2}};
  SectionBody ring(sections::rectangle(shape, ElementType::quad8), young, 0);
  ring.tag_sides(shape).contact(4).turn_about_y();
  const double soft[] = {1e-6, 1e-6, 1e-6};
  ring.body().set_springs(3, soft);
  ring.body().set_int("stations", 48);
  ring.prepare();
  std::vector<std::int64_t> all(surfaces::at(ring.surface().elements()));
  for (std::size_t k = 0; k < all.size(); ++k) all[k] = static_cast<std::int64_t>(k);
  const auto rows = ring.body().response()->rows({all, {}, {}}, 1);
  std::vector<double> t, u(3 * rows->row.size());
  for (const std::int32_t k : rows->column) {
    const Vec3 x = ring.surface().node[surfaces::at(k)];
    const double phi = std::atan2(x[0], x[2]);
    t.insert(t.end(), {std::cos(2 * phi) * std::sin(phi), 0, std::cos(2 * phi) * std::cos(phi)});
  }
  multiply(rows->u.data(), rows->u.rows(), rows->u.columns(), t.data(), 0, u.data());
  const std::size_t top = surfaces::at(surfaces::node_at(ring.surface(), {0, thick / 2, 1 + thick / 2}));
  const auto row = std::find(rows->row.begin(), rows->row.end(), static_cast<std::int32_t>(top)) - rows->row.begin();
  const double outer = 1 + thick / 2;  // the load acts there
  const double exact = outer / (9 * young * thick * thick * thick / 12);
  expect_error("thin ring, n = 2", u[surfaces::at(3 * row + 2)] / exact - 1, 5e-4);
}

// A bar on springs under a load at its middle, beside a beam on Winkler's foundation that shears.
TEST(Section, rail_on_a_foundation) {
  constexpr double young = 210000, nu = 0.3, b = 70, h = 170, springs = 100, period = 12000;
  sections::Rectangle shape{{-b / 2, -b / 6, b / 6, b / 2}, {-h, -0.8 * h, -0.5 * h, -0.2 * h, -20, 0}};
  SectionBody rail(sections::rectangle(shape, ElementType::quad8), young, nu);
  rail.tag_sides(shape).contact(4).draw_along_x(period);
  const double stiffness[] = {1e-6, springs / b, springs / b};
  rail.body().set_springs(3, stiffness);
  rail.prepare();
  SurfaceMesh layer =
      surfaces::one_element(ElementType::quad4, {{-20, -20, 0}, {20, -20, 0}, {20, 20, 0}, {-20, 20, 0}});
  SurfaceState state = state_under(
      rail, layer, surfaces::nodes_where(rail.surface(), [](const Vec3& x) { return std::abs(x[0]) < 100; }),
      [](const Vec3&) {
        return Vec3{0, 0, -100};
      });
  const auto fields = rail.body().response()->fields(std::move(state), {});
  const double inertia = b * h * h * h / 12, shear = 5.0 / 6 * b * h * young / (2 * (1 + nu)), force = 100 * 40 * 40;
  for (const double x : {300.0, 600.0, 1000.0}) {
    double beam = 0, at_rest = 0, u[3] = {};
    for (int n = 0; n < 4000; ++n) {
      const double k = 2 * pi * n / period, k2 = k * k, part = (n == 0 ? 1 : 2) * force / period;
      const double one = part * (1 + young * inertia * k2 / shear) /
                         (young * inertia * k2 * k2 + springs * young * inertia * k2 / shear + springs);
      beam += one * std::cos(k * x), at_rest += one;
    }
    const double point[] = {x, 0, -h / 2};
    fields->at_points(1, point, u, nullptr, 1);
    report("deflection at " + std::to_string(x), -u[2]);
    expect_error("rail beside a beam that shears, over its deflection under the load", (-u[2] - beam) / at_rest, 0.02);
  }
}

template <class Work>
std::string refusal(const Work& work) {
  try {
    work();
  } catch (const Error& e) {
    return e.what();
  }
  return "";
}

// A solid shaft, held at one end, under pressure all round: its side is the surface, and the stress is even.
TEST(Section, solid_to_the_axis) {
  sections::Rectangle shape{{0, 1, 2}, {0, 0.5, 1}};
  SectionBody shaft(sections::rectangle(shape, ElementType::quad8), 1000, 0.3);
  shaft.tag_sides(shape).turn_about_y();
  shaft.hold([](const Vec3& x) { return near(x[1], 0) < 1e-9; }, 3);
  shaft.body().set_pressure(4, 7);
  const std::int32_t side = 4;
  shaft.body().set_contact_faces(1, &side);
  shaft.prepare();
  const Vec3 u = shaft.displacement({0, 2, 1});
  expect_error("shaft: radial", u[2] / (-7 * 0.7 / 1000) - 1, 1e-10);
  expect_error("shaft: axial", u[1] / (2 * 2 * 0.3 * 7 / 1000) - 1, 1e-10);
  const double point[] = {0.3, 1.2, -0.4};
  double s[6] = {};
  shaft.body().response()->fields({}, shaft.body().own())->at_points(1, point, nullptr, s, 1);
  for (const std::size_t c : {0, 2}) expect_error("shaft: stress", s[c] / -7 - 1, 1e-10);
  expect_error("shaft: axial stress", s[1] / 7, 1e-10);
}

TEST(Section, says_which_motion_is_free) {
  const auto prepared = [](std::int32_t mask) {
    return refusal([&] {
      SectionBody body = tube(ElementType::quad4, 4);
      body.turn_about_y().contact(4);
      body.hold([](const Vec3& x) { return near(x[2], 1) < 1e-9; }, mask);
      body.prepare();
    });
  };
  EXPECT_NE(prepared(2).find("about its axis"), std::string::npos) << prepared(2);
  EXPECT_NE(prepared(1).find("along its axis"), std::string::npos) << prepared(1);
  EXPECT_EQ(prepared(7), "");
  const std::string none = refusal([] {
    SectionBody body = tube(ElementType::quad4, 4);
    body.hold([](const Vec3& x) { return near(x[2], 1) < 1e-9; }).prepare();
  });
  EXPECT_NE(none.find("rollcon_body_revolve"), std::string::npos) << none;
}

}  // namespace
}  // namespace rollcon
