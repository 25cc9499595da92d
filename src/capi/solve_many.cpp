/// Lists of load cases.

#include "contact/solve_many.hpp"

#include <cmath>
#include <vector>

#include "capi/guard.hpp"
#include "support/input_checks.hpp"
#include "support/memory_limit.hpp"

using namespace rollcon;
using namespace rollcon::capi;

namespace {

std::vector<Parameter> checked_parameters(int32_t n, const int32_t* parameters) {
  std::vector<Parameter> list;
  if (n < 0 || n > ROLLCON_FRICTION)
    fail(Status::err_argument, "n_parameters is %d; allowed: 0 to %d", n, ROLLCON_FRICTION);
  if (n > 0) require_pointer(parameters, "parameters");
  for (int32_t j = 0; j < n; ++j) {
    if (parameters[j] < ROLLCON_LONGITUDINAL || parameters[j] > ROLLCON_FRICTION)
      fail(Status::err_argument,
           "parameter %d (counting from 0) is %d; allowed: %d to %d (longitudinal, lateral, "
           "normal, spin, friction)",
           j, parameters[j], ROLLCON_LONGITUDINAL, ROLLCON_FRICTION);
    for (int32_t i = 0; i < j; ++i)
      if (parameters[i] == parameters[j])
        fail(Status::err_argument, "parameters %d and %d (counting from 0) are both %d", i, j,
             parameters[j]);
    list.push_back(static_cast<Parameter>(parameters[j]));
  }
  return list;
}

void check_values(const Contact& c, const CaseList& list) {
  const std::size_t n = list.parameter.size();
  if (n == 0) return;
  for (std::int64_t i = 0; i < list.cases; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      const double v = list.value[static_cast<std::size_t>(i) * n + j];
      const Parameter p = list.parameter[j];
      if (!std::isfinite(v))
        fail(Status::err_nonfinite, "value %d of case %lld (both counting from 0) is %g",
             static_cast<int>(j), static_cast<long long>(i), v);
      if (p == Parameter::normal && c.scene.load(Direction::normal).how == How::by_force && v < 0)
        fail(Status::err_argument,
             "the normal load of case %lld (counting from 0) is %g; allowed: 0 or more "
             "(compression)",
             static_cast<long long>(i), v);
      if (p == Parameter::friction && v < 0)
        fail(Status::err_argument,
             "the factor on friction of case %lld (counting from 0) is %g; allowed: 0 or more",
             static_cast<long long>(i), v);
    }
}

std::vector<CaseNumber> read_names(const char* text) {
  std::vector<CaseNumber> list;
  while (text && *text) {
    if (*text == ' ') {
      ++text;
      continue;
    }
    std::size_t length = 0;
    while (text[length] != '\0' && text[length] != ' ') ++length;
    list.push_back(case_number(text, length));
    text += length;
  }
  return list;
}

}  // namespace

rollcon_status rollcon_contact_solve_many(rollcon_contact* contact, int32_t n_parameters,
                                          const int32_t* parameters, int64_t n_cases,
                                          const double* values, const char* names, int64_t capacity,
                                          int32_t* status, double* force, double* moment,
                                          double* approach, double* creep, double* derivatives,
                                          double* statistics, double* tractions) {
  return with_contact(__func__, contact, [&](Contact& c) {
    const std::vector<Parameter> parameter = checked_parameters(n_parameters, parameters);
    require_count(n_cases, "n_cases");
    constexpr int64_t most_cases = int64_t{1} << 40;
    if (n_cases > most_cases)
      fail(Status::err_argument, "n_cases is %lld; allowed: 0 to %lld",
           static_cast<long long>(n_cases), static_cast<long long>(most_cases));
    // The order in which they are solved, and a status each; results are the caller's.
    constexpr double bytes_per_case = 32;
    const double bytes = bytes_per_case * static_cast<double>(n_cases);
    require_memory({bytes, bytes}, "solve it in parts", "a list of %lld cases takes",
                   static_cast<long long>(n_cases));
    if (n_cases > 0 && n_parameters > 0) require_pointer(values, "values");
    require_count(capacity, "capacity");
    const std::vector<CaseNumber> number = read_names(names);
    if (!number.empty()) require_pointer(statistics, "statistics");
    const CaseList list{parameter, n_cases, values};
    check_values(c, list);
    CaseResults results;
    results.status = status;
    results.force = force;
    results.moment = moment;
    results.approach = approach;
    results.creep = creep;
    results.derivatives = derivatives;
    results.number = number;
    results.numbers = number.empty() ? nullptr : statistics;
    results.capacity = capacity;
    results.tractions = tractions;
    return c.solve_many(list, results);
  });
}
