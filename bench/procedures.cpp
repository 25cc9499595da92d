#include "procedures.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <stdexcept>

namespace rollcon::bench {

namespace {

constexpr double short_solve = 0.3;  ///< seconds; longer ones are not repeated

void must(std::int32_t status, const char* what) {
  if (status < 0) throw std::runtime_error(what);
}

void add_error_function(Record& record, const scenes::RollingPair& pair) {
  std::int64_t rows = 0;
  must(rollcon_contact_get_error_function(pair.handle(), 0, nullptr, nullptr, &rows),
       "get_error_function");
  std::vector<double> psi(static_cast<std::size_t>(rows)), seconds(psi.size());
  must(rollcon_contact_get_error_function(pair.handle(), rows, psi.data(), seconds.data(), &rows),
       "get_error_function");
  record.series = {{"psi", std::move(psi)}, {"psi_seconds", std::move(seconds)}};
}

}  // namespace

std::string Procedure::name() const {
  return system + " " + jacobian + " " + slip_estimate + " " + linear_solver + " " + preconditioner;
}

void Procedure::apply(scenes::RollingPair& pair) const {
  pair.option("system", system.c_str()).option("jacobian", jacobian.c_str());
  pair.option("slip_estimate", slip_estimate.c_str());
  pair.option("linear_solver", linear_solver.c_str());
  pair.option("preconditioner", preconditioner.c_str());
  pair.option("max_iterations", max_iterations);
}

std::vector<Procedure> procedures_of(const std::string& system) {
  std::vector<Procedure> all;
  for (const char* jacobian : {"exact", "b_derivative", "simplified"})
    for (const char* solver : linear_solvers) all.push_back({system, jacobian, "auto", solver});
  for (const char* estimate : slip_estimates)
    for (const char* solver : linear_solvers) all.push_back({system, "reduced", estimate, solver});
  return all;
}

void add_body_unknowns(Record& record, const scenes::RollingPair& pair) {
  double unknowns = 0;
  for (const int which : {1, 2}) {
    std::int32_t kind = 0;
    must(rollcon_body_get_kind(pair.body(which), &kind), "get_kind");
    if (kind == ROLLCON_BODY_BEM || kind == ROLLCON_BODY_FEM)
      unknowns += pair.body_stat(which, "unknowns");
  }
  record.extra.emplace_back("body_unknowns", unknowns);
}

scenes::Solution solve_by(const Procedure& procedure, scenes::RollingPair& pair, Record& record,
                          int repeats) {
  const Record blank = record;
  scenes::Solution solution;
  for (int k = 0; k < repeats; ++k) {
    Record attempt = blank;
    attempt.method = procedure.name();
    procedure.apply(pair);
    pair.reset();
    try {
      solution = timed_solve(pair, attempt, now());
      attempt.extra.emplace_back("solving_seconds", solving_seconds(pair));
      attempt.extra.emplace_back("factorizations", pair.stat("factorizations"));
      add_body_unknowns(attempt, pair);
      add_error_function(attempt, pair);
    } catch (const std::exception& e) {
      attempt.status = -1;
      std::fprintf(stderr, "%s, %s, %s: %s\n", attempt.case_name.c_str(), attempt.model.c_str(),
                   attempt.method.c_str(), e.what());
    }
    if (k == 0 || attempt.seconds < record.seconds) record = attempt;
    if (attempt.seconds > short_solve || attempt.status < 0) break;
  }
  return solution;
}

double solving_seconds(const scenes::RollingPair& pair) {
  return pair.stat("seconds_total") - pair.stat("seconds_compliance") -
         pair.stat("seconds_convection");
}

double traction_difference(const scenes::Solution& a, const scenes::Solution& b) {
  if (a.nodes() != b.nodes() || a.nodes() == 0) return std::numeric_limits<double>::quiet_NaN();
  double scale[2] = {}, difference[2] = {};
  for (std::size_t k = 0; k < a.nodes(); ++k) {
    const auto &s = a.traction[k], &t = b.traction[k];
    scale[0] = std::max(scale[0], std::abs(t[2]));
    scale[1] = std::max(scale[1], std::hypot(t[0], t[1]));
    difference[0] = std::max(difference[0], std::abs(s[2] - t[2]));
    difference[1] = std::max(difference[1], std::hypot(s[0] - t[0], s[1] - t[1]));
  }
  return std::max(difference[0] / scale[0], scale[1] > 0 ? difference[1] / scale[1] : 0);
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
