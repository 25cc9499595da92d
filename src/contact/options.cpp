#include "contact/options.hpp"

namespace rollcon {

namespace {

const SettingTable<Options>& table() {
  static const SettingTable<Options> rows{
      {"tolerance", &Options::tolerance, 1e-14, 1e-2,
       "Relative residual of the contact laws at which the iteration stops."},
      {"max_iterations", &Options::max_iterations, 1, 100000,
       "Most Newton iterations of one solve, those of its fallbacks included."},
      {"accuracy", &Options::accuracy, 1e-12, 1e-2,
       "Relative accuracy of the half-space integrals."},
      {"convection", &Options::convection, "characteristic|least_squares|godunov",
       "Scheme of the convective derivative in the slip."},
      {"linear_solver", &Options::linear_solver, "auto|lu|gmres",
       "Solver of the linear systems; auto chooses by size."},
      {"characteristic_step", &Options::characteristic_step, 0.01, 1,
       "Step upstream of the characteristic scheme, as a part of the local node spacing."},
      {"normal_scale", &Options::normal_scale, 1e-2, 1e2,
       "Factor on the augmentation parameter of the normal law."},
      {"tangential_scale", &Options::tangential_scale, 1e-2, 1e2,
       "Factor on the augmentation parameter of the friction law."},
      {"warm_start", &Options::warm_start, 0, 1,
       "1: a solve starts from the last solution; 0: from nothing."},
  };
  return rows;
}

}  // namespace

std::span<const Setting> option_table() {
  return table().settings();
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
