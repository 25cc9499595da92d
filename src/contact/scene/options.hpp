#pragma once
/// Solver settings by name: one table gives type, range, default and meaning of each; `Options` holds a contact's
/// values.

#include <cstdint>
#include <span>
#include <string>

#include "support/setting_table.hpp"

namespace rollcon {

std::span<const Setting> option_table();

struct Options {
  double tolerance = 1e-10;                   // "tolerance"
  std::int64_t max_iterations = 500;          // "max_iterations"
  double accuracy = 1e-6;                     // "accuracy": of the half-space integrals
  std::string convection = "characteristic";  // "convection"
  std::string linear_solver = "auto";         // "linear_solver"
  double characteristic_step = 0.6;           // "characteristic_step"
  double normal_scale = 1;                    // "normal_scale": multiplies r_n
  double tangential_scale = 1;                // "tangential_scale": multiplies r_t
  std::int64_t warm_start = 1;                // "warm_start"
  std::int64_t prediction = 1;                // "prediction"
  std::string operators = "auto";             // "operators"
  std::int64_t reach = 1;                     // "reach"
  std::int64_t total_sliding = 1;             // "total_sliding"
  // Which of the published solution procedures (contact/scene/procedure.hpp).
  std::string system = "condensed";     // "system"
  std::string jacobian = "exact";       // "jacobian"
  std::string slip_estimate = "auto";   // "slip_estimate"
  double slip_time_step = 1;            // "slip_time_step"
  double slip_extrapolation = 1.2;      // "slip_extrapolation"
  double linear_tolerance = 0;          // "linear_tolerance"
  double linear_tolerance_max = 0.01;   // "linear_tolerance_max"
  double linear_tolerance_gamma = 0.3;  // "linear_tolerance_gamma"
  std::string preconditioner = "auto";  // "preconditioner"
  std::string line_search = "auto";     // "line_search"
  double line_search_factor = 0.5;      // "line_search_factor"
  double line_search_slope = 1e-4;      // "line_search_slope"
  std::int64_t revision = 0;            ///< counts changes

  /// err_option: unknown name, wrong type, out of range (the message names them).
  void set_int(const char* name, std::int64_t value);
  void set_real(const char* name, double value);
  void set_text(const char* name, const char* value);
  std::int64_t get_int(const char* name) const;
  double get_real(const char* name) const;
  const std::string& get_text(const char* name) const;
};

}  // namespace rollcon
