/// Tests threads with stacks of 256 kB, and a whole process under such a limit: flows end normally. Says how deep they
/// went.
///
/// Usage: stack [limited].

#include <pthread.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>

#include "flows.hpp"

namespace {

using namespace hosts;

constexpr std::size_t limit = std::size_t{256} << 10U;
constexpr unsigned char paint = 0xa5;

struct Task {
  const Flow* flow;
  int threads;
  std::vector<double> results;
  std::string thrown;
};

void* run(void* task) {
  Task& t = *static_cast<Task*>(task);
  try {
    Caller call;
    call.threads = t.threads;
    t.results = t.flow->run(call);
  } catch (const std::exception& error) {
    t.thrown = error.what();
  }
  return nullptr;
}

/// Returns the bytes of a stack of 256 kB that the flow touches in a thread of its own.
std::size_t run_on_small_stack(Task& task) {
  void* memory = mmap(nullptr, limit, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_STACK, -1, 0);
  std::memset(memory, paint, limit);
  pthread_attr_t attributes;
  pthread_t thread;
  pthread_attr_init(&attributes);
  pthread_attr_setstack(&attributes, memory, limit);
  if (pthread_create(&thread, &attributes, run, &task) == 0) pthread_join(thread, nullptr);
  pthread_attr_destroy(&attributes);
  const auto* bottom = static_cast<const unsigned char*>(memory);
  std::size_t untouched = 0;
  while (untouched < limit && bottom[untouched] == paint) ++untouched;
  munmap(memory, limit);
  return limit - untouched;
}

}  // namespace

int main(int argc, char** argv) {
  Verdict verdict;
  if (argc == 1) {
    for (const int threads : {1, 2}) {
      for (const Flow& flow : flows()) {
        // The BLAS works in one thread without the stack for more.
        const double bound = threads == 1 ? 0 : 1e-9;
        Task here{&flow, threads, {}, {}}, there{&flow, threads, {}, {}};
        run(&here);
        const std::size_t used = run_on_small_stack(there);
        std::printf("%s, %d threads: %zu of %zu bytes of stack\n", flow.name, threads, used, limit);
        verdict.expect(here.thrown.empty() && there.thrown.empty() && difference(there.results, here.results) <= bound,
                       "%s: other results on a small stack: %s", flow.name, there.thrown.c_str());
        verdict.expect(used < limit, "%s: the stack is used up", flow.name);
      }
    }
    // The program runs once more under the limit: its main thread, and those that inherit it.
    const rlimit small{limit, limit};
    std::fflush(stdout);
    if (setrlimit(RLIMIT_STACK, &small) == 0) execl(argv[0], argv[0], "limited", nullptr);
    verdict.expect(false, "the program cannot be started again");
  }
  rlimit now{};
  getrlimit(RLIMIT_STACK, &now);
  for (const int threads : {1, 2})
    for (const Flow& flow : flows()) {
      Task task{&flow, threads, {}, {}};
      run(&task);
      verdict.expect(task.thrown.empty() && !task.results.empty(), "%s under the limit: %s", flow.name,
                     task.thrown.c_str());
    }
  std::printf("a process with stacks of %zu bytes runs all flows\n", static_cast<std::size_t>(now.rlim_cur));
  return verdict.exit_code();
}
