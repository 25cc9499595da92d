#pragma once
/// Solves lists of load cases of the scene of Api.

#include <numeric>
#include <random>

#include "fixture.hpp"

namespace capi_test {

/// Holds everything that one call can give.
struct Table {
  std::vector<std::int32_t> status;
  std::vector<double> force, moment, approach, creep, derivatives, statistics, tractions;

  Table(std::size_t cases, std::size_t parameters, std::size_t names, std::size_t nodes)
      : status(cases, -1000),
        force(3 * cases),
        moment(3 * cases),
        approach(cases),
        creep(3 * cases),
        derivatives(10 * parameters * cases),
        statistics(names * cases),
        tractions(3 * nodes * cases) {}

  std::vector<const std::vector<double>*> arrays() const {
    return {&force, &moment, &approach, &creep, &derivatives, &statistics, &tractions};
  }
};

/// Compares bit by bit, NaN included.
inline bool same(const double* a, const double* b, std::size_t n) {
  for (std::size_t i = 0; i < n; ++i)
    if (!(a[i] == b[i] || (std::isnan(a[i]) && std::isnan(b[i])))) return false;
  return true;
}

/// Counts the cases whose results differ from those of the cases `at` of another table.
inline int differences(const Table& a, const Table& b, const std::vector<std::size_t>& at) {
  int count = 0;
  const std::size_t n = a.status.size();
  for (std::size_t i = 0; i < n; ++i) {
    bool equal = a.status[i] == b.status[at[i]];
    const auto left = a.arrays(), right = b.arrays();
    for (std::size_t k = 0; k < left.size(); ++k) {
      const std::size_t width = left[k]->size() / n;
      equal = equal && same(left[k]->data() + width * i, right[k]->data() + width * at[i], width);
    }
    count += !equal;
  }
  return count;
}

inline std::vector<std::size_t> in_order(std::size_t n) {
  std::vector<std::size_t> at(n);
  std::iota(at.begin(), at.end(), std::size_t{0});
  return at;
}

inline constexpr const char* names =
    "iterations friction_power max_pressure contact_area nodes_contact friction_power_balance";
inline constexpr std::size_t name_count = 6;

class CaseLists : public Api {
 protected:
  void SetUp() override {
    Api::SetUp();
    set_scene();
    ASSERT_OK(rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, load));
  }

  Table table(const std::vector<std::int32_t>& parameters, const std::vector<double>& values, std::int32_t threads,
              std::int32_t expected = ROLLCON_OK) {
    const std::size_t cases = values.size() / parameters.size();
    Table t(cases, parameters.size(), name_count, nodes());
    EXPECT_OK(rollcon_context_set_threads(context, threads));
    const std::size_t width = 10 + 10 * parameters.size() + name_count + 3 * nodes();
    std::vector<double> rows(width * cases);
    std::int64_t told = 0;
    std::string columns = "force moment approach creep derivatives ";
    columns += names;
    columns += " tractions";
    EXPECT_EQ(rollcon_contact_solve_many(contact, names_of(parameters).c_str(), static_cast<std::int64_t>(cases),
                                         values.data(), columns.c_str(), static_cast<std::int64_t>(width), rows.data(),
                                         &told, t.status.data()),
              expected)
        << error();
    EXPECT_EQ(told, static_cast<std::int64_t>(width));
    for (std::size_t i = 0; i < cases; ++i) {
      const double* from = &rows[width * i];
      for (std::vector<double>* array :
           {&t.force, &t.moment, &t.approach, &t.creep, &t.derivatives, &t.statistics, &t.tractions}) {
        const std::size_t n = array->size() / cases;
        std::copy_n(from, n, array->data() + n * i);
        from += n;
      }
    }
    return t;
  }

  static std::string names_of(const std::vector<std::int32_t>& parameters) {
    static constexpr const char* known[] = {"longitudinal", "lateral", "normal", "spin", "friction"};
    std::string text;
    for (const std::int32_t p : parameters) text += std::string(" ") + known[p - 1];
    return text;
  }

  /// Asks for forces alone, on one thread.
  std::int32_t forces(const std::vector<std::int32_t>& parameters, std::int64_t cases,
                      const std::vector<double>& values, std::vector<double>& force) {
    force.assign(static_cast<std::size_t>(3 * cases), -1);
    return rollcon_contact_solve_many(contact, names_of(parameters).c_str(), cases, values.data(), "force", 3,
                                      force.data(), nullptr, nullptr);
  }

  std::size_t nodes() const { return static_cast<std::size_t>(frame.nodes); }

  static constexpr double load = 298.6;
  const std::vector<std::int32_t> three{ROLLCON_LATERAL, ROLLCON_NORMAL, ROLLCON_SPIN};
  /// Returns a grid of 4 loads, 5 lateral creepages, 3 spins.
  std::vector<double> grid() const {
    std::vector<double> values;
    for (const double f : {0.7, 0.9, 1.1, 1.3})
      for (const double eta : {-2e-3, -1e-3, 0.0, 1e-3, 2e-3})
        for (const double phi : {-5e-4, 0.0, 1e-3}) values.insert(values.end(), {eta, f * load, phi});
    return values;
  }
  /// Returns values that occur once each.
  std::vector<double> scattered(std::size_t cases) const {
    std::mt19937 generator(7);
    std::uniform_real_distribution<double> unit(-1, 1);
    std::vector<double> values;
    for (std::size_t i = 0; i < cases; ++i)
      values.insert(values.end(), {2e-3 * unit(generator), (1 + 0.3 * unit(generator)) * load, 1e-3 * unit(generator)});
    return values;
  }
};

}  // namespace capi_test
