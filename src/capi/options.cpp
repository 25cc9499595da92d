/// Solver settings by name, and their table.

#include "contact/options.hpp"

#include "capi/guard.hpp"
#include "capi/results.hpp"

using namespace rollcon;
using namespace rollcon::capi;

namespace {

const OptionInfo& option_row(int32_t i) {
  const auto table = option_table();
  if (i < 0 || static_cast<std::size_t>(i) >= table.size())
    fail(Status::err_argument, "i is %d; allowed: 0 to %zu", i, table.size() - 1);
  return table[static_cast<std::size_t>(i)];
}

}  // namespace

rollcon_status rollcon_contact_set_int(rollcon_contact* contact, const char* name, int64_t value) {
  return with_contact(__func__, contact, [&](Contact& c) { c.scene.options.set_int(name, value); });
}

rollcon_status rollcon_contact_set_real(rollcon_contact* contact, const char* name, double value) {
  return with_contact(__func__, contact,
                      [&](Contact& c) { c.scene.options.set_real(name, value); });
}

rollcon_status rollcon_contact_set_str(rollcon_contact* contact, const char* name,
                                       const char* value) {
  return with_contact(__func__, contact,
                      [&](Contact& c) { c.scene.options.set_text(name, value); });
}

rollcon_status rollcon_contact_get_int(const rollcon_contact* contact, const char* name,
                                       int64_t* value) {
  return with_contact(__func__, contact, [&](Contact& c) {
    require_pointer(value, "value");
    *value = c.scene.options.get_int(name);
  });
}

rollcon_status rollcon_contact_get_real(const rollcon_contact* contact, const char* name,
                                        double* value) {
  return with_contact(__func__, contact, [&](Contact& c) {
    require_pointer(value, "value");
    *value = c.scene.options.get_real(name);
  });
}

rollcon_status rollcon_contact_get_str(const rollcon_contact* contact, const char* name,
                                       int64_t capacity, char* text, int64_t* needed) {
  return with_contact(__func__, contact, [&](Contact& c) {
    copy_text(c.scene.options.get_text(name), capacity, text, needed);
  });
}

int32_t rollcon_option_count(void) {
  return static_cast<int32_t>(option_table().size());
}

rollcon_status rollcon_option_info(int32_t i, int64_t capacity, char* name, int32_t* type,
                                   double* low, double* high, double* standard) {
  return guarded(__func__, nullptr, [&] {
    const OptionInfo& row = option_row(i);
    std::int64_t unused = 0;
    copy_text(row.name, capacity, name, &unused);
    if (type) *type = static_cast<int32_t>(row.type);
    if (low) *low = row.low;
    if (high) *high = row.high;
    if (standard) *standard = row.standard;
  });
}

rollcon_status rollcon_option_doc(int32_t i, int64_t capacity, char* text, int64_t* needed) {
  return guarded(__func__, nullptr, [&] {
    const OptionInfo& row = option_row(i);
    std::string doc = row.doc;
    if (row.choices) doc += " Values: " + std::string(row.choices) + "; the first is the standard.";
    copy_text(doc, capacity, text, needed);
  });
}
