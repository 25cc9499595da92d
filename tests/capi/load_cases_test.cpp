// Tests tractions by node, along axes and along the surface's own; several load cases that use one body's equations.

#include "block20.hpp"

namespace {

using namespace capi_test;

/// Makes a block, [-1, 1]^2 x [-1, 0] with its bottom held, of finite or of boundary elements. Its top has the tag 6.
class load_cases : public ::testing::TestWithParam<std::int32_t> {
 protected:
  void SetUp() override {
    ASSERT_OK(rollcon_context_create(ROLLCON_ABI, &context));
    rollcon_body* probe = nullptr;
    if (rollcon_body_create(context, GetParam(), &probe) == ROLLCON_ERR_UNSUPPORTED)
      GTEST_SKIP() << "no such bodies in this build";
    rollcon_body_release(probe);
    const Block20 block(2, 2, 1, 1);
    const bool volume = GetParam() == ROLLCON_BODY_FEM;
    const Surface8 surface(block);
    x = volume ? block.x : surface.x;
    connectivity = volume ? block.connectivity : surface.connectivity;
    top = volume ? block.top : surface.top;
    for (std::size_t k = 0; k < x.size(); k += 3)
      if (x[k + 2] < -1 + 1e-12) bottom.push_back(static_cast<std::int32_t>(k / 3));
  }
  void TearDown() override {
    for (rollcon_body* b : made) rollcon_body_release(b);
    rollcon_context_release(context);
  }
  rollcon_body* block(const std::function<std::array<double, 3>(const double*)>& map = {}) {
    const bool volume = GetParam() == ROLLCON_BODY_FEM;
    rollcon_body* b = nullptr;
    EXPECT_OK(rollcon_body_create(context, GetParam(), &b));
    made.push_back(b);
    std::vector<double> at = x;
    for (std::size_t k = 0; map && k < at.size(); k += 3) {
      const auto to = map(&x[k]);
      std::copy_n(to.data(), 3, &at[k]);
    }
    EXPECT_OK(rollcon_body_set_nodes(b, nodes(), at.data(), 3, 1));
    const std::int64_t width = volume ? 20 : 8;
    EXPECT_OK(rollcon_body_add_elements(b, volume ? ROLLCON_HEX20 : ROLLCON_QUAD8,
                                        static_cast<std::int64_t>(connectivity.size()) / width, connectivity.data(), 0,
                                        volume ? 0 : 1));
    EXPECT_OK(rollcon_body_set_elastic(b, 0, 1000, 0.3));
    EXPECT_OK(hold(b, bottom, ROLLCON_DOF_XYZ));
    EXPECT_OK(rollcon_body_tag_faces_of_nodes(b, static_cast<std::int64_t>(top.size()), top.data(), 0, 6));
    const std::int32_t tag = 6;
    EXPECT_OK(rollcon_body_set_contact_faces(b, 1, &tag));
    return b;
  }
  rollcon_body* copy_of(rollcon_body* b) {
    rollcon_body* c = nullptr;
    EXPECT_OK(rollcon_body_copy(b, &c));
    made.push_back(c);
    return c;
  }
  void load_by_node(rollcon_body* b, const double* along,
                    const std::function<std::array<double, 3>(const double*)>& t) {
    std::vector<double> traction;
    for (const std::int32_t k : top) {
      const auto value = t(&x[3 * static_cast<std::size_t>(k)]);
      traction.insert(traction.end(), value.begin(), value.end());
    }
    EXPECT_OK(rollcon_body_set_node_tractions(b, 6, static_cast<std::int64_t>(top.size()), top.data(), 0, along,
                                              traction.data()));
  }
  std::vector<double> displacements(rollcon_body* b) {
    std::vector<double> u(x.size());
    EXPECT_OK(rollcon_body_prepare(b));
    EXPECT_OK(rollcon_body_get_displacements(b, nodes(), u.data()));
    return u;
  }
  static double difference(const std::vector<double>& a, const std::vector<double>& b) {
    double most = 0, size = 0;
    for (std::size_t k = 0; k < a.size(); ++k) {
      most = std::max(most, std::abs(a[k] - b[k]));
      size = std::max(size, std::abs(b[k]));
    }
    return most / size;
  }
  double statistic(rollcon_body* b, const char* name) {
    double value = 0;
    EXPECT_OK(rollcon_body_get_stat(b, name, &value));
    return value;
  }
  std::int64_t nodes() const { return static_cast<std::int64_t>(x.size() / 3); }

  rollcon_context* context = nullptr;
  std::vector<rollcon_body*> made;
  std::vector<double> x;
  std::vector<std::int32_t> connectivity, top, bottom;
};

TEST_P(load_cases, tractions_by_node_add_up) {
  rollcon_body *whole = block(), *by_node = block();
  const double traction[] = {3, -1, 2};
  ASSERT_OK(rollcon_body_set_traction(whole, 6, traction));
  load_by_node(by_node, nullptr, [](const double*) { return std::array<double, 3>{3, -1, 2}; });
  const double same = difference(displacements(by_node), displacements(whole));
  // The tractions are linear between nodes, on top of a pressure; force and moment of the supports have a closed form.
  rollcon_body* b = block();
  load_by_node(b, nullptr, [](const double* p) { return std::array<double, 3>{0, p[0], 1 + p[0]}; });
  ASSERT_OK(rollcon_body_set_pressure(b, 6, 0.5));
  displacements(b);
  double force[3], moment[3];
  ASSERT_OK(rollcon_body_get_reaction(b, force, moment));
  const double expected[] = {0, 0, -2, 0, 4.0 / 3, -4.0 / 3};
  double worst = 0;
  for (std::size_t c = 0; c < 3; ++c)
    worst = std::max({worst, std::abs(force[c] - expected[c]), std::abs(moment[c] - expected[3 + c])});
  const double bound = GetParam() == ROLLCON_BODY_FEM ? 1e-12 : 0.04;
  std::printf("uniform by node: %.1e (bound 1e-12); reaction and its moment: %.1e (bound %.0e)\n", same, worst, bound);
  EXPECT_LE(same, 1e-12);
  EXPECT_LE(worst, bound);
}

// Tractions along the normal of a curved top are a pressure; those along a direction in it keep at right angles to
// that.
TEST_P(load_cases, components_follow_the_surface) {
  const auto bent = [](const double* p) {
    return std::array<double, 3>{p[0], p[1], p[2] + 0.3 * (1 + p[2]) * p[0] * p[0]};
  };
  rollcon_body *pressed = block(bent), *by_node = block(bent);
  ASSERT_OK(rollcon_body_set_pressure(pressed, 6, 2));
  const double along[] = {0, 5, 0};
  load_by_node(by_node, along, [](const double*) { return std::array<double, 3>{0, 0, -2}; });
  const double normal = difference(displacements(by_node), displacements(pressed));
  rollcon_body *straight = block(bent), *first = block(bent);
  const double traction[] = {0, 1.5, 0};
  ASSERT_OK(rollcon_body_set_traction(straight, 6, traction));
  load_by_node(first, along, [](const double*) { return std::array<double, 3>{1.5, 0, 0}; });
  const double tangent = difference(displacements(first), displacements(straight));
  // The second component is along n x the first: -x where the surface is level.
  rollcon_body *across = block(), *minus = block();
  const double back[] = {-1.5, 0, 0};
  ASSERT_OK(rollcon_body_set_traction(minus, 6, back));
  load_by_node(across, along, [](const double*) { return std::array<double, 3>{0, 1.5, 0}; });
  const double second = difference(displacements(across), displacements(minus));
  std::printf("along the normal %.1e, along y %.1e, across %.1e (bounds 1e-12)\n", normal, tangent, second);
  EXPECT_LE(normal, 1e-12);
  EXPECT_LE(tangent, 1e-12);
  EXPECT_LE(second, 1e-12);
}

TEST_P(load_cases, share_one_factorisation) {
  rollcon_body* first = block();
  const double one[] = {0, 0, -3}, two[] = {1, 2, 0};
  ASSERT_OK(rollcon_body_set_traction(first, 6, one));
  const std::vector<double> u1 = displacements(first);
  rollcon_body *second = copy_of(first), *third = copy_of(second);
  ASSERT_OK(rollcon_body_set_traction(second, 6, two));
  const std::vector<double> u2 = displacements(second);
  const double factorised = statistic(first, "factorizations");
  std::vector<double> moved(3 * bottom.size(), 0.01);
  ASSERT_OK(rollcon_body_set_support(third, static_cast<std::int64_t>(bottom.size()), bottom.data(), 0, ROLLCON_DOF_XYZ,
                                     moved.data()));
  load_by_node(third, nullptr, [](const double* p) { return std::array<double, 3>{0, 0, p[1]}; });
  const std::vector<double> u3 = displacements(third);
  EXPECT_EQ(statistic(first, "factorizations"), factorised);
  EXPECT_EQ(displacements(first), u1);

  // The load cases run by themselves, in a context of their own.
  rollcon_context* shared = context;
  ASSERT_OK(rollcon_context_create(ROLLCON_ABI, &context));
  rollcon_body *alone2 = block(), *alone3 = block();
  ASSERT_OK(rollcon_body_set_traction(alone2, 6, two));
  const double off2 = difference(u2, displacements(alone2));
  rollcon_context* other = context;
  context = nullptr;
  ASSERT_OK(rollcon_context_create(ROLLCON_ABI, &context));
  rollcon_context_release(other);
  rollcon_body* last = block();
  ASSERT_OK(rollcon_body_set_traction(last, 6, one));
  ASSERT_OK(rollcon_body_set_support(last, static_cast<std::int64_t>(bottom.size()), bottom.data(), 0, ROLLCON_DOF_XYZ,
                                     moved.data()));
  load_by_node(last, nullptr, [](const double* p) { return std::array<double, 3>{0, 0, p[1]}; });
  const double off3 = difference(u3, displacements(last));
  static_cast<void>(alone3);
  rollcon_context_release(context);
  context = shared;
  std::printf("displacements of load cases beside bodies by themselves: %.1e, %.1e (bounds 1e-11)\n", off2, off3);
  EXPECT_LE(off2, 1e-11);
  EXPECT_LE(off3, 1e-11);

  // A saved case is a body by itself.
  const std::string path = ::testing::TempDir() + "rollcon_load_case";
  ASSERT_OK(rollcon_body_save(third, path.c_str()));
  rollcon_body* again = nullptr;
  ASSERT_OK(rollcon_context_create(ROLLCON_ABI, &other));
  ASSERT_OK(rollcon_body_load(other, path.c_str(), &again));
  made.push_back(again);
  EXPECT_EQ(displacements(again), u3);
  double force[2][3], moment[2][3];
  ASSERT_OK(rollcon_body_get_reaction(third, force[0], moment[0]));
  ASSERT_OK(rollcon_body_get_reaction(again, force[1], moment[1]));
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(force[0][c], force[1][c], 1e-12);
    EXPECT_NEAR(moment[0][c], moment[1][c], 1e-12);
  }
  rollcon_context_release(other);
  std::remove(path.c_str());
}

TEST_P(load_cases, bad_tractions_are_refused) {
  rollcon_body* b = block();
  const std::int32_t one[] = {0}, wrong[] = {1000000};
  const double t[] = {0, 0, 1}, along[] = {0, 0, 2}, nan[] = {0, std::nan(""), 0};
  EXPECT_FAILS(rollcon_body_set_node_tractions(b, 6, 1, wrong, 0, nullptr, t), MESH, "1000000");
  EXPECT_FAILS(rollcon_body_set_node_tractions(b, 6, 1, one, 0, nullptr, nan), NONFINITE, "component 1 of entry 0");
  EXPECT_FAILS(rollcon_body_set_node_tractions(b, 6, 1, one, 0, nan, t), NONFINITE, "along");
  EXPECT_FAILS(rollcon_body_set_node_tractions(b, 77, 1, one, 0, nullptr, t), ARGUMENT, "77");
  EXPECT_FAILS(rollcon_body_set_node_tractions(b, 6, 1, one, 0, nullptr, nullptr), ARGUMENT, "tractions");
  EXPECT_FAILS(rollcon_body_copy(b, nullptr), ARGUMENT, "copy is NULL");
  ASSERT_OK(rollcon_body_set_node_tractions(b, 6, 1, bottom.data(), 0, nullptr, t));
  EXPECT_FAILS(rollcon_body_prepare(b), MESH, "on no face with that tag");
  ASSERT_OK(rollcon_body_set_node_tractions(b, 6, 1, top.data(), 0, along, t));
  EXPECT_FAILS(rollcon_body_prepare(b), MESH, "normal to");
  ASSERT_OK(rollcon_body_set_node_tractions(b, 6, 0, nullptr, 0, nullptr, nullptr));
  ASSERT_OK(rollcon_body_prepare(b));
  EXPECT_FAILS(rollcon_body_set_node_tractions(b, 6, 1, one, 0, nullptr, t), STATE, "prepared");
}

INSTANTIATE_TEST_SUITE_P(capi, load_cases, ::testing::Values(ROLLCON_BODY_FEM, ROLLCON_BODY_BEM),
                         [](const auto& param) { return param.param == ROLLCON_BODY_FEM ? "fem" : "bem"; });

}  // namespace
