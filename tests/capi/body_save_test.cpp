/// Tests prepared bodies saved and loaded: the same tractions to the last bit, nothing assembled or factorised; files
/// that are no such bodies are refused.

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "body_fixture.hpp"
#include "fem_fixture.hpp"

using namespace capi_test;
namespace fs = std::filesystem;

namespace {

/// Holds what a solve with a body gave.
struct Rolled {
  std::int32_t status = -1;
  std::vector<double> traction;
};

class Saved : public BodyApi {
 protected:
  void SetUp() override {
    BodyApi::SetUp();
    folder = fs::temp_directory_path() / ("rollcon_bodies_" + std::to_string(getpid()));
    fs::create_directory(folder);
    path = (folder / "body.rcb").string();
    cube = CubeSurface(4);
  }
  void TearDown() override {
    fs::remove_all(folder);
    BodyApi::TearDown();
  }

  void give_cube() {
    set_mesh(body);
    ASSERT_OK(hold_bottom(ROLLCON_DOF_XYZ));
  }

  /// Gives a box of finite elements instead, held at its bottom; its top has tag 6.
  void give_box() {
    rollcon_body_release(body);
    body = nullptr;
    ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_FEM, &body));
    const BoxVolume box(4);
    ASSERT_OK(rollcon_body_set_elastic(body, 0, young, poisson));
    give_mesh(body, box);
    ASSERT_OK(hold(body, box.nodes_at(2, 0), ROLLCON_DOF_XYZ));
    const std::int32_t tag = 6;
    ASSERT_OK(rollcon_body_set_contact_faces(body, 1, &tag));
  }

  /// Rolls a rigid sphere of radius 1 on the top: the frame is its faces, or a mesh laid on it.
  Rolled roll(rollcon_body* b, bool laid = false) {
    rollcon_contact* c = roll_on_top(context, b, plane, {.approach = 0.03, .tag = laid ? 0 : 6});
    if (laid) give_frame(c, moved(SquareFrame(7, 0.35), 0.5, 0.5, 1));
    Rolled result;
    result.status = rollcon_contact_solve(c);
    EXPECT_GE(result.status, ROLLCON_OK) << error();
    std::int64_t nodes = 0, elements = 0;
    EXPECT_OK(rollcon_contact_get_size(c, &nodes, &elements));
    result.traction.resize(static_cast<std::size_t>(3 * nodes));
    EXPECT_OK(rollcon_contact_get_tractions(c, ROLLCON_LOCAL, nodes, result.traction.data()));
    rollcon_contact_release(c);
    return result;
  }

  double count(rollcon_body* b, const char* name) {
    double value = -1;
    EXPECT_OK(rollcon_body_get_stat(b, name, &value));
    return value;
  }
  /// Loads the body in a context of its own, unless one is given.
  rollcon_body* load(rollcon_context* where = nullptr) {
    rollcon_context* own = where;
    if (!own) {
      EXPECT_OK(rollcon_context_create(ROLLCON_ABI, &own));
    }
    rollcon_body* b = nullptr;
    EXPECT_OK(rollcon_body_load(own, path.c_str(), &b));
    if (!where) rollcon_context_release(own);
    return b;
  }
  void expect_same(const Rolled& a, const Rolled& b, const char* what) {
    EXPECT_EQ(a.status, b.status) << what;
    EXPECT_EQ(a.traction, b.traction) << what;
    double largest = 0;
    for (const double t : a.traction) largest = std::max(largest, std::abs(t));
    EXPECT_GT(largest, 0) << what;
  }
  /// Solves before and after, on the body's faces and on a laid frame, with responses stored and not.
  void expect_solves_the_same() {
    ASSERT_OK(rollcon_body_save(body, path.c_str()));
    EXPECT_EQ(count(body, "factorizations"), 1) << "it was prepared";
    rollcon_body* before = load();
    const Rolled own = roll(body), laid = roll(body, true);
    ASSERT_OK(rollcon_body_save(body, path.c_str()));
    rollcon_body* after = load();
    EXPECT_EQ(count(before, "responses_kept"), 0);
    EXPECT_EQ(count(after, "responses_kept"), 2);
    for (rollcon_body* b : {before, after}) {
      EXPECT_EQ(count(b, "loaded"), 1);
      for (const char* same : {"unknowns", "condition", "condensed_unknowns", "factor_nonzeros"})
        EXPECT_EQ(count(b, same), count(body, same)) << same;
      expect_same(roll(b), own, "faces");
      expect_same(roll(b, true), laid, "laid");
      EXPECT_EQ(count(b, "assemblies"), 0);
      EXPECT_EQ(count(b, "factorizations"), 0);
      EXPECT_EQ(count(b, "condensations"), b == before ? 2 : 0);
    }
    rollcon_body_release(before);
    rollcon_body_release(after);
  }

  std::string bytes() const {
    std::ifstream in(path, std::ios::binary);
    std::stringstream all;
    all << in.rdbuf();
    return all.str();
  }
  void overwrite(const std::string& bytes) const { std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes; }

  fs::path folder;
  std::string path;
};

class body_save : public Saved {};

}  // namespace

TEST_F(body_save, boundary_elements_solve_the_same) {
  if (!rollcon_has_feature("bem")) GTEST_SKIP() << "this build has no boundary elements";
  give_cube();
  expect_solves_the_same();
}

TEST_F(body_save, finite_elements_solve_the_same) {
  if (!rollcon_has_feature("fem")) GTEST_SKIP() << "this build has no finite elements";
  give_box();
  expect_solves_the_same();
}

TEST_F(body_save, own_loads_are_there_without_solving) {
  for (const bool fem : {false, true}) {
    if (!rollcon_has_feature(fem ? "fem" : "bem")) continue;
    if (fem)
      give_box();
    else
      give_cube();
    const double pull[3] = {1, 2, 3};
    ASSERT_OK(rollcon_body_set_traction(body, 6, pull));
    ASSERT_OK(rollcon_body_save(body, path.c_str()));
    rollcon_body* b = load();
    std::int64_t nodes = 0;
    ASSERT_OK(rollcon_body_get_size(body, &nodes, nullptr));
    std::vector<double> u(static_cast<std::size_t>(3 * nodes)), v(u.size(), 7);
    double force[3], moment[3], same_force[3], same_moment[3];
    ASSERT_OK(rollcon_body_get_displacements(body, nodes, u.data()));
    ASSERT_OK(rollcon_body_get_displacements(b, nodes, v.data()));
    EXPECT_EQ(u, v);
    ASSERT_OK(rollcon_body_get_reaction(body, force, moment));
    ASSERT_OK(rollcon_body_get_reaction(b, same_force, same_moment));
    EXPECT_LT(force[2], -2);
    for (int c = 0; c < 3; ++c) {
      EXPECT_EQ(force[c], same_force[c]);
      EXPECT_EQ(moment[c], same_moment[c]);
    }
    EXPECT_EQ(count(b, "factorizations"), 0);
    rollcon_body_release(b);
  }
}

TEST_F(body_save, half_spaces_and_rigid_bodies) {
  ASSERT_OK(rollcon_body_save(sphere, path.c_str()));
  rollcon_body* half = load(context);
  ASSERT_OK(rollcon_body_save(plane, path.c_str()));
  rollcon_body* rigid = load(context);
  std::int32_t kind = 0;
  ASSERT_OK(rollcon_body_get_kind(half, &kind));
  EXPECT_EQ(kind, ROLLCON_BODY_HALFSPACE);
  ASSERT_OK(rollcon_body_get_kind(rigid, &kind));
  EXPECT_EQ(kind, ROLLCON_BODY_RIGID);
  std::vector<double> force;
  set_scene();
  const auto solve = [&](rollcon_body* one, rollcon_body* two) {
    rollcon_contact_release(contact);
    ASSERT_OK(rollcon_contact_create(context, one, two, &contact));
    set_scene();
    ASSERT_OK(rollcon_contact_solve(contact));
    double f[3];
    ASSERT_OK(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, f, nullptr));
    force.insert(force.end(), f, f + 3);
  };
  solve(sphere, plane);
  solve(half, rigid);
  for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(force[c], force[c + 3]);
  rollcon_body_release(half);
  rollcon_body_release(rigid);

  rollcon_body* surface = nullptr;
  ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_RIGID, &surface));
  set_mesh(surface);
  ASSERT_OK(rollcon_body_save(surface, path.c_str()));
  rollcon_body_release(surface);
  rigid = load();
  std::int64_t nodes = 0, elements = 0;
  ASSERT_OK(rollcon_body_get_size(rigid, &nodes, &elements));
  EXPECT_EQ(nodes, cube.nodes());
  EXPECT_EQ(elements, 6 * cube.face_elements());
  EXPECT_EQ(rollcon_body_set_int(rigid, "keep_factors", 1), ROLLCON_ERR_STATE) << "prepared";
  rollcon_body_release(rigid);
}

// A file without factors has the stored responses; other frames assemble, and say so.
TEST_F(body_save, what_is_not_in_the_file_is_found_again_and_counted) {
  if (!rollcon_has_feature("bem")) GTEST_SKIP() << "this build has no boundary elements";
  give_cube();
  ASSERT_OK(rollcon_body_set_int(body, "keep_factors", 0));
  const Rolled own = roll(body);
  ASSERT_OK(rollcon_body_save(body, path.c_str()));
  rollcon_body* b = load();
  expect_same(roll(b), own, "kept");
  EXPECT_EQ(count(b, "assemblies"), 0);
  const Rolled laid = roll(b, true);
  EXPECT_EQ(count(b, "assemblies"), 1);
  EXPECT_EQ(count(b, "factorizations"), 1);
  expect_same(roll(body, true), laid, "found again");
  rollcon_body_release(b);
}

TEST_F(body_save, options_come_back) {
  give_cube();
  ASSERT_OK(rollcon_body_set_real(body, "accuracy", 1e-5));
  ASSERT_OK(rollcon_body_set_int(body, "cache_bytes", 12345));
  ASSERT_OK(rollcon_body_save(body, path.c_str()));
  rollcon_body* b = load();
  double accuracy = 0;
  std::int64_t bytes = 0;
  ASSERT_OK(rollcon_body_get_real(b, "accuracy", &accuracy));
  ASSERT_OK(rollcon_body_get_int(b, "cache_bytes", &bytes));
  EXPECT_EQ(accuracy, 1e-5);
  EXPECT_EQ(bytes, 12345);
  rollcon_body_release(b);
}

TEST_F(body_save, loaded_twice_or_beside_an_equal_body_it_is_held_once) {
  give_cube();
  ASSERT_OK(rollcon_body_save(body, path.c_str()));
  rollcon_body* beside = load(context);
  EXPECT_EQ(count(beside, "shared"), 1);
  EXPECT_EQ(count(beside, "loaded"), 1);
  EXPECT_EQ(count(beside, "factorizations"), 1) << "of the body that was there";
  rollcon_context* other = nullptr;
  ASSERT_OK(rollcon_context_create(ROLLCON_ABI, &other));
  rollcon_body *first = load(other), *second = load(other);
  EXPECT_EQ(count(first, "shared"), 0);
  EXPECT_EQ(count(second, "shared"), 1);
  EXPECT_EQ(count(second, "factorizations"), 0);
  for (rollcon_body* b : {beside, first, second}) rollcon_body_release(b);
  rollcon_context_release(other);
}

TEST_F(body_save, a_body_that_cannot_be_prepared_is_not_saved) {
  set_mesh(body);
  EXPECT_FAILS(rollcon_body_save(body, path.c_str()), SINGULAR, "supports");
  EXPECT_FALSE(fs::exists(path));
  ASSERT_OK(hold_bottom(ROLLCON_DOF_XYZ));
  EXPECT_OK(rollcon_body_save(body, path.c_str()));
}

TEST_F(body_save, arguments_and_paths) {
  rollcon_body* b = plane;
  EXPECT_FAILS(rollcon_body_save(plane, nullptr), ARGUMENT, "path is NULL");
  EXPECT_FAILS(rollcon_body_save(plane, ""), ARGUMENT, "path is empty");
  EXPECT_EQ(rollcon_body_save(nullptr, path.c_str()), ROLLCON_ERR_ARGUMENT);
  EXPECT_FAILS(rollcon_body_load(context, nullptr, &b), ARGUMENT, "path is NULL");
  EXPECT_EQ(b, nullptr);
  EXPECT_FAILS(rollcon_body_load(context, "", &b), ARGUMENT, "path is empty");
  EXPECT_FAILS(rollcon_body_load(context, path.c_str(), nullptr), ARGUMENT, "body is NULL");
  EXPECT_EQ(rollcon_body_load(nullptr, path.c_str(), &b), ROLLCON_ERR_ARGUMENT);
  EXPECT_FAILS(rollcon_body_load(context, path.c_str(), &b), IO, path, "No such file");
  EXPECT_FAILS(rollcon_body_load(context, folder.c_str(), &b), IO, folder.string(), "no regular file");
  EXPECT_FAILS(rollcon_body_save(plane, folder.c_str()), IO, folder.string());
  const std::string nowhere = (folder / "no" / "where").string();
  EXPECT_FAILS(rollcon_body_save(plane, nowhere.c_str()), IO, nowhere, "No such file");
  overwrite("<VTKFile>" + std::string(2000, ' '));
  EXPECT_FAILS(rollcon_body_load(context, path.c_str(), &b), IO, path, "not a saved body");
}

TEST_F(body_save, damaged_files_are_refused) {
  const auto refused = [&](const std::string& bad, std::size_t where) {
    overwrite(bad);
    rollcon_body* b = plane;
    const std::int32_t status = rollcon_body_load(context, path.c_str(), &b);
    ASSERT_TRUE(status == ROLLCON_ERR_IO || status == ROLLCON_ERR_UNSUPPORTED)
        << where << ": " << status << ", " << error();
    ASSERT_NE(error().find(path), std::string::npos) << error();
    ASSERT_EQ(b, nullptr);
  };
  for (const bool fem : {false, true}) {
    if (!rollcon_has_feature(fem ? "fem" : "bem")) continue;
    if (fem) {
      give_box();
    } else {
      cube = CubeSurface(2);
      give_cube();
    }
    roll(body, fem);
    ASSERT_OK(rollcon_body_save(body, path.c_str()));
    const std::string good = bytes();
    const std::size_t step = std::max<std::size_t>(1, good.size() / 500);
    for (std::size_t k = 0; k < good.size(); k += k < 600 ? 3 : step) {
      std::string bad = good;
      bad[k] = static_cast<char>(bad[k] ^ 1 << k % 8);
      refused(bad, k);
    }
    for (std::size_t length = 0; length < good.size(); length += length < 600 ? 29 : 10 * step)
      refused(good.substr(0, length), length);
    refused(good + '\0', good.size());
    overwrite(good);
    rollcon_body* b = load();
    EXPECT_NE(b, nullptr) << "undamaged it is read";
    rollcon_body_release(b);
  }
}
