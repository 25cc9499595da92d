/// Tests sections whose materials relax: their responses in slow and in fast rolling, and what a body keeps of them.

#include <filesystem>

#include "support/section_bodies.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using sections::SectionBody;

constexpr double rubber = 12, cord = 300;
const std::vector<double> ratio{0.25, 0.25, 0.2}, fast_times{1e-3, 1e-2, 1e-1}, slow_times{1, 2, 5};

/// Returns a tyre of two layers; relaxed: with what is left of its moduli in the end.
SectionBody tyre(bool creeps, bool relaxed = false, const std::vector<double>& of_cord = slow_times) {
  const sections::Rectangle shape{sections::fine_at_ends(3, -4, 4), sections::fine_at_ends(4, 25, 50)};
  SurfaceMesh plane = sections::rectangle(shape, ElementType::quad8);
  for (std::int64_t e = 0; e < plane.elements(); ++e)
    plane.tag[surfaces::at(e)] = plane.node[surfaces::at(plane.element(e)[0])][2] > 30 ? 0 : 1;
  const double left = relaxed ? 0.3 : 1;
  SectionBody body(plane, rubber * left, 0.48);
  body.body().set_elastic(1, cord * left, 0.3);
  if (creeps) body.body().set_viscoelastic(0, std::ssize(ratio), ratio.data(), fast_times.data());
  if (creeps) body.body().set_viscoelastic(1, std::ssize(ratio), ratio.data(), of_cord.data());
  body.tag_sides(shape).contact(4).turn_about_y();
  body.hold([](const Vec3& x) { return x[2] < 25 + 1e-9; }).prepare();
  return body;
}

std::vector<double> rows(Body& body, double rate) {
  const auto found = body.response()->rows({{0, 1, 2, 3, 4, 5}, {}, {}, rate}, 2);
  return {found->u.data(), found->u.data() + found->u.rows() * found->u.columns()};
}

/// Returns displacements under axial tractions about one station less those about the next but one: without a mean.
std::vector<double> without_mean(Body& body, double rate) {
  const auto found = body.response()->rows({{0, 1, 2, 3, 4, 5}, {}, {}, rate}, 2);
  const auto& node = found->column;
  const auto width = static_cast<std::int32_t>(body.mesh().section.profile().size());
  std::vector<double> u;
  for (std::size_t c = 0; c < node.size(); ++c) {
    const auto later = std::find(node.begin(), node.end(), node[c] + 2 * width) - node.begin();
    if (node[c] / width != 1) continue;
    for (std::int64_t r = 0; r < found->u.rows(); ++r)
      u.push_back(found->u.row(r)[3 * c + 1] - found->u.row(r)[3 * later + 1]);
  }
  return u;
}

double difference(const std::vector<double>& a, const std::vector<double>& b) {
  double off = 0, largest = 0;
  for (std::size_t k = 0; k < a.size(); ++k)
    off = std::max(off, std::abs(a[k] - b[k])), largest = std::max(largest, std::abs(b[k]));
  return a.size() == b.size() ? off / largest : INFINITY;
}

// What acts all round stands still: it meets the relaxed moduli however fast the body rolls.
TEST(CreepingSection, slow_and_fast_rolling_are_elastic) {
  SectionBody creeping = tyre(true), stiff = tyre(false), soft = tyre(false, true);
  const std::vector<double> slow = rows(soft.body(), 0), fast = rows(stiff.body(), 0);
  for (const double sign : {1.0, -1.0}) {
    expect_error("slow rolling", difference(rows(creeping.body(), sign * 1e-13), slow), 1e-9);
    expect_error("fast rolling", difference(without_mean(creeping.body(), sign * 1e15), without_mean(stiff.body(), 0)),
                 1e-9);
  }
  expect_error("standing", difference(rows(creeping.body(), 0), slow), 1e-9);
  EXPECT_GT(difference(rows(creeping.body(), 1), fast), 0.05) << "in between it is neither";
  EXPECT_GT(difference(rows(creeping.body(), 1), rows(creeping.body(), -1)), 0.01) << "nor even";
}

TEST(CreepingSection, moduli_over_frequency_are_those_of_a_series) {
  SectionBody by_terms = tyre(true), elastic = tyre(false);
  const auto by_points = elastic.body().copy();
  for (const auto& [tag, young, time] : {std::tuple{0, rubber, &fast_times}, {1, cord, &slow_times}}) {
    const Relaxation series{checked_relaxation(std::ssize(ratio), ratio.data(), time->data()), {}};
    std::vector<double> frequency, storage, loss;
    for (double d = -4; d < 7; d += 0.01) {
      const std::complex<double> modulus = young * series.modulus(std::pow(10, d));
      frequency.push_back(std::pow(10, d)), storage.push_back(modulus.real()), loss.push_back(modulus.imag());
    }
    by_points->set_moduli(tag, std::ssize(frequency), frequency.data(), storage.data(), loss.data());
  }
  by_points->prepare();
  expect_error("moduli at points for a series", difference(rows(*by_points, 3), rows(by_terms.body(), 3)), 1e-4);
}

TEST(CreepingSection, keeps_its_latest_rates_and_goes_to_files) {
  SectionBody tyre_of_two = tyre(true);
  Body& body = tyre_of_two.body();
  const auto factorised = [&] { return body.response()->statistics().factorizations; };
  EXPECT_EQ(factorised(), 0) << "there is no rate yet";
  const std::vector<double> first = rows(body, 2);
  const std::int64_t each = factorised();
  body.response()->rows({{2, 3}, {}, {}, 2}, 1);
  EXPECT_EQ(factorised(), each) << "the rate is the same";
  rows(body, 3);
  EXPECT_EQ(factorised(), 2 * each);
  const std::string path = (std::filesystem::temp_directory_path() / "creeping_section.rcb").string();
  body.save(path);
  const auto loaded = Body::load(std::make_shared<Context>(), path);
  std::filesystem::remove(path);
  EXPECT_TRUE(loaded->creeps());
  EXPECT_EQ(difference(rows(*loaded, 2), first), 0);
  EXPECT_EQ(loaded->response()->statistics().factorizations, 0) << "responses are kept with their rates";
  EXPECT_LT(difference(rows(*loaded, 4), rows(body, 4)), 1e-12);
  SectionBody elastic = tyre(false);
  EXPECT_FALSE(elastic.body().creeps());
  EXPECT_GT(difference(rows(elastic.body(), 2), first), 0.05) << "it is no equal body";
}

/// Returns stresses below the tread: under a load, at its ends and beyond it. top: displacement of a loaded node.
std::vector<double> stresses_under_load(Body& body, double rate, double& top) {
  AsEquations& equations = *body.response()->as_equations();
  const auto loads = equations.loads({{0, 1, 2, 3, 4, 5, 6, 7, 8}, {}, {}, rate}, 1);
  std::vector<double> force(surfaces::at(loads->load.rows), 0.0);
  const Vec3 traction{1, 0, -3};
  for (std::size_t k = 0; k < 3 * loads->column.size(); ++k)
    for (std::int64_t i = loads->load.start[k]; i < loads->load.start[k + 1]; ++i)
      force[surfaces::at(loads->load.row[surfaces::at(i)])] += traction[k % 3] * loads->load.value[surfaces::at(i)];
  SurfaceState state;
  state.rate = rate;
  equations.solve_everywhere(force, state, 1);
  top = state.u[2];
  const auto fields = body.response()->fields(std::move(state), {});
  const std::vector<Vec3>& node = body.mesh().surface.node;
  double u[3];
  fields->at_points(1, node[0].data(), u, nullptr, 1);
  expect_error("displacement at a node of the surface", u[2] / top - 1, 1e-10);
  const std::size_t station = body.mesh().section.profile().size();
  std::vector<double> point;
  for (std::size_t k = 0; k < 20; ++k)
    for (const double depth : {0.99, 0.9, 0.55})
      point.insert(point.end(), {depth * node[k * station][0], 0.3, depth * node[k * station][2]});
  std::vector<double> stress(2 * point.size());
  fields->at_points(std::ssize(point) / 3, point.data(), nullptr, stress.data(), 1);
  return stress;
}

// Moduli that are a multiple of the elastic ones, the same everywhere but another in each harmonic, leave the stresses
// of given tractions as they are, but not the displacements.
TEST(CreepingSection, stresses_inside_carry_the_load) {
  std::vector<double> nearly = fast_times;
  for (double& t : nearly) t *= 1 + 1e-10;
  SectionBody creeping = tyre(true, false, nearly), elastic = tyre(false);
  for (const double rate : {5.0, -5.0}) {
    double top, elastic_top;
    const std::vector<double> found = stresses_under_load(creeping.body(), rate, top);
    const std::vector<double> given = stresses_under_load(elastic.body(), 0, elastic_top);
    expect_error("stresses beside elastic ones", difference(found, given), 1e-8);
    EXPECT_GT(top / elastic_top, 1.3) << "it gives way more";
  }
}

}  // namespace
}  // namespace rollcon
