#include "procedures.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <stdexcept>

namespace rollcon::bench {

namespace {

constexpr double short_solve = 0.3;  ///< seconds; longer solves are not repeated

void must(std::int32_t status, const char* what) {
  if (status < 0) throw std::runtime_error(what);
}

void add_error_function(Record& record, const scenes::RollingPair& pair) {
  std::int64_t rows = 0;
  must(rollcon_contact_get_history(pair.handle(), "error_function", 0, nullptr, &rows), "get_history");
  std::vector<double> psi(static_cast<std::size_t>(rows)), seconds(psi.size());
  must(rollcon_contact_get_history(pair.handle(), "error_function", rows, psi.data(), nullptr), "get_history");
  must(rollcon_contact_get_history(pair.handle(), "seconds", rows, seconds.data(), nullptr), "get_history");
  record.series = {{"psi", std::move(psi)}, {"psi_seconds", std::move(seconds)}};
}

}  // namespace

void apply(const Procedure& procedure, scenes::RollingPair& pair) {
  procedure.apply(pair);
  pair.option("max_iterations", procedure.max_iterations ? procedure.max_iterations : most_iterations);
}

void add_body_unknowns(Record& record, const scenes::RollingPair& pair) {
  double unknowns = 0;
  for (const int which : {1, 2}) {
    std::int32_t kind = 0;
    must(rollcon_body_get_kind(pair.body(which), &kind), "get_kind");
    if (kind == ROLLCON_BODY_BEM || kind == ROLLCON_BODY_FEM) unknowns += pair.body_stat(which, "unknowns");
  }
  record.extra.emplace_back("body_unknowns", unknowns);
}

scenes::Solution solve_by(const Procedure& procedure, scenes::RollingPair& pair, Record& record, int repeats) {
  const Record blank = record;
  scenes::Solution solution;
  for (int k = 0; k < repeats; ++k) {
    Record attempt = blank;
    attempt.method = procedure.name();
    apply(procedure, pair);
    pair.reset();
    try {
      solution = timed_solve(pair, attempt, now());
      attempt.extra.emplace_back("solving_seconds", solving_seconds(pair));
      attempt.extra.emplace_back("factorizations", pair.stat("factorizations"));
      add_body_unknowns(attempt, pair);
      add_error_function(attempt, pair);
    } catch (const std::exception& e) {
      attempt.status = -1;
      std::fprintf(stderr, "%s, %s, %s: %s\n", attempt.case_name.c_str(), attempt.model.c_str(), attempt.method.c_str(),
                   e.what());
    }
    if (k == 0 || attempt.seconds < record.seconds) record = attempt;
    if (attempt.seconds > short_solve || attempt.status < 0) break;
  }
  return solution;
}

double solving_seconds(const scenes::RollingPair& pair) {
  return pair.stat("seconds_total") - pair.stat("seconds_compliance") - pair.stat("seconds_convection");
}

bool converged(const Record& record) {
  return record.status == ROLLCON_OK || record.status == ROLLCON_RIM_CONTACT;
}

std::vector<Case> procedure_cases() {
  std::vector<Case> cases;
  for (auto family : {procedure_example3_cases, procedure_example4_cases, procedure_examples_cases,
                      procedure_random_cases, preconditioner_cases})
    for (Case& c : family()) cases.push_back(std::move(c));
  return cases;
}

}  // namespace rollcon::bench
