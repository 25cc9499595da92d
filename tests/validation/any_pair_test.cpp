// Tests any body on any body: blocks of finite and of boundary elements, half-spaces and rigid bodies, as body 1 or 2,
// in their own poses. All of them are large beside the contact, and compared with half-spaces of the same materials.

#include <string>
#include <vector>

#include "validation/scenes.hpp"

namespace rollcon::validation {
namespace {

using scenes::AnyBody;

// Poisson's ratios are near 1/2, so that little of the pressure becomes slip, whose error would hide that of the rest.
const Elastic one{.shear = 3400, .poisson = 0.47}, other{.shear = 5000, .poisson = 0.45};
constexpr double radius = 50, zone = 2.5, mu = 0.1, load = 220;

AnyBody make(const std::string& kind, const Elastic& material) {
  const surfaces::ZoneBlock shape{30, 15, zone, 10, 4, 7};
  MeshedBody body;
  if (kind == "rigid") return RigidBody{};
  if (kind == "half-space") return scenes::HalfspaceBody{material};
  if (kind == "BEM")
    body = meshed(surfaces::zone_block({30, 15, zone, 8, 3, 4}, ElementType::quad4), material);
  else
    body = meshed(volumes::zone_block(shape, VolumeType::hex8), material);
  body.held_tag = {3};
  body.contact_tag = {1, 2};
  return body;
}

bool meshed(const std::string& kind) {
  return kind == "FEM" || kind == "BEM";
}

/// Turns and shifts the scene as a whole.
struct Turned {
  std::array<Vec3, 3> rotation{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  Vec3 shift{0, 0, 0};
  Vec3 turn(const Vec3& x) const { return {dot(rotation[0], x), dot(rotation[1], x), dot(rotation[2], x)}; }
  /// Returns the rows of rotation times r.
  std::array<Vec3, 3> after(const std::array<Vec3, 3>& r) const {
    std::array<Vec3, 3> product;
    for (std::size_t i = 0; i < 3; ++i)
      product[i] = rotation[i][0] * r[0] + rotation[i][1] * r[1] + rotation[i][2] * r[2];
    return product;
  }
};

Solution roll(const std::string& kind1, const std::string& kind2, const Turned& t) {
  RollingPair pair(make(kind1, one), make(kind2, other), 1);
  constexpr std::array<Vec3, 3> straight{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  constexpr std::array<Vec3, 3> upside_down{{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}}};
  if (meshed(kind1)) pair.pose(1, t.after(straight), t.shift);
  if (meshed(kind2)) pair.pose(2, t.after(upside_down), t.shift);
  pair.axes(t.shift, t.turn({1, 0, 0}), t.turn({0, 0, 1}));
  if (meshed(kind1)) {
    pair.frame_from_body(1, 2);
  } else if (meshed(kind2)) {
    pair.frame_from_body(2, 2);
  } else {
    pair.rectangle(ElementType::quad4, 10, 10, zone / 2, zone / 2);
  }
  const double curvature = 1 / (2 * radius);
  pair.gap_quadratic(curvature, curvature).friction(mu).load(load).speed(10);
  pair.creep(-1.2e-3, 5e-4, 0).option("convection", "least_squares");
  EXPECT_EQ(pair.solve(), ROLLCON_OK) << kind1 << " on " << kind2;
  for (const char* law : {"law_normal", "law_friction", "law_slip"})
    expect_error(kind1 + " on " + kind2 + ": " + law, pair.stat(law), 1e-8);
  return pair.solution();
}

struct Kinds {
  const char *body1, *body2;
};

class AnyPair : public ::testing::TestWithParam<Kinds> {};

TEST_P(AnyPair, rolls_like_half_spaces_and_in_any_pose) {
  const auto [kind1, kind2] = GetParam();
  const std::string name = std::string(kind1) + " on " + kind2 + ": ";
  const auto flat = [](const std::string& kind) { return meshed(kind) ? std::string("half-space") : kind; };
  const Solution s = roll(kind1, kind2, {});
  const Solution half = roll(flat(kind1), flat(kind2), {});
  const FittedEllipse fit = fit_hertz(s, 1, 1);
  const FittedEllipse reference = fit_hertz(half, 1, 1);
  expect_error(name + "p0, half-spaces", relative(fit.p0, reference.p0), 0.04);
  expect_error(name + "a, half-spaces", relative(fit.a, reference.a), 0.03);
  for (std::size_t c = 0; c < 2; ++c)
    expect_error(name + "F" + std::to_string(c + 1) + " over mu Fn, half-spaces",
                 (s.force[c] - half.force[c]) / (mu * load), 0.06);

  const double a = 0.7, b = -0.4;
  const double ca = std::cos(a), sa = std::sin(a), cb = std::cos(b), sb = std::sin(b);
  const Turned turned{{{{ca, -sa * cb, sa * sb}, {sa, ca * cb, -ca * sb}, {0, sb, cb}}}, {30, -20, 50}};
  const Solution t = roll(kind1, kind2, turned);
  ASSERT_EQ(t.nodes(), s.nodes());
  double pressure = 0, traction = 0;
  for (std::size_t k = 0; k < s.nodes(); ++k) {
    pressure = std::max(pressure, std::abs(t.pressure[k] - s.pressure[k]) / reference.p0);
    for (std::size_t c = 0; c < 2; ++c)
      traction = std::max(traction, std::abs(t.traction[k][c] - s.traction[k][c]) / (mu * reference.p0));
  }
  expect_error(name + "turned and shifted, pressure", pressure, 1e-8);
  expect_error(name + "turned and shifted, traction", traction, 1e-7);
}

constexpr auto kinds_name = [](const auto& param) {
  std::string name = std::string(param.param.body1) + "_on_" + param.param.body2;
  for (char& c : name)
    if (c == '-') c = '_';
  return name;
};

INSTANTIATE_TEST_SUITE_P(Bodies, AnyPair, ::testing::Values(Kinds{"FEM", "rigid"}, Kinds{"BEM", "FEM"}), kinds_name);
INSTANTIATE_TEST_SUITE_P(Bodies_long, AnyPair,
                         ::testing::Values(Kinds{"FEM", "half-space"}, Kinds{"FEM", "BEM"}, Kinds{"FEM", "FEM"},
                                           Kinds{"BEM", "half-space"}, Kinds{"half-space", "FEM"},
                                           Kinds{"rigid", "FEM"}),
                         kinds_name);

}  // namespace
}  // namespace rollcon::validation
