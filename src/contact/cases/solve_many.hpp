#pragma once
/// Holds lists of load cases and what becomes of them (Contact::solve_many).

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>

#include "contact/host.hpp"
#include "contact/scene/enumerators.hpp"
#include "support/error.hpp"

namespace rollcon {

class CaseSolver;  // contact/cases/case_solver.hpp
class Solver;

/// Names neighbouring numbers in the row of a case, in the axes.
struct CaseColumn {
  enum class Kind { force, moment, approach, creep, tilt, derivatives, tractions, number };
  Kind kind = Kind::force;
  double (*number)(Solver&) = nullptr;  ///< statistic, of kind number
  std::int64_t width = 0;
};
/// Finds a column. err_option: unknown name. parameters: count of the list's; nodes: count of the frame's.
CaseColumn case_column(const char* name, std::size_t length, std::int64_t parameters, std::int64_t nodes);

/// Replaces what the scene prescribes. A direction stands for the value prescribed there, as force or motion; friction
/// for a factor on every coefficient.
struct CaseList {
  std::span<const Parameter> parameter;  ///< parameters that differ from one another
  std::int64_t cases = 0;
  const double* value = nullptr;  ///< [cases][parameters]
};

/// Takes the results; NaN where a case has none.
struct CaseResults {
  std::int32_t* status = nullptr;  ///< [cases]; null: not wanted
  double* row = nullptr;           ///< [cases][stride]
  std::int64_t stride = 0;         ///< at least the widths of the columns
  std::span<const CaseColumn> column;
};

/// Solves the cases over so many threads, each with a solver that make() gives. Returns the status of
/// Contact::solve_many. bytes: what all solvers held.
Status solve_cases(const std::function<std::unique_ptr<CaseSolver>()>& make, int threads, const CaseList& cases,
                   const CaseResults& results, const Host& host, std::size_t& bytes);
/// Fills the results of a list whose preparation was cancelled.
void cancel_cases(const CaseList& cases, const CaseResults& results, const Host& host);

}  // namespace rollcon
