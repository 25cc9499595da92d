/// Implements the calls that make wheels on rails and return their results and the contacts of their patches.

#include <algorithm>
#include <iterator>
#include <utility>

#include "capi/columns.hpp"
#include "capi/guard.hpp"
#include "capi/results.hpp"
#include "support/input_checks.hpp"
#include "wheelrail/solve_positions.hpp"
#include "wheelrail/wheel_rail.hpp"

using namespace rollcon;
using namespace rollcon::capi;

namespace {

/// Returns the one object of a contact, which may have many handles, because its callback belongs to the contact.
/// Objects of contacts that the wheel on its rail has replaced and nobody else knows are dropped.
std::shared_ptr<Object> object_of(Object& owner, const std::shared_ptr<Contact>& contact) {
  std::erase_if(owner.patches, [](const auto& p) { return p.use_count() == 1 && p->contact.use_count() == 1; });
  const auto known = std::find_if(owner.patches.begin(), owner.patches.end(),
                                  [&](const auto& patch) { return patch->contact == contact; });
  if (known != owner.patches.end()) return *known;
  auto object = std::make_shared<Object>();
  object->context = owner.context;
  object->contact = contact;
  object->busy = owner.busy;
  object->read_only = true;
  owner.patches.push_back(object);
  return object;
}

}  // namespace

rollcon_status rollcon_wheelrail_create(rollcon_context* context, rollcon_body* wheel, rollcon_body* rail, int32_t side,
                                        rollcon_wheelrail** wheelrail) {
  if (wheelrail) *wheelrail = nullptr;
  return with_object(__func__, Kind::context, context, [&](Object& parent) {
    std::shared_ptr<Body> turning = body_of(wheel, "wheel"), resting = body_of(rail, "rail");
    require_pointer(wheelrail, "wheelrail");
    auto object = std::make_shared<Object>();
    object->context = parent.context;
    object->wheelrail = std::make_unique<WheelRail>(parent.context, std::move(turning), std::move(resting), side);
    *wheelrail =
        static_cast<rollcon_wheelrail*>(const_cast<void*>(handles().insert(Kind::wheelrail, std::move(object))));
  });
}

rollcon_status rollcon_wheelrail_copy(const rollcon_wheelrail* wheelrail, rollcon_wheelrail** copy) {
  if (copy) *copy = nullptr;
  return with_object(__func__, Kind::wheelrail, wheelrail, [&](Object& from) {
    require_pointer(copy, "copy");
    auto object = std::make_shared<Object>();
    object->context = from.context;
    object->wheelrail = from.wheelrail->copy();
    *copy = static_cast<rollcon_wheelrail*>(const_cast<void*>(handles().insert(Kind::wheelrail, std::move(object))));
  });
}

rollcon_status rollcon_wheelrail_solve_many(rollcon_wheelrail* wheelrail, int64_t n, const double* positions,
                                            const double* velocities, const char* columns, double* totals,
                                            int32_t* status) {
  return with_wheelrail(__func__, wheelrail, together([&](WheelRail& w) {
                          static constexpr const char* known[] = {"force_x",  "force_y",        "force_z",
                                                                  "moment_x", "moment_y",       "moment_z",
                                                                  "z",        "vertical_force", "friction_power"};
                          const std::vector<std::size_t> wanted = read_names(columns, "columns", known);
                          require_count(n, "n");
                          constexpr int64_t most = int64_t{1} << 40;
                          if (n > most)
                            fail(Status::err_argument, "n is %lld; allowed: 0 to %lld", static_cast<long long>(n),
                                 static_cast<long long>(most));
                          if (n > 0) {
                            require_pointer(positions, "positions");
                            require_pointer(velocities, "velocities");
                            require_pointer(totals, "totals");
                          }
                          std::vector<double> all(std::size(known) * static_cast<std::size_t>(n));
                          const Status worst = solve_positions(w, {n, positions, velocities}, all.data(), status);
                          for (auto row = all.begin(); row != all.end(); row += std::ssize(known))
                            totals = copy_columns(wanted, &*row, totals);
                          return worst;
                        }));
}

rollcon_status rollcon_wheelrail_get_resultant(const rollcon_wheelrail* wheelrail, int32_t axes, double* force,
                                               double* moment) {
  return with_wheelrail(__func__, wheelrail, [&](const WheelRail& w) {
    if (axes != ROLLCON_IN_TRACK && axes != ROLLCON_IN_WHEELSET)
      fail(Status::err_argument, "axes is %d; allowed: 0 (in track), 1 (in wheelset)", axes);
    w.resultant(axes == ROLLCON_IN_WHEELSET, force, moment);
  });
}

rollcon_status rollcon_wheelrail_past_get(const rollcon_wheelrail* wheelrail, int64_t capacity, double* past,
                                          int64_t* n_values) {
  return with_wheelrail(__func__, wheelrail, [&](const WheelRail& w) {
    const std::vector<double> all = w.past_numbers();
    if (wants_copy(std::ssize(all), capacity, past, "past", n_values, "doubles"))
      std::copy(all.begin(), all.end(), past);
  });
}

rollcon_status rollcon_wheelrail_get_patch_axes(const rollcon_wheelrail* wheelrail, int32_t patch, double* origin,
                                                double* axes) {
  return with_wheelrail(__func__, wheelrail, [&](const WheelRail& w) {
    const Axes a = w.patch_axes(patch);
    if (origin) std::copy(a.origin.begin(), a.origin.end(), origin);
    if (!axes) return;
    for (const Vec3* v : {&a.t1, &a.t2, &a.n}) axes = std::copy(v->begin(), v->end(), axes);
  });
}

rollcon_status rollcon_wheelrail_get_profile_point(const rollcon_wheelrail* wheelrail, int32_t which, double share,
                                                   double* point) {
  return with_wheelrail(__func__, wheelrail, [&](const WheelRail& w) {
    require_pointer(point, "point");
    const auto x = w.profile_point(which, share);
    std::copy(x.begin(), x.end(), point);
  });
}

rollcon_status rollcon_wheelrail_get_derivative(rollcon_wheelrail* wheelrail, int32_t entry, double* force,
                                                double* moment, double* z) {
  return with_wheelrail(__func__, wheelrail, [&](WheelRail& w) {
    const WheelRail::Derivative d = w.derivative(entry);
    if (force) std::copy(d.force.begin(), d.force.end(), force);
    if (moment) std::copy(d.moment.begin(), d.moment.end(), moment);
    if (z) *z = d.z;
  });
}

rollcon_status rollcon_wheelrail_get_contact(const rollcon_wheelrail* wheelrail, int32_t patch,
                                             rollcon_contact** contact) {
  if (contact) *contact = nullptr;
  return with_object(__func__, Kind::wheelrail, wheelrail, [&](Object& object) {
    require_pointer(contact, "contact");
    std::shared_ptr<Object> of_patch = object_of(object, object.wheelrail->contact(patch));
    *contact = static_cast<rollcon_contact*>(const_cast<void*>(handles().insert(Kind::contact, std::move(of_patch))));
  });
}

rollcon_status rollcon_wheelrail_set_table(rollcon_wheelrail* wheelrail, const rollcon_table* table) {
  return with_wheelrail(__func__, wheelrail,
                        [&](WheelRail& w) { w.set_table(table ? table_of(table, "table") : nullptr); });
}
