#include "contact/options.hpp"

#include <array>
#include <cmath>
#include <cstring>

#include "support/input_checks.hpp"

namespace rollcon {

namespace {

/// Row of the table with the member that holds the value; the standard value is the member's
/// initialiser.
struct Row {
  OptionInfo info;
  std::int64_t Options::*integer = nullptr;
  double Options::*real = nullptr;
  std::string Options::*text = nullptr;
};

Row integer_row(const char* name, std::int64_t Options::*member, double low, double high,
                const char* doc) {
  const auto standard = static_cast<double>(Options{}.*member);
  return {{name, OptionType::integer, low, high, standard, nullptr, doc}, member, nullptr, nullptr};
}

Row real_row(const char* name, double Options::*member, double low, double high, const char* doc) {
  return {{name, OptionType::real, low, high, Options{}.*member, nullptr, doc},
          nullptr,
          member,
          nullptr};
}

Row text_row(const char* name, std::string Options::*member, const char* choices, const char* doc) {
  return {{name, OptionType::text, 0, 0, 0, choices, doc}, nullptr, nullptr, member};
}

const auto& rows() {
  static const std::array table{
      real_row("tolerance", &Options::tolerance, 1e-14, 1e-2,
               "Relative residual of the contact laws at which the iteration stops."),
      integer_row("max_iterations", &Options::max_iterations, 1, 100000,
                  "Most Newton iterations of one solve, those of its fallbacks included."),
      real_row("accuracy", &Options::accuracy, 1e-12, 1e-2,
               "Relative accuracy of the half-space integrals."),
      text_row("convection", &Options::convection, "characteristic|least_squares|godunov",
               "Scheme of the convective derivative in the slip."),
      text_row("linear_solver", &Options::linear_solver, "auto|lu|gmres",
               "Solver of the linear systems; auto chooses by size."),
      real_row("characteristic_step", &Options::characteristic_step, 0.01, 1,
               "Step upstream of the characteristic scheme, as a part of the local node spacing."),
      real_row("normal_scale", &Options::normal_scale, 1e-2, 1e2,
               "Factor on the augmentation parameter of the normal law."),
      real_row("tangential_scale", &Options::tangential_scale, 1e-2, 1e2,
               "Factor on the augmentation parameter of the friction law."),
      integer_row("warm_start", &Options::warm_start, 0, 1,
                  "1: a solve starts from the last solution; 0: from nothing."),
  };
  return table;
}

const char* type_name(OptionType type) {
  switch (type) {
    case OptionType::integer:
      return "an integer";
    case OptionType::real:
      return "a real number";
    case OptionType::text:
      return "text";
  }
  return "";
}

const Row& find(const char* name, OptionType type) {
  require_pointer(name, "name");
  for (const Row& row : rows()) {
    if (std::strcmp(row.info.name, name) != 0) continue;
    if (row.info.type != type)
      fail(Status::err_option, "option '%s' is %s, not %s", name, type_name(row.info.type),
           type_name(type));
    return row;
  }
  std::string known;
  for (const Row& row : rows()) known += (known.empty() ? "" : ", ") + std::string(row.info.name);
  fail(Status::err_option, "unknown option '%.64s'; options are: %s", name, known.c_str());
}

/// True if `value` is one of the words of "a|b|c".
bool is_choice(const char* choices, const char* value) {
  const std::size_t length = std::strlen(value);
  for (const char* word = choices;; ++word) {
    const std::size_t word_length = std::strcspn(word, "|");
    if (word_length == length && std::strncmp(word, value, length) == 0) return true;
    word += word_length;
    if (*word == '\0') return false;
  }
}

}  // namespace

std::span<const OptionInfo> option_table() {
  static const auto table = [] {
    std::array<OptionInfo, std::tuple_size_v<std::remove_cvref_t<decltype(rows())>>> infos{};
    for (std::size_t i = 0; i < infos.size(); ++i) infos[i] = rows()[i].info;
    return infos;
  }();
  return table;
}

void Options::set_int(const char* name, std::int64_t value) {
  const Row& row = find(name, OptionType::integer);
  if (value < static_cast<std::int64_t>(row.info.low) ||
      value > static_cast<std::int64_t>(row.info.high))
    fail(Status::err_option, "option '%s' is %lld; allowed: %.0f to %.0f", name,
         static_cast<long long>(value), row.info.low, row.info.high);
  std::int64_t& held = this->*row.integer;
  if (held == value) return;
  held = value;
  ++revision;
}

void Options::set_real(const char* name, double value) {
  const Row& row = find(name, OptionType::real);
  if (!std::isfinite(value)) fail(Status::err_nonfinite, "option '%s' is %g", name, value);
  if (value < row.info.low || value > row.info.high)
    fail(Status::err_option, "option '%s' is %g; allowed: %g to %g", name, value, row.info.low,
         row.info.high);
  double& held = this->*row.real;
  if (held == value) return;
  held = value;
  ++revision;
}

void Options::set_text(const char* name, const char* value) {
  const Row& row = find(name, OptionType::text);
  require_pointer(value, "value");
  if (!is_choice(row.info.choices, value))
    fail(Status::err_option, "option '%s' is '%.64s'; allowed: %s", name, value, row.info.choices);
  std::string& held = this->*row.text;
  if (held == value) return;
  held = value;
  ++revision;
}

std::int64_t Options::get_int(const char* name) const {
  return this->*find(name, OptionType::integer).integer;
}

double Options::get_real(const char* name) const {
  return this->*find(name, OptionType::real).real;
}

const std::string& Options::get_text(const char* name) const {
  return this->*find(name, OptionType::text).text;
}

}  // namespace rollcon
