/// Tests hosts with threads of their own: contexts in parallel, bodies used by several threads, handles misused by two
/// at a time, OpenMP around the library, BLAS threads set by the host. Results are those of the same flows alone, bit
/// by bit.

#include <omp.h>

#include <atomic>
#include <cstdio>
#include <map>
#include <string>
#include <thread>

#include "flows.hpp"

// OpenBLAS has this function; other BLAS have none.
extern "C" {
__attribute__((weak)) void openblas_set_num_threads(int threads);
__attribute__((weak)) int openblas_get_num_threads(void);
}

namespace {

using namespace hosts;

std::vector<double> run(const Flow& flow, int threads) {
  Caller call;
  call.threads = threads;
  return flow.run(call);
}

/// Returns the results of all flows alone, in the order of flows().
std::vector<std::vector<double>> alone(int threads) {
  std::vector<std::vector<double>> results;
  for (const Flow& flow : flows()) results.push_back(run(flow, threads));
  return results;
}

/// Calls work(k), k = 0 .. count - 1, in a thread each; says what they threw.
template <class Work>
void in_threads(int count, Verdict& verdict, const Work& work) {
  std::vector<std::thread> pool;
  std::vector<std::string> thrown(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k)
    pool.emplace_back([&, k] {
      try {
        work(k);
      } catch (const std::exception& error) {
        thrown[static_cast<std::size_t>(k)] = error.what();
      }
    });
  for (std::thread& t : pool) t.join();
  for (const std::string& text : thrown) verdict.expect(text.empty(), "%s", text.c_str());
}

void contexts_in_parallel(Verdict& verdict) {
  const std::vector<Flow> all = flows();
  for (const int own_threads : {1, 2}) {
    const auto right = alone(own_threads);
    // Flows with one thread each have equal bits. With more, the first to solve chooses the BLAS threads of all.
    const double bound = own_threads == 1 ? 0 : 1e-9;
    std::atomic<int> equal{0}, different{0};
    in_threads(4, verdict, [&](int k) {
      for (std::size_t i = 0; i < 2 * all.size(); ++i) {
        const std::size_t f = (i + static_cast<std::size_t>(k)) % all.size();
        ++(difference(run(all[f], own_threads), right[f]) <= bound ? equal : different);
      }
    });
    std::printf("4 contexts at a time, %d threads each: %d flows as alone (to %.0e), %d not\n", own_threads,
                equal.load(), bound, different.load());
    verdict.expect(different == 0 && equal > 0, "contexts in parallel disturb each other");
  }
}

void openmp_around(Verdict& verdict) {
  const std::vector<Flow> all = flows();
  const auto right = alone(1);
  omp_set_max_active_levels(3);
  omp_set_num_threads(3);
  int equal = 0, different = 0, failed = 0;
  // The budget of 0 leaves the number to OpenMP: inside a region of the host that is one.
#pragma omp parallel for num_threads(3) reduction(+ : equal, different, failed) schedule(dynamic)
  for (std::size_t f = 0; f < all.size(); ++f) {
    try {
#pragma omp parallel num_threads(2)
      {
#pragma omp single
        ++(same_bits(run(all[f], 0), right[f]) ? equal : different);
      }
    } catch (const std::exception&) {
      ++failed;
    }
  }
  std::printf("inside OpenMP inside OpenMP: %d flows as alone, %d not, %d failed\n", equal, different, failed);
  verdict.expect(different == 0 && failed == 0 && equal > 0, "OpenMP around disturbs");
  verdict.expect(omp_get_max_active_levels() == 3 && omp_get_max_threads() == 3,
                 "the host's OpenMP settings are changed: levels %d (3), threads %d (3)", omp_get_max_active_levels(),
                 omp_get_max_threads());
}

void blas_of_the_host(Verdict& verdict) {
  if (!openblas_set_num_threads) return;
  const std::vector<Flow> all = flows();
  const int before = openblas_get_num_threads();
  const auto right = alone(1);
  for (const int hosts_threads : {1, 2, 3}) {
    openblas_set_num_threads(hosts_threads);
    for (std::size_t f = 0; f < all.size(); ++f) {
      verdict.expect(same_bits(run(all[f], 1), right[f]), "%s: with %d BLAS threads of the host results are others",
                     all[f].name, hosts_threads);
      verdict.expect(openblas_get_num_threads() == hosts_threads, "%s: the host's BLAS threads become %d (%d)",
                     all[f].name, openblas_get_num_threads(), hosts_threads);
    }
  }
  openblas_set_num_threads(before);
  std::printf("BLAS threads set by the host: settings kept, results as alone\n");
}

/// Makes the calls of a flow while another thread meddles with the contact.
class Busy final : public Caller {
 public:
  Busy() {
    made_contact = [this](rollcon_contact* c) { shared_ = c; };
    meddler_ = std::thread([this] { meddle(); });
  }
  ~Busy() override { end(); }
  void end() {
    ended_ = true;
    if (meddler_.joinable()) meddler_.join();
  }
  int refused = 0;
  std::map<std::int32_t, std::int64_t> answers;  ///< answers to the meddler, by status

 private:
  /// Busy handles are asked again.
  std::int32_t make(const char*, const std::function<std::int32_t()>& function) override {
    for (;;) {
      const std::int32_t status = function();
      if (status != ROLLCON_ERR_BUSY) return status;
      ++refused;
      std::this_thread::yield();
    }
  }

  /// Meddles by calls that leave no trace where they come through between two of the other thread's.
  void meddle() {
    std::vector<double> v(3000);
    while (!ended_) {
      rollcon_contact* c = shared_;
      if (!c) continue;
      std::int64_t n = 0;
      ++answers[rollcon_contact_get_size(c, &n, nullptr)];
      ++answers[rollcon_contact_set_real(c, "tolerance", -1)];
      ++answers[rollcon_contact_get_tractions(c, ROLLCON_LOCAL, 1000, v.data())];
      ++answers[rollcon_contact_get_resultant(c, ROLLCON_LOCAL, v.data(), nullptr)];
      ++answers[rollcon_contact_frame_add_elements(c, -1, 1, nullptr, 0, 0)];
    }
  }

  std::atomic<rollcon_contact*> shared_{nullptr};
  std::atomic<bool> ended_{false};
  std::thread meddler_;
};

void misuse_by_two(Verdict& verdict) {
  for (const Flow& flow : flows()) {
    const std::vector<double> right = run(flow, 1);
    int runs = 0, refused = 0;
    std::int64_t busy = 0, wrong = 0;
    // The meddler has to come in time.
    for (; runs < 200 && busy + refused < 20; ++runs) {
      Busy call;
      std::vector<double> results;
      try {
        results = flow.run(call);
      } catch (const std::exception& error) {
        verdict.expect(false, "%s: %s", flow.name, error.what());
      }
      call.end();
      verdict.expect(same_bits(results, right), "%s: misuse changed the results", flow.name);
      refused += call.refused;
      busy += call.answers[ROLLCON_ERR_BUSY];
      for (const auto& [status, count] : call.answers)
        if (status == ROLLCON_ERR_INTERNAL || status == ROLLCON_ERR_MEMORY) wrong += count;
    }
    std::printf("%s, %d times: the meddler was refused %lld times as busy, the flow %d times\n", flow.name, runs,
                static_cast<long long>(busy), refused);
    verdict.expect(wrong == 0, "%s: %lld calls of the meddler failed inside", flow.name, static_cast<long long>(wrong));
    verdict.expect(busy + refused > 0, "%s: the two never met", flow.name);
  }
}

}  // namespace

int main(int argc, char** argv) {
  Verdict verdict;
  const std::string what = argc > 1 ? argv[1] : "all";
  const std::pair<const char*, void (*)(Verdict&)> tests[] = {{"contexts", contexts_in_parallel},
                                                              {"openmp", openmp_around},
                                                              {"blas", blas_of_the_host},
                                                              {"misuse", misuse_by_two}};
  for (const auto& [name, test] : tests)
    if (what == "all" || what == name) test(verdict);
  return verdict.exit_code();
}
