// Calls the functions that return results of contacts.

#include <algorithm>
#include <cmath>

#include "calls.hpp"

namespace fuzz {
namespace {

std::int64_t nodes_of(const rollcon_contact* contact) {
  std::int64_t nodes = 0;
  rollcon_contact_get_size(contact, &nodes, nullptr);
  return nodes;
}

std::int32_t axes(World& w) {
  return w.in.one_in(12) ? w.in.integer32() : w.in.below(2);
}

/// Asks for the capacity in entries of `width` numbers.
template <class T, class F>
void ask_rows(World& w, std::int64_t rows, std::int64_t width, F&& call) {
  ask<T>(w, rows * width, [&](std::int64_t capacity, T* out, std::int64_t* told) {
    const std::int64_t fit = capacity < 0 ? capacity : capacity / width;
    const std::int32_t status = call(fit, out);
    if (status == ROLLCON_OK) *told = rows * width;
    return status;
  });
}

void tractions(World& w) {
  const rollcon_contact* c = w.contact();
  const std::int32_t a = axes(w);
  ask_rows<double>(w, nodes_of(c), 3, [&](std::int64_t fit, double* out) {
    return FUZZ_CALL(w, rollcon_contact_get_tractions, c, a, fit, out);
  });
}

void status(World& w) {
  const rollcon_contact* c = w.contact();
  ask_rows<std::int32_t>(w, nodes_of(c), 1, [&](std::int64_t fit, std::int32_t* out) {
    return FUZZ_CALL(w, rollcon_contact_get_node_states, c, fit, out);
  });
}

void field(World& w) {
  const rollcon_contact* c = w.contact();
  const std::int32_t which = w.in.one_in(12) ? w.in.integer32() : 1 + w.in.below(12), a = axes(w);
  std::int64_t need = 0;
  rollcon_contact_get_field(c, which, a, 0, nullptr, &need);
  ask<double>(w, need, [&](std::int64_t capacity, double* out, std::int64_t* told) {
    return FUZZ_CALL(w, rollcon_contact_get_field, c, which, a, capacity, out, told);
  });
}

void resultant(World& w) {
  const rollcon_contact* c = w.contact();
  Output<double> force(3), moment(3), approach(1), creep(3);
  bool good = FUZZ_CALL(w, rollcon_contact_get_resultant, c, axes(w), force.data(),
                        w.in.one_in(4) ? nullptr : moment.data()) == ROLLCON_OK;
  require(good || (force.untouched() && moment.untouched()), "a failed call wrote into its output");
  good = FUZZ_CALL(w, rollcon_contact_get_motion, c, w.in.one_in(4) ? nullptr : approach.data(), creep.data()) ==
         ROLLCON_OK;
  require(good || (approach.untouched() && creep.untouched()), "a failed call wrote into its output");
}

void sensitivity(World& w) {
  const rollcon_contact* c = w.contact();
  Output<double> force(3), moment(3), approach(1), creep(3);
  const std::int32_t by = w.in.one_in(12) ? w.in.integer32() : 1 + w.in.below(5);
  const bool good = FUZZ_CALL(w, rollcon_contact_get_sensitivity, c, by, force.data(),
                              w.in.one_in(4) ? nullptr : moment.data(), approach.data(), creep.data()) == ROLLCON_OK;
  require(good ? all_finite(force.values()) && all_finite(moment.values()) && all_finite(approach.values()) &&
                     all_finite(creep.values())
               : force.untouched() && moment.untouched() && approach.untouched() && creep.untouched(),
          good ? "a derivative is not finite" : "a failed call wrote into its output");
}

void displacements_at(World& w) {
  const rollcon_contact* c = w.contact();
  const std::int64_t n = array_size(w.in, 5);
  const std::vector<double> xy = w.in.reals(static_cast<std::size_t>(n > 0 ? 2 * n : 0));
  Output<double> u(n > 0 ? 3 * n : 0);
  const bool good = FUZZ_CALL(w, rollcon_contact_get_displacements_at, c, w.in.below(4), n, maybe_null(w.in, xy),
                              u.data()) == ROLLCON_OK;
  require(good ? all_finite(u.values()) : u.untouched(),
          good ? "a displacement is not finite" : "a failed call wrote into its output");
}

void temperatures_at(World& w) {
  const rollcon_contact* c = w.contact();
  const std::int64_t n = array_size(w.in, 5);
  const std::vector<double> xy = w.in.reals(static_cast<std::size_t>(n > 0 ? 2 * n : 0));
  Output<double> t(n > 0 ? 2 * n : 0);
  const bool good =
      FUZZ_CALL(w, rollcon_contact_get_temperatures_at, c, n, maybe_null(w.in, xy), t.data()) == ROLLCON_OK;
  require(good ? all_finite(t.values()) : t.untouched(),
          good ? "a temperature is not finite" : "a failed call wrote into its output");
}

void stresses_at(World& w) {
  const rollcon_contact* c = w.contact();
  const std::int64_t n = array_size(w.in, 5);
  std::vector<double> xyz = w.in.reals(static_cast<std::size_t>(n > 0 ? 3 * n : 0));
  const std::int32_t body = w.in.below(4);
  // Most points would lie outside of the body.
  if (!w.in.one_in(8))
    for (std::size_t k = 2; k < xyz.size(); k += 3) xyz[k] = body == 1 ? -std::abs(xyz[k]) : std::abs(xyz[k]);
  Output<double> stress(n > 0 ? 6 * n : 0), u(n > 0 ? 3 * n : 0);
  const bool good = FUZZ_CALL(w, rollcon_contact_get_fields_at, c, body, n, maybe_null(w.in, xyz), ROLLCON_IN_CONTACT,
                              w.in.one_in(4) ? nullptr : u.data(), stress.data()) == ROLLCON_OK;
  require(good ? all_finite(stress.values()) : stress.untouched() && u.untouched(),
          good ? "a stress is not finite" : "a failed call wrote into its output");
}

void body_displacements(World& w) {
  const rollcon_contact* c = w.contact();
  const std::int32_t body = w.in.below(4);
  std::int64_t n = 0;
  FUZZ_CALL(w, rollcon_contact_get_body_displacements, c, body, 0, nullptr, &n);
  Output<double> u(n);
  const bool good =
      n > 0 && FUZZ_CALL(w, rollcon_contact_get_body_displacements, c, body, n, u.data(), nullptr) == ROLLCON_OK;
  require(good ? all_finite(u.values()) : u.untouched(), "displacements of a body under a contact");
}

void body_power(World& w) {
  const rollcon_contact* c = w.contact();
  const std::int32_t body = w.in.below(4);
  std::int64_t n = 0;
  FUZZ_CALL(w, rollcon_contact_get_body_power, c, body, 0, nullptr, &n);
  Output<double> power(n);
  const bool good =
      n > 0 && FUZZ_CALL(w, rollcon_contact_get_body_power, c, body, n, power.data(), nullptr) == ROLLCON_OK;
  require(good ? all_finite(power.values()) : power.untouched(), "power that a body loses");
}

void body_fields_under_contact(World& w) {
  const rollcon_contact* c = w.contact();
  const std::int32_t body = w.in.below(4);
  const std::int64_t n = array_size(w.in, 4);
  const std::vector<double> x = w.in.reals(static_cast<std::size_t>(n > 0 ? 3 * n : 0));
  Output<double> u(n > 0 ? 3 * n : 0), stress(n > 0 ? 6 * n : 0);
  const bool good = FUZZ_CALL(w, rollcon_contact_get_fields_at, c, body, n, w.in.one_in(8) ? nullptr : x.data(),
                              ROLLCON_IN_BODY, u.data(), stress.data()) == ROLLCON_OK;
  require(good ? all_finite(u.values()) && all_finite(stress.values()) : u.untouched() && stress.untouched(),
          "fields of a body under a contact");
}

void wear(World& w) {
  const rollcon_contact* c = w.contact();
  const std::int64_t points = array_size(w.in, 5);
  std::vector<double> y = w.in.reals(static_cast<std::size_t>(points > 0 ? points : 0));
  if (!w.in.one_in(6)) std::sort(y.begin(), y.end());
  const std::int32_t n = w.in.below(5);
  const std::vector<double> parameters = w.in.reals(static_cast<std::size_t>(n));
  Output<double> depth(points > 0 ? points : 0), volume(1);
  const bool good =
      FUZZ_CALL(w, rollcon_contact_get_wear, c, w.in.one_in(2) ? "archard" : "t_gamma", n, maybe_null(w.in, parameters),
                points, maybe_null(w.in, y), depth.data(), volume.data()) == ROLLCON_OK;
  require(good ? all_finite(depth.values()) && all_finite(volume.values()) : depth.untouched() && volume.untouched(),
          "wear of a contact");
}

void worn_profile(World& w) {
  const std::int64_t points = array_size(w.in, 5);
  const std::vector<double> yz = w.in.reals(static_cast<std::size_t>(points > 0 ? 2 * points : 0)),
                            rate = w.in.reals(static_cast<std::size_t>(points > 0 ? points : 0));
  Output<double> worn(points > 0 ? 2 * points : 0), taken(1);
  const bool good = FUZZ_CALL(w, rollcon_wear_profile, points, maybe_null(w.in, yz), maybe_null(w.in, rate),
                              w.in.one_in(8) ? 0 : 2 * w.in.below(2) - 1, std::abs(w.in.real()), std::abs(w.in.real()),
                              std::abs(w.in.real()), worn.data(), taken.data()) == ROLLCON_OK;
  require(good ? all_finite(worn.values()) && all_finite(taken.values()) : worn.untouched() && taken.untouched(),
          "a worn profile");
}

void fatigue_index(World& w) {
  const rollcon_contact* c = w.contact();
  Output<double> index(1);
  const bool good = FUZZ_CALL(w, rollcon_contact_get_fatigue_index, c, w.in.reals(1)[0], index.data()) == ROLLCON_OK;
  require(good || index.untouched(), "a failed call wrote into its output");
}

void find_stress(World& w) {
  const rollcon_contact* c = w.contact();
  const std::int32_t which = w.in.below(4);
  Output<double> value(1), place(3);
  const std::vector<double> parameter = w.in.reals(3);
  static constexpr const char* measures[] = {"shear", "dang_van", "crossland", "lundberg_palmgren", "none"};
  const bool good = FUZZ_CALL(w, rollcon_contact_find_stress, c, which, measures[w.in.below(5)], w.in.below(4),
                              parameter.data(), value.data(), place.data()) == ROLLCON_OK;
  require(good || (value.untouched() && place.untouched()), "a failed call wrote into its output");
}

void stress_invariants(World& w) {
  const std::int64_t n = array_size(w.in, 5);
  const std::vector<double> stress = w.in.reals(static_cast<std::size_t>(n > 0 ? 6 * n : 0));
  Output<double> principal(n > 0 ? 3 * n : 0), von_mises(n > 0 ? n : 0), shear(n > 0 ? n : 0);
  const bool good = FUZZ_CALL(w, rollcon_stress_invariants, n, maybe_null(w.in, stress), principal.data(),
                              w.in.one_in(4) ? nullptr : von_mises.data(), shear.data()) == ROLLCON_OK;
  require(good || (principal.untouched() && von_mises.untouched() && shear.untouched()),
          "a failed call wrote into its output");
}

void stat(World& w) {
  const rollcon_contact* c = w.contact();
  const std::string name = w.in.text(known_names());
  Output<double> value(1);
  const bool good =
      FUZZ_CALL(w, rollcon_contact_get_stat, c, w.in.one_in(40) ? nullptr : name.c_str(), value.data()) == ROLLCON_OK;
  require(good || value.untouched(), "a failed call wrote into its output");
}

void history(World& w) {
  const rollcon_contact* c = w.contact();
  std::int64_t rows = 0;
  const char* columns = w.in.one_in(8) ? "seconds none" : "phase step error_function";
  rollcon_contact_get_history(c, columns, 0, nullptr, &rows);
  ask_rows<double>(w, rows, 3, [&](std::int64_t fit, double* out) {
    return FUZZ_CALL(w, rollcon_contact_get_history, c, columns, fit, out, nullptr);
  });
}

void plan(World& w) {
  const rollcon_contact* c = w.contact();
  std::int64_t need = 1;
  rollcon_contact_get_plan(c, 0, nullptr, &need);
  ask<char>(w, need, [&](std::int64_t capacity, char* text, std::int64_t* told) {
    return FUZZ_CALL(w, rollcon_contact_get_plan, c, capacity, text, told);
  });
}

void write(World& w) {
  const rollcon_contact* c = w.contact();
  if (w.files_left-- > 0) FUZZ_CALL(w, rollcon_contact_write, c, w.path().c_str());
}

}  // namespace

std::span<const Call> result_calls() {
  static const Call calls[] = {tractions,
                               status,
                               field,
                               field,
                               resultant,
                               sensitivity,
                               sensitivity,
                               displacements_at,
                               stresses_at,
                               body_displacements,
                               body_power,
                               body_fields_under_contact,
                               wear,
                               worn_profile,
                               stress_invariants,
                               temperatures_at,
                               fatigue_index,
                               find_stress,
                               stat,
                               history,
                               plan,
                               write};
  return calls;
}

}  // namespace fuzz
