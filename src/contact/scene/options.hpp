#pragma once
/// Provides solver settings by name: one table gives type, range, default and meaning of each; `Options` holds a
/// contact's values.

#include <cstdint>
#include <span>
#include <string>

#include "support/setting_table.hpp"

namespace rollcon {

std::span<const Setting> option_table();     ///< all options of a contact
std::span<const Setting> procedure_table();  ///< those of set_procedure()

/// Holds what chooses a published solution procedure (contact/scene/procedure.hpp).
struct ProcedureChoices {
  std::string system = "condensed", jacobian = "exact", slip_estimate = "auto", line_search = "auto";
  bool operator==(const ProcedureChoices&) const = default;
};

struct Options {
  double tolerance = 1e-10;                   // "tolerance"
  std::int64_t max_iterations = 500;          // "max_iterations"
  double accuracy = 1e-6;                     // "accuracy" of the half-space integrals
  double stress_accuracy = 1e-5;              // "stress_accuracy" inside half-spaces
  double pressure_length = 0;                 // "pressure_length"
  double frame_accuracy = 0.005;              // "frame_accuracy"
  std::int64_t conformal = 0;                 // "conformal"
  std::string convection = "characteristic";  // "convection"
  std::string linear_solver = "auto";         // "linear_solver"
  std::int64_t warm_start = 2;                // "warm_start"
  std::string operators = "auto";             // "operators"
  double linear_tolerance = 0;                // "linear_tolerance"
  std::string preconditioner = "auto";        // "preconditioner"
  ProcedureChoices procedure;
  std::int64_t revision = 0;  ///< number of changes

  /// Chooses by words like system=monolithic; what is not named has its standard value. err_option.
  void set_procedure(const char* choices);
  /// Throw err_option for an unknown name, a wrong type, or a value out of range (the message names them).
  void set_int(const char* name, std::int64_t value);
  void set_real(const char* name, double value);
  void set_text(const char* name, const char* value);
  std::int64_t get_int(const char* name) const;
  double get_real(const char* name) const;
  const std::string& get_text(const char* name) const;
};

}  // namespace rollcon
