#include "contact/scene/options.hpp"

#include <sstream>
#include <utility>

#include "contact/convection/convection.hpp"

namespace rollcon {

namespace {

const SettingTable<Options>& table() {
  static const SettingTable<Options> rows{
      {"tolerance", &Options::tolerance, 1e-14, 1e-2,
       "Relative residual of the contact laws at which the iteration stops."},
      {"max_iterations", &Options::max_iterations, 1, 100000,
       "Most Newton iterations of one solve, those of its fallbacks included."},
      {"accuracy", &Options::accuracy, 1e-12, 1e-2, "Relative accuracy of the half-space integrals."},
      {"stress_accuracy", &Options::stress_accuracy, 1e-9, 1e-2,
       "Error that stresses inside half-spaces may have, relative to the largest traction."},
      {"frame_accuracy", &Options::frame_accuracy, 1e-4, 1,
       "Error that frames made by the library may leave in force and spin moment, relative to the force."},
      {"pressure_length", &Options::pressure_length, 0, 1e8,
       "Length along t2 over which the statistic max_pressure takes means; 0: none. At the sharp end of a half-space "
       "or rigid body pressures have no bound, and means have."},
      {"conformal", &Options::conformal, -1, 1,
       "1: frames on half-spaces with profiles follow these across the rolling direction, with normals that turn; -1: "
       "they lie in the plane of the axes; 0: they do, too, unless the library makes them for inclined patches."},
      {"convection", &Options::convection, scheme_names().c_str(), "Scheme of the convective derivative in the slip."},
      {"linear_solver", &Options::linear_solver, "auto|lu|gmres|gmres_adaptive",
       "Solver of the linear systems; auto chooses by size. gmres_adaptive: tolerance by "
       "(72)-(74)."},
      {"warm_start", &Options::warm_start, 0, 2,
       "2: a solve starts from the last solution, moved on along the line of the last change where that helps; 1: from "
       "the last solution; 0: from nothing."},
      {"operators", &Options::operators, "auto|dense|table|fft|hierarchical",
       "Matrices of integrals; on regular frames above half-spaces from a table, or convolutions; on irregular ones "
       "integrals nearby and series far away."},
      {"linear_tolerance", &Options::linear_tolerance, 0, 0.9,
       "Relative residual at which gmres stops, and the largest of gmres_adaptive, eta_max of (73); 0: chosen by the "
       "iteration, 0.01."},
      {"preconditioner", &Options::preconditioner, "auto|none|diagonal|bodies|kept_lu",
       "Of gmres. bodies: their matrices, factorised once (system = monolithic). kept_lu: the "
       "factors of an earlier iteration (system = condensed)."},
  };
  return rows;
}

const SettingTable<ProcedureChoices>& procedures() {
  static const SettingTable<ProcedureChoices> rows{
      {"system", &ProcedureChoices::system, "condensed|monolithic",
       "The bodies' own unknowns eliminated, or written out as in (48), (58), (62)."},
      {"jacobian", &ProcedureChoices::jacobian, "exact|b_derivative|simplified|reduced",
       "exact: the standard iteration; else the published one with (68)-(70), with (77)-(83), or "
       "with the reduced unknowns of its section 11.8."},
      {"slip_estimate", &ProcedureChoices::slip_estimate, "auto|jacobi|pseudo_temporal|extrapolation",
       "Of sticking pairs with jacobian = reduced: (90), (91) or (92)."},
      {"line_search", &ProcedureChoices::line_search, "auto|armijo|off",
       "Of the published iterations, section 11.1; off: full steps."},
  };
  return rows;
}

}  // namespace

std::span<const Setting> option_table() {
  return table().settings();
}

std::span<const Setting> procedure_table() {
  return procedures().settings();
}

void Options::set_procedure(const char* choices) {
  require_pointer(choices, "procedure");
  ProcedureChoices chosen;
  std::istringstream words(choices);
  for (std::string word; words >> word;) {
    const std::size_t sign = word.find('=');
    if (sign == std::string::npos)
      fail(Status::err_option, "procedure has '%.60s'; allowed: options and values, like system=monolithic",
           word.c_str());
    procedures().set_text(chosen, word.substr(0, sign).c_str(), word.substr(sign + 1).c_str());
  }
  if (chosen != procedure) ++revision;
  procedure = std::move(chosen);
}

void Options::set_int(const char* name, std::int64_t value) {
  if (table().set_int(*this, name, value)) ++revision;
}

void Options::set_real(const char* name, double value) {
  if (table().set_real(*this, name, value)) ++revision;
}

void Options::set_text(const char* name, const char* value) {
  if (table().set_text(*this, name, value)) ++revision;
}

std::int64_t Options::get_int(const char* name) const {
  return table().get_int(*this, name);
}

double Options::get_real(const char* name) const {
  return table().get_real(*this, name);
}

const std::string& Options::get_text(const char* name) const {
  return table().get_text(*this, name);
}

}  // namespace rollcon
