#include "support/setting_table.hpp"

#include <cmath>

namespace rollcon {

namespace {

const char* type_name(SettingType type) {
  switch (type) {
    case SettingType::integer:
      return "an integer";
    case SettingType::real:
      return "a real number";
    case SettingType::text:
      return "text";
  }
  return "";
}

/// Returns true if `value` is one of the words of "a|b|c".
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

void require_allowed(const Setting& setting, std::int64_t value) {
  if (value < static_cast<std::int64_t>(setting.low) || value > static_cast<std::int64_t>(setting.high))
    fail(Status::err_option, "option '%s' is %lld; allowed: %.0f to %.0f", setting.name, static_cast<long long>(value),
         setting.low, setting.high);
}

void require_allowed(const Setting& setting, double value) {
  if (!std::isfinite(value)) fail(Status::err_nonfinite, "option '%s' is %g", setting.name, value);
  if (value < setting.low || value > setting.high)
    fail(Status::err_option, "option '%s' is %g; allowed: %g to %g", setting.name, value, setting.low, setting.high);
}

void require_allowed(const Setting& setting, const char* value) {
  if (!is_choice(setting.choices, value))
    fail(Status::err_option, "option '%s' is '%.64s'; allowed: %s", setting.name, value, setting.choices);
}

void fail_wrong_type(const Setting& setting, SettingType wanted) {
  fail(Status::err_option, "option '%s' is %s, not %s", setting.name, type_name(setting.type), type_name(wanted));
}

void fail_unknown_setting(std::span<const Setting> known, const char* name) {
  std::string names;
  for (const Setting& setting : known) names += (names.empty() ? "" : ", ") + std::string(setting.name);
  fail(Status::err_option, "unknown option '%.64s'; options are: %s", name, names.c_str());
}

}  // namespace rollcon
