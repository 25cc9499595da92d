/// Tests sizes that this process cannot have: they are refused with need, limit and remedy, and everything is usable
/// afterwards. The tests run in children, whose address space is limited.

#include <dlfcn.h>
#include <malloc.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "body_fixture.hpp"
#include "fem_fixture.hpp"

namespace capi_test {
namespace {

// The library may have a sanitizer that this program was compiled without.
bool sanitized() {
  return dlsym(RTLD_DEFAULT, "__asan_init") != nullptr || dlsym(RTLD_DEFAULT, "__tsan_init") != nullptr;
}

double address_space_in_use() {
  double pages = 0;
  if (std::FILE* file = std::fopen("/proc/self/statm", "r")) {
    if (std::fscanf(file, "%lf", &pages) != 1) pages = 0;
    std::fclose(file);
  }
  return pages * static_cast<double>(sysconf(_SC_PAGESIZE));
}

class MemoryLimits : public BodyApi {
 protected:
  void SetUp() override {
    if (sanitized()) GTEST_SKIP() << "address space belongs to the sanitizer";
    BodyApi::SetUp();
    if (IsSkipped()) return;
    // A child has none of its parent's OpenMP threads.
    ASSERT_OK(rollcon_context_set_threads(context, 1));
  }

  /// Runs in a child that may ask for `bytes` more than it has; failures are printed there.
  void in_child(double bytes, const std::function<void()>& run) {
    std::fflush(nullptr);
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      malloc_trim(0);  // what tests before this one have freed
      rlimit limit{};
      getrlimit(RLIMIT_AS, &limit);
      limit.rlim_cur = static_cast<rlim_t>(address_space_in_use() + bytes);
      setrlimit(RLIMIT_AS, &limit);
      run();
      std::fflush(nullptr);
      _exit(HasFailure() ? 1 : 0);
    }
    int status = -1;
    waitpid(child, &status, 0);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << "status " << status;
  }

  void expect_refusal(std::int32_t status, const char* need, const char* remedy) {
    EXPECT_EQ(status, ROLLCON_ERR_MEMORY);
    const std::string text = error();
    std::printf("%s\n", text.c_str());
    for (const char* word : {need, "the limit on address space leaves this process ", remedy})
      EXPECT_NE(text.find(word), std::string::npos) << "'" << word << "' in: " << text;
  }

  void take_frame(int n) {
    set_scene();
    const SquareFrame large(n, 1.5);
    ASSERT_OK(set_nodes(large));
    ASSERT_OK(add_elements(large));
  }

  /// Expects a solve on the fixture's small frame to work.
  void expect_usable() {
    set_scene();
    ASSERT_OK(rollcon_contact_solve(contact));
    double force[3] = {}, moment[3] = {};
    ASSERT_OK(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, force, moment));
    EXPECT_LT(force[2], -50);
    EXPECT_GT(force[2], -500);
  }
};

TEST_F(MemoryLimits, dense_operators_of_a_large_frame_are_refused) {
  for (const char* operators : {"dense", "table"}) {
    in_child(250e6, [&] {
      take_frame(60);
      ASSERT_OK(rollcon_contact_set_str(contact, "operators", operators));
      // The operators have 9 blocks of 3721 squared doubles.
      expect_refusal(rollcon_contact_solve(contact), "the operators of a frame of 3721 nodes need 0.997",
                     "'operators' = 'fft' needs no matrices");
      expect_usable();
    });
  }
}

TEST_F(MemoryLimits, the_monolithic_system_of_a_large_frame_is_refused) {
  if (!rollcon_has_feature("procedures")) GTEST_SKIP() << "this build has no procedures";
  in_child(250e6, [&] {
    take_frame(44);
    ASSERT_OK(rollcon_contact_set_procedure(contact, "system=monolithic"));
    // The need is 264 n^2 bytes.
    expect_refusal(rollcon_contact_solve(contact),
                   "the monolithic system of a frame of 2025 nodes on half-spaces needs 1.08",
                   "choose the condensed system");
    ASSERT_OK(rollcon_contact_set_procedure(contact, ""));
    expect_usable();
  });
}

// The least that a solve takes is known beforehand, what it takes in all is not.
TEST_F(MemoryLimits, a_large_grid_is_refused_before_or_in_its_solve) {
  if (!rollcon_has_feature("fftw")) GTEST_SKIP() << "this build is without FFTW";
  for (const auto& [left, need] : {std::pair{150e6, "a solve on a frame of 263169 nodes needs at least 0.171"},
                                   {280e6, "the solve on a frame of 263169 nodes needs more than 0."}})
    in_child(left, [&] {
      take_frame(512);
      expect_refusal(rollcon_contact_solve(contact), need, "take a coarser or smaller frame");
      expect_usable();
    });
}

TEST_F(MemoryLimits, a_large_finite_element_body_is_refused) {
  if (!rollcon_has_feature("fem")) GTEST_SKIP() << "this build has no finite elements";
  for (const double left : {60e6, 400e6})
    in_child(left, [&] {
      const BoxVolume box(30);
      rollcon_body* block = nullptr;
      ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_FEM, &block));
      ASSERT_OK(rollcon_body_set_elastic(block, 0, 200, 0.3));
      give_mesh(block, box);
      const std::vector<std::int32_t> bottom = box.nodes_at(2, 0);
      ASSERT_OK(rollcon_body_set_support(block, static_cast<std::int64_t>(bottom.size()), bottom.data(), 0,
                                         ROLLCON_DOF_XYZ, nullptr));
      const std::int32_t contact_tag = 6;
      ASSERT_OK(rollcon_body_set_contact_faces(block, 1, &contact_tag));
      expect_refusal(rollcon_body_prepare(block), "the factorisation of a sparse matrix with 86490 unknowns needs ",
                     "take a coarser mesh");
      rollcon_body_release(block);
      expect_usable();
    });
}

TEST_F(MemoryLimits, a_large_boundary_element_body_is_refused) {
  in_child(250e6, [&] {
    cube = CubeSurface(22);
    set_mesh(body);
    ASSERT_OK(hold_bottom(7));
    // The body has 2906 nodes, and tractions on some: at least 8 bytes x (3 x 2906)^2.
    expect_refusal(rollcon_body_prepare(body), "the matrix of a boundary-element body with ", "finite elements");
    EXPECT_NE(error().find(" needs 0.6"), std::string::npos) << error();
    expect_usable();
  });
}

}  // namespace
}  // namespace capi_test
