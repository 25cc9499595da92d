/// Tests a host that has used the library, OpenMP and the BLAS with threads, and forks: the child gets the results of
/// its parent, twice removed as well.

#include <omp.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>

#include "flows.hpp"

namespace {

using namespace hosts;

std::vector<double> run(const Flow& flow, int threads) {
  Caller call;
  call.threads = threads;
  return flow.run(call);
}

/// Counts flows that end otherwise here. The alarm ends a child that hangs.
int other_results(const std::vector<std::vector<double>>& right, int threads) {
  alarm(60);
  int different = 0;
  std::size_t i = 0;
  for (const Flow& f : flows()) {
    try {
      different += !same_bits(run(f, threads), right[i]);
    } catch (const std::exception& error) {
      std::fprintf(stderr, "%s: %s\n", f.name, error.what());
      ++different;
    }
    ++i;
  }
  return different;
}

/// Returns the exit status of a child that runs this; -1: it was killed.
template <class Work>
int in_child(const Work& work) {
  std::fflush(stdout);
  const pid_t child = fork();
  if (child == 0) _exit(work());
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

int main() {
  Verdict verdict;
  folder();
  for (const int threads : {1, 2}) {
    std::vector<std::vector<double>> right;
    for (const Flow& f : flows()) right.push_back(run(f, threads));
    int regions = 0;
#pragma omp parallel num_threads(3) reduction(+ : regions)
    ++regions;
    const int child = in_child([&] { return other_results(right, threads); });
    const int grandchild = in_child([&] {
      return other_results(right, threads) != 0 ? 100 : in_child([&] { return other_results(right, threads); });
    });
    std::printf(
        "%d threads, after a region of %d OpenMP threads: %d flows with other results in a child, %d in its child\n",
        threads, regions, child, grandchild);
    verdict.expect(child == 0 && grandchild == 0, "children differ or hang");
    verdict.expect(other_results(right, threads) == 0, "the parent differs afterwards");
    alarm(0);
  }
  // The budget of 0 asks OpenMP how many.
  std::vector<std::vector<double>> right;
  for (const Flow& f : flows()) right.push_back(run(f, 0));
  const int child = in_child([&] { return other_results(right, 0); });
  verdict.expect(child == 0, "with OpenMP's number of threads: %d flows with other results", child);
  return verdict.exit_code();
}
