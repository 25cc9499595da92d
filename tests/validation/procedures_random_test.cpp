// Tests that every solution procedure finds the tractions of the standard one, on contacts of half-spaces drawn at
// random from fixed seeds.

#include "validation/procedure_runs.hpp"

namespace rollcon::validation {
namespace {

using Pair = std::unique_ptr<RollingPair>;

enum class Kind { identical, dissimilar, on_rigid };

struct Drawn {
  Pair pair;
  std::string what;
};

/// Draws ellipse, materials, friction, creepages, spin and which motions are found from forces. Sizes of creepages are
/// `creep` times mu p0 / E*, of which a few times saturate friction.
Drawn draw(Kind kind, bool by_force, double creep, std::uint32_t seed) {
  frames::Random random(seed);
  const Elastic one{.shear = 3800, .poisson = random.between(0, 0.45)};
  const Elastic other{.shear = 3800 * std::pow(10, random.between(-1, 1)), .poisson = random.between(0, 0.45)};
  std::optional<Elastic> second;
  if (kind == Kind::identical) second = one;
  if (kind == Kind::dissimilar) second = other;
  const double modulus = second ? closed_forms::effective_modulus(one, *second) : closed_forms::effective_modulus(one);
  const double a = random.between(0.6, 1.8), p0 = 100, mu = random.between(0.05, 0.6);
  const auto hertz = closed_forms::hertz_from_axes(a, 1, p0, modulus);
  Drawn drawn{std::make_unique<RollingPair>(one, second), ""};
  RollingPair& pair = *drawn.pair;
  const bool triangles = random() < 0;
  const int n = triangles ? 8 : 9;
  const auto x = frames::uniform_lines(-1.25 * a, 1.25 * a, n), y = frames::uniform_lines(-1.25, 1.25, n);
  pair.frame(frames::perturb(frames::rectangle(triangles ? ElementType::tri3 : ElementType::quad4, x, y), 0.1, seed));
  pair.gap_quadratic(hertz.A, hertz.B).friction(mu).speed(5);
  pair.option("convection", random() < 0 ? "godunov" : "least_squares");
  if (random() < 0)
    pair.load(hertz.load);
  else
    pair.approach(hertz.approach);
  const double full = creep * mu * p0 / modulus;
  const double spin = random() < 0 ? full / std::sqrt(a) * random.between(-1, 1) : 0;
  pair.creep(full * random.between(-1, 1), full * random.between(-1, 1), spin);
  const double part = random.between(0.1, 0.7) * (random() < 0 ? -1 : 1);
  if (by_force) pair.load(hertz.load).tangential_force(ROLLCON_LONGITUDINAL, part * mu * hertz.load);
  char text[200];
  std::snprintf(text, sizeof text, "seed %u, %s, %s", seed, triangles ? "tri3" : "quad4",
                by_force ? "force given" : "creepages given");
  drawn.what = text;
  return drawn;
}

struct Scene {
  Kind kind;
  bool by_force;
  std::uint32_t seed;
  double creep = 1;
  std::vector<Failing> failing = {};

  std::string name() const {
    constexpr const char* kinds[] = {"identical", "dissimilar", "on_rigid"};
    return std::string(kinds[static_cast<int>(kind)]) + (by_force ? "_force_" : "_creepage_") + std::to_string(seed);
  }
};

class RandomProcedures : public ::testing::TestWithParam<Scene> {};

TEST_P(RandomProcedures, reach_the_standard_tractions) {
  const Scene& s = GetParam();
  const Drawn drawn = draw(s.kind, s.by_force, s.creep, s.seed);
  for (const char* system : {"condensed", "monolithic"})
    compare_procedures(s.name() + ", " + drawn.what, *drawn.pair, procedures_of(system), s.failing);
}

// Frozen directions of friction leave a creepage undetermined where everything slides and it is found from its force:
// the method circles between full slip and full stick.
const std::vector<Failing> all_sliding{{.jacobian = "simplified"}, {.jacobian = "reduced"}};

constexpr auto drawn_name = [](const auto& param) { return param.param.name(); };

INSTANTIATE_TEST_SUITE_P(HalfSpaces, RandomProcedures,
                         ::testing::Values(Scene{Kind::identical, false, 1}, Scene{Kind::on_rigid, false, 5}),
                         drawn_name);
INSTANTIATE_TEST_SUITE_P(HalfSpaces_long, RandomProcedures,
                         ::testing::Values(Scene{Kind::identical, false, 7}, Scene{Kind::identical, false, 13},
                                           Scene{Kind::identical, true, 2}, Scene{Kind::identical, true, 8},
                                           Scene{Kind::dissimilar, false, 3}, Scene{Kind::dissimilar, false, 9},
                                           Scene{Kind::dissimilar, false, 15}, Scene{Kind::dissimilar, true, 10},
                                           Scene{Kind::dissimilar, true, 16}, Scene{Kind::on_rigid, false, 11},
                                           Scene{Kind::on_rigid, false, 17}, Scene{Kind::on_rigid, true, 6},
                                           Scene{Kind::on_rigid, true, 12}, Scene{Kind::on_rigid, true, 18},
                                           Scene{Kind::on_rigid, true, 9, 3, all_sliding}),
                         drawn_name);

}  // namespace
}  // namespace rollcon::validation
