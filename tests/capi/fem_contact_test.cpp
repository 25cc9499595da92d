/// Tests finite-element bodies loaded and in contact through the public interface: closed forms, options, counters,
/// many threads.

#include "fem_fixture.hpp"

using namespace capi_test;

class fem_contact : public FemApi {
 protected:
  /// Makes a cube whose lower half has material tag 1 and whose upper half tag 2; the top has tag 6.
  void set_two_materials(double lower, double upper, double nu) {
    ASSERT_OK(set_nodes_of_box());
    ASSERT_OK(add_layers(0, box.n / 2, 1));
    ASSERT_OK(add_layers(box.n / 2, box.n, 2));
    ASSERT_OK(rollcon_body_set_elastic(body, 1, lower, nu));
    ASSERT_OK(rollcon_body_set_elastic(body, 2, upper, nu));
    ASSERT_OK(tag_top(6));
  }

  /// Makes a block held at the bottom, for rolling on its top.
  void set_block(int per_edge) {
    box = BoxVolume(per_edge);
    set_two_materials(young, young, poisson);
    ASSERT_OK(hold_bottom(ROLLCON_DOF_XYZ));
  }

  /// Rolls a rigid sphere of radius 1 with creepage.
  rollcon_contact* roll(rollcon_context* own) { return roll_on_top(own, body, plane); }

  /// Lays a frame within the top whose nodes are not the body's.
  static void lay_frame(rollcon_contact* c) { give_frame(c, moved(SquareFrame(7, 0.4), 0.5, 0.5, 1)); }

  static void expect_same(const std::array<double, 3>& a, const std::array<double, 3>& b, double relative,
                          const char* what) {
    double error = 0;
    for (std::size_t c = 0; c < 3; ++c) error = std::max(error, std::abs(a[c] - b[c]));
    const double bound = relative * std::abs(b[2]);
    std::printf("%s: force (%g, %g, %g), difference %.2e, bound %.2e\n", what, a[0], a[1], a[2], error, bound);
    EXPECT_LE(error, bound);
    EXPECT_LT(b[2], 0);
  }
};
using fem_contact_long = fem_contact;

// Two springs in series have a uniform stress without friction and lateral contraction.
TEST_F(fem_contact, a_block_of_two_materials_is_pressed_as_springs_in_series) {
  const double approach = 0.03, lower = 200, upper = 100;
  set_two_materials(lower, upper, 0);
  hold_freely();
  ASSERT_OK(rollcon_body_set_int(body, "between_nodes", 1));
  rollcon_contact* c = roll_on_top(context, body, plane, {.curvature = 0, .approach = approach, .mu = 0, .creep = 0});
  const std::array<double, 3> force = solved_force(c);
  const double exact = -approach / (0.5 / lower + 0.5 / upper);  // -4
  expect_same(force, {0, 0, exact}, 1e-9, "springs in series");
  rollcon_contact_release(c);
}

TEST_F(fem_contact, frames_of_faces_before_and_after_preparation) {
  set_block(4);
  rollcon_contact *before = roll(context), *after = nullptr;
  ASSERT_OK(rollcon_body_prepare(body));
  after = roll(context);
  expect_same(solved_force(before), solved_force(after), 0, "frame taken before preparation");
  EXPECT_FAILS(rollcon_contact_frame_from_body(after, 1, 9), ARGUMENT, "tag is 9");
  rollcon_contact_release(before);
  rollcon_contact_release(after);
}

TEST_F(fem_contact, frames_stay_on_faces_that_get_other_numbers) {
  set_block(4);
  rollcon_contact* usual = roll(context);
  const std::array<double, 3> force = solved_force(usual);
  rollcon_contact_release(usual);
  rollcon_body_release(body);
  // The upper half comes first: its lower faces vanish, and all others get other numbers, once the other half is there.
  ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_FEM, &body));
  ASSERT_OK(rollcon_body_set_elastic(body, 0, young, poisson));
  ASSERT_OK(set_nodes_of_box());
  ASSERT_OK(add_layers(2, 4, 0));
  ASSERT_OK(tag_nodes_at(2, 1, 6));
  rollcon_contact* early = roll(context);
  ASSERT_OK(add_layers(0, 2, 0));
  ASSERT_OK(hold_bottom(ROLLCON_DOF_XYZ));
  expect_same(solved_force(early), force, 1e-9, "frame taken of half a body");
  rollcon_contact_release(early);
}

TEST_F(fem_contact, statistics) {
  set_block(4);
  ASSERT_OK(rollcon_context_set_threads(context, 1));
  ASSERT_OK(rollcon_body_prepare(body));
  const auto unknowns = static_cast<double>(3 * (box.nodes() - 25));
  EXPECT_EQ(statistic("unknowns"), unknowns);
  EXPECT_EQ(statistic("condensations"), 0);
  rollcon_contact* c = roll(context);
  solved_force(c);
  for (const char* name : {"assemblies", "factorizations", "condensations"}) EXPECT_EQ(statistic(name), 1) << name;
  EXPECT_GE(statistic("condensed_unknowns"), 3 * 25) << "those of the frame at least";
  EXPECT_LE(statistic("condensed_unknowns"), unknowns);
  EXPECT_GE(statistic("factor_nonzeros"), unknowns);
  EXPECT_GT(statistic("seconds_factor"), 0);
  EXPECT_GE(statistic("seconds_order"), 0);
  EXPECT_GE(statistic("bytes"), 8.0 * 75 * 75);
  EXPECT_GE(statistic("peak_bytes"), statistic("bytes"));
  EXPECT_EQ(statistic("kernel_evaluations"), 0) << "no boundary integrals";
  for (std::int32_t i = 0; i < rollcon_stat_count(ROLLCON_OF_BODY); ++i) {
    char name[32];
    ASSERT_OK(rollcon_stat_info(ROLLCON_OF_BODY, i, sizeof name, name, nullptr, nullptr, nullptr));
    EXPECT_TRUE(std::isfinite(statistic(name))) << name;
  }
  ASSERT_OK(rollcon_contact_set_creep(c, 2e-2, 0, 0));
  ASSERT_OK(solve_small(c));
  EXPECT_EQ(statistic("condensations"), 1) << "new creepages need none";
  rollcon_contact_release(c);
}

TEST_F(fem_contact, without_factors_another_frame_gives_the_same) {
  std::vector<std::array<double, 3>> force;
  for (const std::int64_t keep : {1, 0}) {
    rollcon_body_release(body);
    ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_FEM, &body));
    set_block(8);
    ASSERT_OK(rollcon_body_set_int(body, "keep_factors", keep));
    rollcon_contact* c = roll(context);
    force.push_back(solved_force(c));
    lay_frame(c);
    force.push_back(solved_force(c));
    EXPECT_EQ(statistic("condensations"), 2);
    rollcon_contact_release(c);
  }
  expect_same(force[2], force[0], 1e-12, "factors not kept, first frame");
  expect_same(force[3], force[1], 1e-12, "factors not kept, second frame");
  expect_same(force[1], force[0], 0.1, "the second frame instead of the first");
}

TEST_F(fem_contact_long, settings_of_the_discretisation_change_the_result_a_little) {
  const std::array<std::pair<const char*, std::int64_t>, 3> setting{{{"hex8", 0}, {"hex8", 1}, {"between_nodes", 1}}};
  std::vector<std::array<double, 3>> force;
  for (const auto& [name, value] : setting) {
    rollcon_body_release(body);
    ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_FEM, &body));
    set_block(8);
    ASSERT_OK(rollcon_body_set_int(body, name, value));
    rollcon_contact* c = roll(context);
    lay_frame(c);
    force.push_back(solved_force(c));
    rollcon_contact_release(c);
  }
  for (std::size_t i = 1; i < 3; ++i) {
    expect_same(force[i], force[0], 0.1, setting[i].first);
    EXPECT_GT(std::abs(force[i][2] - force[0][2]), 1e-6 * std::abs(force[0][2]))
        << setting[i].first << " is not ignored";
  }
}

TEST_F(fem_contact, a_contact_whose_body_failed_is_solved_once_it_is_mended) {
  set_block(4);
  ASSERT_OK(rollcon_body_set_elastic(body, 2, young, 0.5));
  rollcon_contact* c = roll(context);
  EXPECT_FAILS(rollcon_contact_solve(c), UNSUPPORTED, "body 1", "element 32", "poisson 0.5");
  ASSERT_OK(rollcon_body_set_elastic(body, 2, young, poisson));
  solved_force(c);
  rollcon_contact_release(c);
}
