/// Makes every allocation of a whole flow fail in turn, whoever makes it: once alone, and once with all that follow.
/// The call ends with a status and a text, repeated it succeeds, the flow ends with its results, and no block is lost.
///
/// Usage: allocation_failures FLOW THREADS [FIRST LAST]. Every one of the first hundred fails, then some in growing
/// strides; with ROLLCON_EVERY_ALLOCATION=1 in the environment all of them.
///
/// The test spares the allocations of FFTW's planner, METIS and libgomp (CHOLMOD's loops), which end the process, print
/// or lose memory by themselves; docs/api.md says so. Blocks that CHOLMOD loses inside UMFPACK's analysis are counted
/// apart.

#include <array>
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "flows.hpp"
#include "injected_failures.hpp"

namespace {

using namespace hosts;

class Failing final : public Caller {
 public:
  Failing(std::int64_t successes, bool lasting) : successes_(successes), lasting_(lasting) {}
  bool failed() const { return failed_; }
  bool survived() const { return failed_ && !repeated_; }
  std::string where;    ///< call in which the allocation failed
  std::string library;  ///< library whose allocation it was
  std::string wrong;    ///< what the call did wrong

 private:
  std::int32_t make(const char* name, const std::function<std::int32_t()>& function) override {
    if (failed_) return function();
    fail_after(successes_, lasting_);
    const std::int32_t status = function();
    failed_ = has_failed();
    successes_ = successes_left();
    const char* of = failed_in();
    fail_after(-1, false);
    library = of;
    if (!failed_) return status;
    where = name;
    if (status >= 0) return status;
    // A file that cannot be opened for want of memory is one that cannot be written.
    const bool of_file = where == "rollcon_contact_write" && status == ROLLCON_ERR_IO;
    if (status != ROLLCON_ERR_MEMORY && !of_file) wrong = "status " + std::to_string(status);
    // The call of a list of cases reports its own failures, but not those of cases.
    if (where != "rollcon_contact_solve_many" &&
        !std::string(rollcon_last_error()).starts_with(std::string(name) + ": "))
      wrong = std::string("text '") + rollcon_last_error() + "'";
    repeated_ = true;
    return function();
  }

  std::int64_t successes_;
  bool lasting_, failed_ = false, repeated_ = false;
};

/// Makes the failures of one flow, alone or lasting.
class Run {
 public:
  Run(const Flow& flow, bool lasting, int threads, Verdict& verdict)
      : flow_(flow), lasting_(lasting), verdict_(verdict) {
    plain_.threads = threads;
    right_ = flow.run(plain_);
    const std::int64_t before = allocations();
    flow.run(plain_);
    total_ = allocations() - before;
    kept_ = live_blocks();
  }

  void all(std::int64_t first, std::int64_t last, bool every) {
    for (std::int64_t k = first; k <= last; k += every || k < 100 ? 1 : 1 + k / 30)
      if (!without_loss(k)) break;
    std::printf("%s, %d threads, %s: %" PRId64 " failed of about %" PRId64 " allocations, %" PRId64
                " survived, bound of results 1e-9, blocks lost by CHOLMOD %" PRId64 "\n",
                flow_.name, plain_.threads, lasting_ ? "all later ones too" : "one at a time", injected_, total_,
                survived_, lost_by_cholmod_);
    std::fflush(stdout);
    verdict_.expect(injected_ > 20, "%s: the failures did not come", flow_.name);
  }

 private:
  /// Checks that no block is lost: tables of the libraries below may grow once; what grows again is lost.
  bool without_loss(std::int64_t k) {
    for (int repeat = 0;; ++repeat) {
      const bool failed = once(k);
      const std::int64_t lost = live_blocks() - kept_;
      kept_ = live_blocks();
      if (lost <= 0) return failed;
      if (repeat < 2) continue;
      if (library_.find("libcholmod") != std::string::npos) {
        lost_by_cholmod_ += lost;
        return failed;
      }
      verdict_.expect(false, "%s, allocation %" PRId64 " of %s: %" PRId64 " blocks are lost", flow_.name, k,
                      library_.c_str(), lost);
      return failed;
    }
  }

  /// Returns false once the flow has fewer allocations.
  bool once(std::int64_t successes) {
    Failing call(successes, lasting_);
    call.threads = plain_.threads;
    std::string wrong;
    try {
      // Survived failures may have left the usual order of unknowns or number of threads.
      const double apart = difference(flow_.run(call), right_);
      if (!(apart <= 1e-9)) wrong = "results are apart by " + std::to_string(apart);
    } catch (const std::exception& error) {
      fail_after(-1, false);
      wrong = error.what();
    }
    if (wrong.empty()) wrong = call.wrong;
    verdict_.expect(wrong.empty(), "%s, %s %" PRId64 ", %s, %s: %s", flow_.name,
                    lasting_ ? "allocations from" : "allocation", successes, call.where.c_str(), call.library.c_str(),
                    wrong.c_str());
    injected_ += call.failed();
    survived_ += call.survived();
    library_ = call.library;
    return call.failed();
  }

  const Flow& flow_;
  bool lasting_;
  Verdict& verdict_;
  Caller plain_;
  std::vector<double> right_;
  std::string library_;
  std::int64_t total_ = 0, kept_ = 0, injected_ = 0, survived_ = 0, lost_by_cholmod_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  Verdict verdict;
  const Flow wanted = flow(argc > 1 ? argv[1] : "dense");
  const int threads = argc > 2 ? std::atoi(argv[2]) : 1;
  const std::int64_t first = argc > 3 ? std::atoll(argv[3]) : 0;
  const std::int64_t last = argc > 4 ? std::atoll(argv[4]) : INT64_MAX;
  const bool every = std::getenv("ROLLCON_EVERY_ALLOCATION") != nullptr;
  for (const char* library : {"libfftw3", "libmetis", "libgomp"}) spare(library);
  folder();
  for (const bool lasting : {false, true}) Run(wanted, lasting, threads, verdict).all(first, last, every);
  return verdict.exit_code();
}
