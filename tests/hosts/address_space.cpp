/// Tests hosts with a limit of address space (ulimit -v): a flow ends normally, or with a status and a text, and never
/// hangs. OpenBLAS would, without room for its buffers.

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>

#include "flows.hpp"

namespace {

using namespace hosts;

constexpr int fine = 0, refused = 1, wrong = 2;

/// Runs in a process that may have so much more than it has.
int run_within(const Flow& flow, rlim_t bytes) {
  rlim_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  const rlim_t most = pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + bytes;
  const rlimit limit{most, most};
  if (setrlimit(RLIMIT_AS, &limit) != 0) return wrong;
  alarm(30);
  try {
    Caller call;
    flow.run(call);
    return fine;
  } catch (const Unexpected& error) {
    return std::string(error.what()).find("memory") != std::string::npos ? refused : wrong;
  }
}

}  // namespace

int main() {
  Verdict verdict;
  folder();
  for (const Flow& flow : flows()) {
    int count[3] = {};
    for (const rlim_t megabytes : {1, 4, 16, 64, 125, 160, 400}) {
      std::fflush(stdout);
      const pid_t child = fork();
      if (child == 0) _exit(run_within(flow, megabytes << 20U));
      int status = 0;
      waitpid(child, &status, 0);
      const int result = WIFEXITED(status) ? WEXITSTATUS(status) : wrong;
      ++count[result > wrong ? wrong : result];
      verdict.expect(result == fine || result == refused, "%s with %d MiB: neither results nor a status (%#x)",
                     flow.name, static_cast<int>(megabytes), static_cast<unsigned>(status));
    }
    std::printf("%s under 7 limits: %d fine, %d refused\n", flow.name, count[fine], count[refused]);
    verdict.expect(count[fine] > 0 && count[refused] > 0, "%s: the limits do not limit", flow.name);
  }
  return verdict.exit_code();
}
