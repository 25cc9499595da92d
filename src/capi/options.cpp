/// Implements the calls that set and list solver options by name.

#include "contact/scene/options.hpp"

#include "bodies/body_options.hpp"
#include "capi/guard.hpp"
#include "capi/results.hpp"

using namespace rollcon;
using namespace rollcon::capi;

namespace {

template <class Table>
const auto& row(const Table& table, int32_t i) {
  if (i < 0 || static_cast<std::size_t>(i) >= table.size())
    fail(Status::err_argument, "i is %d; allowed: 0 to %zu", i, table.size() - 1);
  return table[static_cast<std::size_t>(i)];
}

template <class Row>
void copy_row(const Row& from, int64_t capacity, char* name, int32_t* type, double* low, double* high,
              double* standard) {
  std::int64_t unused = 0;
  copy_text(from.name, capacity, name, &unused);
  if (type) *type = static_cast<int32_t>(from.type);
  if (low) *low = from.low;
  if (high) *high = from.high;
  if (standard) *standard = from.standard;
}

template <class Row>
void copy_doc(const Row& from, int64_t capacity, char* text, int64_t* needed) {
  std::string doc = from.doc;
  if (from.choices) doc += " Values: " + std::string(from.choices) + "; the first is the standard.";
  copy_text(doc, capacity, text, needed);
}

}  // namespace

int32_t rollcon_option_count(void) {
  return static_cast<int32_t>(option_table().size());
}

rollcon_status rollcon_option_info(int32_t i, int64_t capacity, char* name, int32_t* type, double* low, double* high,
                                   double* standard) {
  return guarded(__func__, nullptr,
                 [&] { copy_row(row(option_table(), i), capacity, name, type, low, high, standard); });
}

rollcon_status rollcon_option_doc(int32_t i, int64_t capacity, char* text, int64_t* needed) {
  return guarded(__func__, nullptr, [&] { copy_doc(row(option_table(), i), capacity, text, needed); });
}

int32_t rollcon_body_option_count(void) {
  return static_cast<int32_t>(body_option_table().settings().size());
}

rollcon_status rollcon_body_option_info(int32_t i, int64_t capacity, char* name, int32_t* type, double* low,
                                        double* high, double* standard) {
  return guarded(__func__, nullptr,
                 [&] { copy_row(row(body_option_table().settings(), i), capacity, name, type, low, high, standard); });
}

rollcon_status rollcon_body_option_doc(int32_t i, int64_t capacity, char* text, int64_t* needed) {
  return guarded(__func__, nullptr, [&] { copy_doc(row(body_option_table().settings(), i), capacity, text, needed); });
}
