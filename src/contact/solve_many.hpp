#pragma once
/// Lists of load cases and what becomes of them (Contact::solve_many).

#include <cstdint>
#include <span>

#include "contact/contact.hpp"

namespace rollcon {

/// A number about a case, by the name that statistics have.
enum class CaseNumber {
  iterations,
  fallbacks,
  residual_normal,
  residual_tangential,
  nodes_contact,
  contact_area,
  max_pressure,
  friction_power,
  friction_power_balance,
};
/// err_option: unknown name, or a statistic that cases do not have.
CaseNumber case_number(const char* name, std::size_t length);

/// What replaces what the scene prescribes. A direction stands for the value prescribed there, as
/// force or motion; friction for a factor on every coefficient.
struct CaseList {
  std::span<const Parameter> parameter;  ///< different ones
  std::int64_t cases = 0;
  const double* value = nullptr;  ///< [cases][parameters]
};

/// In the axes. Null: not wanted. NaN where a case has no result.
struct CaseResults {
  std::int32_t* status = nullptr;  ///< [cases]
  double* force = nullptr;         ///< [cases][3]
  double* moment = nullptr;        ///< [cases][3]
  double* approach = nullptr;      ///< [cases]
  double* creep = nullptr;         ///< [cases][3]
  double* derivatives = nullptr;   ///< [cases][parameters][10]
  std::span<const CaseNumber> number;
  double* numbers = nullptr;    ///< [cases][number]
  std::int64_t capacity = 0;    ///< nodes
  double* tractions = nullptr;  ///< [cases][capacity][3]; beyond the frame: NaN
};

}  // namespace rollcon
