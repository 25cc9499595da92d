/// Implements the calls that make, release and evaluate creep-force tables.

#include <algorithm>

#include "capi/guard.hpp"
#include "capi/progress.hpp"
#include "capi/results.hpp"
#include "support/input_checks.hpp"
#include "tables/force_table.hpp"

using namespace rollcon;
using namespace rollcon::capi;

namespace {

/// Makes a handle of what `make` returns.
template <class Make>
rollcon_status new_table(const char* function, rollcon_context* context, rollcon_table** table, Make make) {
  if (table) *table = nullptr;
  return with_object(function, Kind::context, context, [&](Object& parent) {
    require_pointer(table, "table");
    auto object = std::make_shared<Object>();
    object->context = parent.context;
    object->table = make(parent.context);
    *table = static_cast<rollcon_table*>(const_cast<void*>(handles().insert(Kind::table, std::move(object))));
  });
}

}  // namespace

rollcon_status rollcon_table_create(rollcon_context* context, rollcon_table** table) {
  return new_table(__func__, context, table,
                   [](const std::shared_ptr<Context>& of) { return std::make_unique<ForceTable>(of); });
}

rollcon_status rollcon_table_load(rollcon_context* context, const char* path, rollcon_table** table) {
  return new_table(__func__, context, table, [&](const std::shared_ptr<Context>& of) {
    require_pointer(path, "path");
    return ForceTable::load(of, path);
  });
}

rollcon_status rollcon_table_standard(rollcon_context* context, rollcon_table** table) {
  return new_table(__func__, context, table,
                   [](const std::shared_ptr<Context>& of) { return ForceTable::standard(of); });
}

rollcon_status rollcon_table_set_progress(rollcon_table* table, rollcon_progress_fn fn, void* user) {
  return with_object(__func__, Kind::table, table, [&](Object& object) {
    object.progress = fn;
    object.progress_user = user;
    object.table->set_progress(fn ? call_progress : nullptr, &object);
  });
}

rollcon_status rollcon_table_get_samples(const rollcon_table* table, int64_t capacity, double* samples,
                                         int64_t* count) {
  return with_table(__func__, table, [&](const ForceTable& t) {
    require_pointer(count, "count");
    if (wants_copy(t.samples(0, nullptr), capacity, samples, "samples", count, "numbers")) t.samples(capacity, samples);
  });
}

rollcon_status rollcon_table_make(rollcon_table* table, int32_t part, int32_t parts) {
  return with_table(__func__, table, together([&](ForceTable& t) { return t.make(part, parts); }));
}

rollcon_status rollcon_table_evaluate(const rollcon_table* table, int64_t n, const double* inputs, double* results) {
  return with_shared(__func__, Kind::table, table,
                     [&](Object& object) { object.table->evaluate(n, inputs, results, nullptr); });
}

rollcon_status rollcon_table_evaluate_derivatives(const rollcon_table* table, int64_t n, const double* inputs,
                                                  double* results, double* derivatives) {
  return with_shared(__func__, Kind::table, table, [&](Object& object) {
    if (n != 0) require_pointer(derivatives, "derivatives");
    object.table->evaluate(n, inputs, results, derivatives);
  });
}

rollcon_status rollcon_table_evaluate_contact(const rollcon_table* table, const rollcon_contact* contact,
                                              double friction, double results[3]) {
  const char* const function = __func__;
  return with_shared(function, Kind::table, table, [&](Object& object) {
    return static_cast<Status>(with_contact(function, contact, [&](const Contact& c) {
      require_finite(friction, "friction");
      require_pointer(results, "results");
      EquivalentEllipse e = c.equivalent_ellipse();
      if (friction != -1) e.friction = friction;
      double own[3];
      object.table->evaluate(e, own);
      own[2] += e.centre[0] * own[1] - e.centre[1] * own[0];
      std::copy_n(own, 3, results);
    }));
  });
}
