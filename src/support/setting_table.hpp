#pragma once
/// Provides settings by name: one table gives type, range, standard value and meaning of each, and the member of a
/// struct that holds its value.

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "support/input_checks.hpp"

namespace rollcon {

enum class SettingType : std::int32_t { integer = 1, real = 2, text = 3 };

struct Setting {
  const char* name;
  SettingType type;
  double low, high, standard;  ///< for numbers; text does not use them
  const char* choices;         ///< allowed values "a|b|c" of text, the first being the standard
  const char* doc;
};

/// Throws err_option if the value is not allowed (err_nonfinite for NaN and infinity).
void require_allowed(const Setting& setting, std::int64_t value);
void require_allowed(const Setting& setting, double value);
void require_allowed(const Setting& setting, const char* value);
[[noreturn]] void fail_wrong_type(const Setting& setting, SettingType wanted);
[[noreturn]] void fail_unknown_setting(std::span<const Setting> known, const char* name);

/// Setters and getters throw err_option for unknown names, wrong types and values out of range; the message names what
/// is allowed.
template <class Values>
class SettingTable {
 public:
  /// Takes the member's initialiser as the standard value.
  struct Row {
    Row(const char* name, std::int64_t Values::*member, double low, double high, const char* doc)
        : setting{name, SettingType::integer, low, high, static_cast<double>(Values{}.*member), nullptr, doc},
          integer(member) {}
    Row(const char* name, double Values::*member, double low, double high, const char* doc)
        : setting{name, SettingType::real, low, high, Values{}.*member, nullptr, doc}, real(member) {}
    Row(const char* name, std::string Values::*member, const char* choices, const char* doc)
        : setting{name, SettingType::text, 0, 0, 0, choices, doc}, text(member) {}

    Setting setting;
    std::int64_t Values::*integer = nullptr;
    double Values::*real = nullptr;
    std::string Values::*text = nullptr;
  };

  SettingTable(std::initializer_list<Row> rows) : rows_(rows) {
    for (const Row& row : rows_) settings_.push_back(row.setting);
  }

  std::span<const Setting> settings() const { return settings_; }

  /// Returns true if that changed the value.
  bool set_int(Values& values, const char* name, std::int64_t value) const {
    const Row& row = find(name, SettingType::integer);
    require_allowed(row.setting, value);
    return std::exchange(values.*row.integer, value) != value;
  }
  bool set_real(Values& values, const char* name, double value) const {
    const Row& row = find(name, SettingType::real);
    require_allowed(row.setting, value);
    return std::exchange(values.*row.real, value) != value;
  }
  bool set_text(Values& values, const char* name, const char* value) const {
    const Row& row = find(name, SettingType::text);
    require_pointer(value, "value");
    require_allowed(row.setting, value);
    std::string& held = values.*row.text;
    if (held == value) return false;
    held = value;
    return true;
  }
  std::int64_t get_int(const Values& values, const char* name) const {
    return values.*find(name, SettingType::integer).integer;
  }
  double get_real(const Values& values, const char* name) const { return values.*find(name, SettingType::real).real; }
  const std::string& get_text(const Values& values, const char* name) const {
    return values.*find(name, SettingType::text).text;
  }

 private:
  const Row& find(const char* name, SettingType type) const {
    require_pointer(name, "name");
    const auto row = std::find_if(rows_.begin(), rows_.end(),
                                  [&](const Row& candidate) { return std::strcmp(candidate.setting.name, name) == 0; });
    if (row == rows_.end()) fail_unknown_setting(settings_, name);
    if (row->setting.type != type) fail_wrong_type(row->setting, type);
    return *row;
  }

  std::vector<Row> rows_;
  std::vector<Setting> settings_;
};

}  // namespace rollcon
