/// Implements the call that solves lists of load cases.

#include "contact/cases/solve_many.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "capi/columns.hpp"
#include "capi/guard.hpp"
#include "capi/results.hpp"
#include "support/input_checks.hpp"
#include "support/memory_limit.hpp"

using namespace rollcon;
using namespace rollcon::capi;

namespace {

std::vector<Parameter> read_parameters(const char* names) {
  static constexpr const char* known[] = {"longitudinal", "lateral", "normal", "spin", "friction", "tilt_1", "tilt_2"};
  std::vector<Parameter> list;
  if (!names) return list;
  for (const std::size_t p : read_names(names, "parameters", known, Status::err_argument)) {
    const auto parameter = static_cast<Parameter>(p + 1);
    if (std::find(list.begin(), list.end(), parameter) != list.end())
      fail(Status::err_argument, "parameters has '%s' twice", known[p]);
    list.push_back(parameter);
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
        fail(Status::err_nonfinite, "value %d of case %lld (both counting from 0) is %g", static_cast<int>(j),
             static_cast<long long>(i), v);
      if (p == Parameter::normal && c.scene.load(Direction::normal).how == How::by_force && v < 0)
        fail(Status::err_argument,
             "the normal load of case %lld (counting from 0) is %g; allowed: 0 or more "
             "(compression)",
             static_cast<long long>(i), v);
      if (p == Parameter::friction && v < 0)
        fail(Status::err_argument, "the factor on friction of case %lld (counting from 0) is %g; allowed: 0 or more",
             static_cast<long long>(i), v);
    }
}

}  // namespace

rollcon_status rollcon_contact_solve_many(rollcon_contact* contact, const char* parameters, int64_t n_cases,
                                          const double* values, const char* columns, int64_t capacity, double* results,
                                          int64_t* n_results, int32_t* status) {
  return with_contact(
      __func__, contact, together([&](Contact& c) {
        const std::vector<Parameter> parameter = read_parameters(parameters);
        require_count(n_cases, "n_cases");
        constexpr int64_t most_cases = int64_t{1} << 40;
        if (n_cases > most_cases)
          fail(Status::err_argument, "n_cases is %lld; allowed: 0 to %lld", static_cast<long long>(n_cases),
               static_cast<long long>(most_cases));
        std::vector<CaseColumn> column;
        int64_t width = 0;
        each_word(columns, [&](const char* word, std::size_t length) {
          column.push_back(case_column(word, length, static_cast<int64_t>(parameter.size()), c.nodes()));
          width += column.back().width;
        });
        if (width == 0) {
          require_count(capacity, "capacity");
          if (n_results) *n_results = 0;
        } else {
          const void* room =
              n_cases > 0 ? static_cast<const void*>(results) : &width;  // a list without cases needs none
          if (!wants_copy(width, capacity, room, "results", n_results, "numbers per case")) return Status::ok;
        }
        if (n_cases > 0 && capacity > PTRDIFF_MAX / n_cases / int64_t{sizeof(double)})
          fail(Status::err_argument, "n_cases = %lld with capacity %lld is beyond the address space",
               static_cast<long long>(n_cases), static_cast<long long>(capacity));
        // Each case needs a place in the order of solving and a status; the results are the caller's memory.
        constexpr double bytes_per_case = 32;
        const double bytes = bytes_per_case * static_cast<double>(n_cases);
        require_memory({bytes, bytes}, "solve it in parts", "a list of %lld cases takes",
                       static_cast<long long>(n_cases));
        if (n_cases > 0 && !parameter.empty()) require_pointer(values, "values");
        const CaseList list{parameter, n_cases, values};
        check_values(c, list);
        return c.solve_many(list, {.status = status, .row = results, .stride = capacity, .column = column});
      }));
}
