/// In place of the published solution procedures, in a build without them. Not reached:
/// choose_procedure() refuses what would ask for them.

#include "procedures/run.hpp"
#include "support/error.hpp"

namespace rollcon {
namespace {

[[noreturn]] void refuse() {
  fail(Status::err_unsupported,
       "this build of rollcon has no published solution procedures (component PROCEDURES: "
       "ROLLCON_WITH_PROCEDURES is OFF)");
}

}  // namespace

void estimate_scales(Problem& /*problem*/, double /*normal_factor*/, double /*tangential_factor*/) {
  refuse();
}

void run_published(SolverState& /*state*/, const Options& /*options*/, Monitor& /*monitor*/) {
  refuse();
}

}  // namespace rollcon
