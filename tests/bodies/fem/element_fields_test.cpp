// Tests what one element makes of known fields: patch test, quadratic fields, bending.

#include "bodies/fem/element_cases.hpp"
#include "mesh/quadrature.hpp"
#include "mesh/shape.hpp"
#include "support/testing.hpp"

namespace rollcon::fem {
namespace {

using elements::Formulation;
using elements::Nodes;
using elements::Stiffness;

using Matrix = std::array<Vec3, 3>;

/// Applies Hooke's law for E = 1; gradient[a][b] = du_a / dx_b.
Matrix stress(const Matrix& gradient, double poisson) {
  const double shear = 1 / (2 * (1 + poisson));
  const double lame = 2 * shear * poisson / (1 - 2 * poisson);
  Matrix result;
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = 0; b < 3; ++b) result[a][b] = shear * (gradient[a][b] + gradient[b][a]);
  const double pressure = lame * (gradient[0][0] + gradient[1][1] + gradient[2][2]);
  for (std::size_t a = 0; a < 3; ++a) result[a][a] += pressure;
  return result;
}

/// Returns the consistent nodal loads of sigma n on all faces.
std::vector<double> boundary_loads(VolumeType type, const Nodes& x, const Matrix& sigma) {
  std::vector<double> load(3 * x.size(), 0.0);
  for (const VolumeFace& face : faces_of(type)) {
    const PlaneRule rule = corner_count(face.type) == 3 ? triangle_rule(6) : square_rule(6);
    const auto n = static_cast<std::size_t>(node_count(face.type));
    for (std::size_t q = 0; q < rule.size(); ++q) {
      Shape shape;
      evaluate_shape(face.type, rule.xi[q], rule.eta[q], shape);
      Vec3 along{}, across{};
      for (std::size_t i = 0; i < n; ++i) {
        const Vec3& node = x[static_cast<std::size_t>(face.node[i])];
        along = along + shape.d_xi[i] * node;
        across = across + shape.d_eta[i] * node;
      }
      const Vec3 area = cross(along, across);
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t a = 0; a < 3; ++a)
          load[3 * static_cast<std::size_t>(face.node[i]) + a] += rule.w[q] * shape.value[i] * dot(sigma[a], area);
    }
  }
  return load;
}

class ElementPatch : public ::testing::TestWithParam<Formulation> {};

TEST_P(ElementPatch, constant_strain_gives_the_loads_of_constant_stress) {
  const VolumeType type = GetParam().type;
  const Matrix gradient{{{0.3, -1.1, 0.4}, {0.2, 0.7, -0.5}, {-0.9, 0.6, 0.8}}};
  const auto field = [&](const Vec3& p) { return Vec3{dot(gradient[0], p), dot(gradient[1], p), dot(gradient[2], p)}; };
  for (double poisson : {-0.5, 0.3, 0.4999999}) {
    double worst = 0;
    for (const Nodes& x : {elements::slanted(type), elements::distorted(type), elements::curved(type)}) {
      const Stiffness k = elements::stiffness(GetParam(), x, poisson);
      const auto force = k.times(elements::at_nodes(x, field));
      const auto load = boundary_loads(type, x, stress(gradient, poisson));
      worst = std::max(worst, elements::difference(force, load));
    }
    expect_error(GetParam().name() + " patch" + elements::with(poisson), worst, 1e-12);
  }
}

// Locking would show here: without dilatation, only the shear modulus may act.
TEST_P(ElementPatch, constant_shear_at_nearly_one_half) {
  const VolumeType type = GetParam().type;
  const Matrix gradient{{{1, 0.4, 0}, {0.2, -0.3, 0.5}, {0.1, 0, -0.7}}};
  const auto field = [&](const Vec3& p) { return Vec3{dot(gradient[0], p), dot(gradient[1], p), dot(gradient[2], p)}; };
  const Nodes x = elements::curved(type);
  const double poisson = 0.499999;
  const auto force = elements::stiffness(GetParam(), x, poisson).times(elements::at_nodes(x, field));
  // The bulk modulus magnifies the rounding of the nodes' displacements.
  expect_error(GetParam().name() + " sheared, nu 0.499999",
               elements::difference(force, boundary_loads(type, x, stress(gradient, poisson))), 4e-9);
}

INSTANTIATE_TEST_SUITE_P(Fem, ElementPatch, ::testing::ValuesIn(elements::all),
                         [](const auto& param) { return param.param.name(); });

/// Integrates sigma : grad u of a field over a parallelepiped.
double strain_energy(const Formulation& f, const Nodes& x, const std::function<Matrix(const Vec3&)>& gradient,
                     double poisson) {
  const VolumeRule rule = volume_rule(f.type, 6);
  double sum = 0;
  for (std::size_t q = 0; q < rule.size(); ++q) {
    VolumeShape shape;
    evaluate_shape(f.type, rule.point[q], shape);
    Vec3 place{};
    Matrix tangent{};
    for (std::size_t i = 0; i < f.nodes(); ++i) {
      place = place + shape.value[i] * x[i];
      for (std::size_t r = 0; r < 3; ++r) tangent[r] = tangent[r] + shape.d[i][r] * x[i];
    }
    const double volume = rule.w[q] * dot(tangent[0], cross(tangent[1], tangent[2]));
    const Matrix g = gradient(place), sigma = stress(g, poisson);
    for (std::size_t a = 0; a < 3; ++a) sum += volume * dot(sigma[a], g[a]);
  }
  return sum;
}

/// Is a field whose component a is x.h[a].x / 2 with symmetric h[a].
struct QuadraticField {
  std::array<Matrix, 3> h{};

  Vec3 operator()(const Vec3& p) const {
    Vec3 u{};
    for (std::size_t a = 0; a < 3; ++a) u[a] = 0.5 * dot(gradient(p)[a], p);
    return u;
  }
  Matrix gradient(const Vec3& p) const {
    Matrix g{};
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b < 3; ++b) g[a][b] = dot(h[a][b], p);
    return g;
  }
};

std::vector<QuadraticField> quadratic_fields() {
  std::vector<QuadraticField> fields;
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = 0; b < 3; ++b)
      for (std::size_t c = 0; c <= b; ++c) {
        QuadraticField field;
        field.h[a][b][c] = field.h[a][c][b] = 1;
        fields.push_back(field);
      }
  return fields;
}

class QuadraticElement : public ::testing::TestWithParam<Formulation> {};

TEST_P(QuadraticElement, stores_the_energy_of_quadratic_fields) {
  const Nodes x = elements::slanted(GetParam().type);
  for (double poisson : {0.0, 0.3, 0.38}) {
    const Stiffness k = elements::stiffness(GetParam(), x, poisson);
    double worst = 0;
    for (const QuadraticField& field : quadratic_fields()) {
      const double exact = strain_energy(
          GetParam(), x, [&](const Vec3& p) { return field.gradient(p); }, poisson);
      worst = std::max(worst, relative(k.energy(elements::at_nodes(x, field)), exact));
    }
    expect_error(GetParam().name() + ", quadratic fields" + elements::with(poisson), worst, 1e-12);
  }
}

// The field u is the curl of a cubic potential, with linear strain and no dilatation.
TEST_P(QuadraticElement, does_not_lock_in_quadratic_fields_without_dilatation) {
  const Nodes x = elements::slanted(GetParam().type);
  QuadraticField field;
  field.h[0][0][0] = 2;
  field.h[1][0][1] = field.h[1][1][0] = -2;
  field.h[2][0][0] = 3;
  field.h[2][1][1] = -1;
  const double poisson = 0.499999;
  const double exact = strain_energy(
      GetParam(), x, [&](const Vec3& p) { return field.gradient(p); }, poisson);
  const Stiffness k = elements::stiffness(GetParam(), x, poisson);
  expect_error(GetParam().name() + ", quadratic field without dilatation, nu 0.499999",
               relative(k.energy(elements::at_nodes(x, field)), exact), 4e-9);
}

INSTANTIATE_TEST_SUITE_P(Fem, QuadraticElement, ::testing::ValuesIn(elements::quadratic),
                         [](const auto& param) { return param.param.name(); });

// The bulk moduli of the dilatation's constant and varying part are told apart by their energies.
TEST(ElementDilatation, its_varying_part_is_capped_where_it_would_lock) {
  for (const Formulation& f : elements::quadratic) {
    const double cap = f.type == VolumeType::tet10 ? 4 : f.type == VolumeType::wedge15 ? 8 : INFINITY;
    const Nodes x = elements::slanted(f.type);
    QuadraticField field;
    field.h[0][0][0] = 1;  // u = (x^2 / 2, 0, 0), dilatation x
    const auto gradient = [&](const Vec3& p) { return field.gradient(p); };
    // The energies of G and of K alone follow from two Poisson's ratios below every cap.
    const auto shear = [](double nu) { return 1 / (2 * (1 + nu)); };
    const auto bulk = [](double nu) { return 1 / (3 * (1 - 2 * nu)); };
    const double e0 = strain_energy(f, x, gradient, 0) / shear(0), e1 = strain_energy(f, x, gradient, 0.3) / shear(0.3);
    const double k0 = bulk(0) / shear(0), k1 = bulk(0.3) / shear(0.3);
    const double per_bulk = (e1 - e0) / (k1 - k0), per_shear = e0 - k0 * per_bulk;
    // The constant part is the mean of x.
    double volume = 0, moment = 0;
    const VolumeRule rule = volume_rule(f.type, 3);
    for (std::size_t q = 0; q < rule.size(); ++q) {
      VolumeShape shape;
      evaluate_shape(f.type, rule.point[q], shape);
      volume += rule.w[q];
      for (std::size_t i = 0; i < f.nodes(); ++i) moment += rule.w[q] * shape.value[i] * x[i][0];
    }
    const double mean = moment / volume;
    const double jacobian = 2 * (1.5 * 0.9 - 0.6 * 0.3) - 0.5 * (0.4 * 0.9 + 0.6 * 0.2) - 0.3 * (0.4 * 0.3 + 1.5 * 0.2);
    const double constant = mean * mean * volume * jacobian;
    for (double poisson : {0.3, 0.45, 0.499}) {
      const double k_over_g = bulk(poisson) / shear(poisson);
      const double expected =
          shear(poisson) * (per_shear + k_over_g * constant + std::min(k_over_g, cap) * (per_bulk - constant));
      const double energy = elements::stiffness(f, x, poisson).energy(elements::at_nodes(x, field));
      expect_error(f.name() + ", linear dilatation" + elements::with(poisson), relative(energy, expected), 1e-11);
    }
  }
}

// A brick with free sides in pure bending has u = (x z, -nu y z, ...). Deflections and contraction along z, quadratic,
// are left to the incompatible modes. Twice its energy is E I per length.
TEST(ElementBending, of_one_enhanced_hexahedron_is_exact) {
  const Formulation enhanced{VolumeType::hex8}, b_bar{VolumeType::hex8, Hex8::b_bar};
  for (double aspect : {1.0, 10.0, 1000.0})
    for (double poisson : {0.0, 0.3, 0.4999999}) {
      const Nodes x = elements::box(VolumeType::hex8, {aspect, 2, 1});
      const double exact = 8 * aspect * 2 * 1.0 / 3;  // integral of z^2
      const auto u = elements::at_nodes(x, [&](const Vec3& p) { return Vec3{p[0] * p[2], -poisson * p[1] * p[2], 0}; });
      char what[64];
      std::snprintf(what, sizeof what, " bent, aspect %g, nu %.9g", aspect, poisson);
      // The shear of a slender brick, (aspect)^2 times as stiff, cancels in the condensation.
      expect_error(std::string("hex8") + what, relative(elements::stiffness(enhanced, x, poisson).energy(u), exact),
                   1e-8);
      report(std::string("hex8_b_bar") + what + ": energy over exact",
             elements::stiffness(b_bar, x, poisson).energy(u) / exact);
    }
}

// A right prism under u = (x z, 0, 0) bends like a plate, whose sides y cannot contract, and shears.
TEST(ElementBending, of_one_wedge_through_its_thickness) {
  const Formulation wedge{VolumeType::wedge6};
  const Nodes x = elements::mapped(VolumeType::wedge6, [](const Vec3& r) {
    return Vec3{3 * (r[0] - 1.0 / 3), 2 * (r[1] - 1.0 / 3), 0.5 * r[2]};
  });
  const auto u = elements::at_nodes(x, [](const Vec3& p) { return Vec3{p[0] * p[2], 0, 0}; });
  const double area = 3, height = 1;
  const double bending = area * height * height * height / 12;  // integral of z^2
  const double sheared = area * height * 9 / 18;                // integral of x^2
  for (double poisson : {0.0, 0.3, 0.45}) {
    const double exact = bending / (1 - poisson * poisson) + sheared / (2 * (1 + poisson));
    expect_error("wedge6 bent" + elements::with(poisson),
                 relative(elements::stiffness(wedge, x, poisson).energy(u), exact), 1e-12);
  }
}

}  // namespace
}  // namespace rollcon::fem
