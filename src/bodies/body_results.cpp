#include "bodies/body_results.hpp"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <string>
#include <vector>

#include "bodies/model/imbalance.hpp"
#include "support/input_checks.hpp"

namespace rollcon {

namespace {

void require_prepared(const Body& body) {
  if (!body.prepared()) fail(Status::err_state, "the body is not prepared: call rollcon_body_prepare first");
}

void require_prepared_mesh(const Body& body) {
  if (!body.traits().meshed) fail(Status::err_state, "a %s has no mesh: there is nothing to read", body.traits().name);
  require_prepared(body);
}

struct Statistic {
  const char* name;
  double (*value)(const Body&);  ///< takes a prepared body
};

/// Returns a statistic of the equations; 0 for bodies without them.
template <auto member>
double of_equations(const Body& body) {
  return body.response() ? static_cast<double>(body.response()->statistics().*member) : 0;
}
// The statistics below tell which loads make up "imbalance".
template <int component>
double missed_along(const Body& body) {
  return imbalances_of(body.response()).along[component];
}

using S = BodyStatistics;
constexpr Statistic statistics[] = {
    {"unknowns", of_equations<&S::unknowns>},
    {"assemblies", of_equations<&S::assemblies>},
    {"factorizations", of_equations<&S::factorizations>},
    {"condensations", of_equations<&S::condensations>},
    {"condensed_unknowns", of_equations<&S::condensed>},
    {"factor_nonzeros", of_equations<&S::nonzeros>},
    {"kernel_evaluations", of_equations<&S::kernel_evaluations>},
    {"responses_kept", of_equations<&S::responses_kept>},
    {"responses_dropped", of_equations<&S::responses_dropped>},
    {"condition", of_equations<&S::condition>},
    {"imbalance", of_equations<&S::imbalance>},
    {"seconds_assembly", of_equations<&S::seconds_assembly>},
    {"seconds_order", of_equations<&S::seconds_order>},
    {"seconds_factor", of_equations<&S::seconds_factor>},
    {"seconds_condense", of_equations<&S::seconds_condense>},
    {"bytes", of_equations<&S::bytes>},
    {"peak_bytes", of_equations<&S::peak_bytes>},
    {"imbalance_x", missed_along<0>},
    {"imbalance_y", missed_along<1>},
    {"imbalance_z", missed_along<2>},
    {"imbalance_pressure", [](const Body& body) { return imbalances_of(body.response()).pressure; }},
    {"imbalance_loads", [](const Body& body) { return body.own().missed; }},
    {"shared", [](const Body& body) { return body.shared() ? 1.0 : 0.0; }},
    {"loaded", [](const Body& body) { return body.loaded() ? 1.0 : 0.0; }},
};

}  // namespace

void body_displacements(const Body& body, std::int64_t capacity, double* u) {
  require_prepared_mesh(body);
  const std::int64_t nodes = body.mesh().surface.nodes();
  if (capacity < nodes)
    fail(Status::err_capacity, "capacity is %lld nodes; needed: %lld", static_cast<long long>(capacity),
         static_cast<long long>(nodes));
  const std::span<const double> own = body.own().displacement;
  if (own.empty())
    std::fill_n(u, 3 * nodes, 0.0);
  else
    std::copy(own.begin(), own.end(), u);
}

void body_reaction(const Body& body, Vec3& force, Vec3& moment) {
  require_prepared_mesh(body);
  force = body.own().reaction.force;
  moment = body.own().reaction.moment;
}

double body_statistic(const Body& body, const char* name) {
  const auto* found = std::find_if(std::begin(statistics), std::end(statistics),
                                   [&](const Statistic& s) { return !std::strcmp(s.name, name); });
  if (found == std::end(statistics)) {
    std::string known;
    for (const Statistic& s : statistics) known += (known.empty() ? "" : ", ") + std::string(s.name);
    fail(Status::err_option, "unknown statistic '%.64s'; statistics are: %s", name, known.c_str());
  }
  require_prepared(body);
  return found->value(body);
}

std::int64_t body_statistic_count() {
  return static_cast<std::int64_t>(std::size(statistics));
}

const char* body_statistic_name(std::int64_t i) {
  return statistics[static_cast<std::size_t>(i)].name;
}

}  // namespace rollcon
