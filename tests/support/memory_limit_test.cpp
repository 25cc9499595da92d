// Tests limits of memory, from a folder that looks like that of control groups, and those of a process.

#include "support/memory_limit.hpp"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "support/error.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

constexpr double GiB = 1024.0 * 1024 * 1024;

/// Puts a folder in place of /sys/fs/cgroup, and a file in place of /proc/self/cgroup.
class Groups : public ::testing::Test {
 protected:
  void SetUp() override {
    std::string pattern = ::testing::TempDir() + "groupsXXXXXX";
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    root_ = pattern;
    sources_.available = 64 * GiB;
    sources_.groups = root_ + "/membership";
    sources_.mount = root_ + "/mount";
    sources_.address_space = sources_.data = INFINITY;
  }
  void TearDown() override { std::filesystem::remove_all(root_); }

  void membership(const std::string& lines) { std::ofstream(sources_.groups) << lines; }
  void limit(const std::string& file, const std::string& text) {
    const std::filesystem::path path = sources_.mount + "/" + file;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path) << text << "\n";
  }
  double bytes() const { return memory_limit(sources_).bytes; }

  std::string root_;
  MemorySources sources_;
};

TEST_F(Groups, none) {
  EXPECT_EQ(bytes(), 64 * GiB);
  EXPECT_STREQ(memory_limit(sources_).what, "this machine has free");
  membership("");
  EXPECT_EQ(bytes(), 64 * GiB);
  membership("no colon\none:colon\n0::/\n");
  EXPECT_EQ(bytes(), 64 * GiB);
}

TEST_F(Groups, version_2_takes_the_least_of_the_group_and_those_above) {
  membership("0::/user.slice/job\n");
  limit("user.slice/job/memory.max", "max");
  EXPECT_EQ(bytes(), 64 * GiB);
  limit("user.slice/memory.max", "8589934592");
  EXPECT_EQ(bytes(), 8 * GiB);
  EXPECT_STREQ(memory_limit(sources_).what, "the control group of this process leaves");
  limit("user.slice/job/memory.max", "2147483648");
  EXPECT_EQ(bytes(), 2 * GiB);
  limit("other/memory.max", "1048576");  // limit of another group
  EXPECT_EQ(bytes(), 2 * GiB);
}

TEST_F(Groups, a_container_sees_its_limit_at_the_root) {
  membership("0::/outside/of/the/container\n");
  limit("memory.max", "1073741824");
  EXPECT_EQ(bytes(), 1 * GiB);
}

TEST_F(Groups, version_1) {
  membership("7:cpu,cpuacct:/\n4:memory:/jobs/17\n1:memoryless:/small\n");
  limit("memory/memory.limit_in_bytes", "9223372036854771712");  // this number means "none"
  EXPECT_EQ(bytes(), 64 * GiB);
  limit("memory/jobs/17/memory.limit_in_bytes", "3221225472");
  EXPECT_EQ(bytes(), 3 * GiB);
  limit("memory/small/memory.limit_in_bytes", "1073741824");
  EXPECT_EQ(bytes(), 3 * GiB);
}

// Memory of files that were read can be reclaimed for memory that is asked for.
TEST_F(Groups, what_is_in_use_is_taken_off_but_for_files_that_were_read) {
  membership("4:memory:/a\n0::/b\n");
  limit("unified/b/memory.max", "4294967296");
  limit("unified/b/memory.current", "3221225472");
  EXPECT_EQ(bytes(), 1 * GiB);
  limit("unified/b/memory.stat", "anon 1\ninactive_file 1073741824\nactive_file 1");
  EXPECT_EQ(bytes(), 2 * GiB);
  limit("memory/a/memory.limit_in_bytes", "2147483648");
  limit("memory/a/memory.usage_in_bytes", "2147483648");
  limit("memory/a/memory.stat", "inactive_file 7\ntotal_inactive_file 536870912");
  EXPECT_EQ(bytes(), 0.5 * GiB);
  limit("memory/a/memory.usage_in_bytes", "9663676416");  // above the limit, which was lowered
  EXPECT_EQ(bytes(), 0);
}

TEST_F(Groups, both_versions_at_once) {
  membership("4:memory:/a\n0::/b\n");
  limit("memory/a/memory.limit_in_bytes", "4294967296");
  limit("unified/b/memory.max", "2147483648");
  EXPECT_EQ(bytes(), 2 * GiB);
}

TEST_F(Groups, a_limit_above_the_machine_is_none) {
  membership("0::/\n");
  limit("memory.max", "1099511627776");
  EXPECT_EQ(bytes(), 64 * GiB);
  sources_.available = 0;  // unknown
  EXPECT_EQ(bytes(), 1024 * GiB);
}

TEST(MemoryLimit, of_this_process_is_that_of_the_machine_or_less) {
  const MemorySources sources = memory_sources();
  const double machine = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  EXPECT_GT(sources.available, 0);
  EXPECT_LT(sources.available, machine);
  EXPECT_LE(memory_limit(sources).bytes, sources.available);
  EXPECT_GT(memory_limit(sources).bytes, 1e8);
}

TEST(MemoryLimit, what_fits_passes) {
  EXPECT_NO_THROW(require_memory({1e5, 1e5}, "none", "a matrix needs"));
  EXPECT_NO_THROW(require_memory({2e7, 2e7}, "none", "a matrix needs"));
  // Memory that is not written to need not be on the machine.
  rlimit limit{};
  getrlimit(RLIMIT_AS, &limit);
  if (limit.rlim_cur != RLIM_INFINITY) GTEST_SKIP() << "address space is limited here";
  EXPECT_NO_THROW(require_memory({1e17, 1e6}, "none", "a matrix needs"));
}

TEST(MemoryLimit, a_refusal_names_subject_need_limit_and_remedy) {
  try {
    require_memory({4e15, 4e15}, "take less", "the matrix of %d unknowns needs", 7);
    FAIL() << "4e15 bytes were granted";
  } catch (const Error& error) {
    EXPECT_EQ(error.status(), Status::err_memory);
    const std::string text = error.what();
    EXPECT_EQ(text.find("the matrix of 7 unknowns needs 4e+06 GB, "), 0U) << text;
    EXPECT_NE(text.find(" GB: take less"), std::string::npos) << text;
  }
}

// Runs the body in a child, because limits that are lowered stay low. Returns the child's exit status.
template <class F>
int in_child(F&& body) {
  const pid_t child = fork();
  if (child == 0) _exit(body());
  int status = -1;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(MemoryLimit, limits_of_the_process_count_with_what_is_in_use) {
  for (const auto resource : {RLIMIT_AS, RLIMIT_DATA}) {
    const double before = resource == RLIMIT_AS ? memory_sources().address_space : memory_sources().data;
    EXPECT_GT(before, 2 * GiB);
    // The child returns 1 if nothing is in use, 2 if the limit is not seen, 3 or 4 for a wrong refusal or none, 5 for
    // its text.
    EXPECT_EQ(in_child([&] {
                constexpr double limit = 0x1p46;  // sanitizers have mapped most of 2^47 bytes
                rlimit low{};
                getrlimit(resource, &low);
                low.rlim_cur = static_cast<rlim_t>(limit);
                setrlimit(resource, &low);
                const MemorySources sources = memory_sources();
                const double left = resource == RLIMIT_AS ? sources.address_space : sources.data;
                if (!(left < limit)) return 1;
                if (allocation_limit(sources).bytes != left) return 2;
                try {
                  require_memory({2e7, 2e7}, "none", "a matrix needs");
                } catch (const Error&) {
                  return left < 2e7 ? 0 : 3;
                }
                try {
                  require_memory({0x1p47, 2e7}, "none", "a matrix needs");
                } catch (const Error& error) {
                  const std::string text = error.what();
                  const char* what =
                      resource == RLIMIT_AS ? "the limit on address space leaves" : "the limit on data leaves";
                  return text.find(what) == std::string::npos ? 5 : 0;
                }
                return 4;
              }),
              0)
        << (resource == RLIMIT_AS ? "RLIMIT_AS" : "RLIMIT_DATA");
  }
}

}  // namespace
}  // namespace rollcon
