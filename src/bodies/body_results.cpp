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
  StatisticInfo info;
  double (*value)(const Body&);  ///< takes a prepared body, but for the fit of a profile
  bool early = false;            ///< also of a body that is not prepared
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

template <auto member>
double of_fit(const Body& body) {
  return static_cast<double>(body.fit_report().*member);
}

using S = BodyStatistics;
constexpr Statistic statistics[] = {
    {{"unknowns", "unknowns of the equations"}, of_equations<&S::unknowns>},
    {{"assemblies", "assemblies of the equations"}, of_equations<&S::assemblies>},
    {{"factorizations", "factorisations"}, of_equations<&S::factorizations>},
    {{"condensations", "condensations onto faces", true}, of_equations<&S::condensations>},
    {{"condensed_unknowns", "unknowns left by the last condensation", true}, of_equations<&S::condensed>},
    {{"factor_nonzeros", "nonzeros of the factors; of dense ones unknowns squared", true}, of_equations<&S::nonzeros>},
    {{"kernel_evaluations", "evaluations of kernels", true}, of_equations<&S::kernel_evaluations>},
    {{"responses_kept", "responses to frames that are cached", true}, of_equations<&S::responses_kept>},
    {{"responses_dropped", "responses to frames that the cache dropped", true}, of_equations<&S::responses_dropped>},
    {{"condition", "estimated condition of the scaled matrix"}, of_equations<&S::condition>},
    {{"imbalance", "the largest part of a load that the reactions of boundary elements miss"},
     of_equations<&S::imbalance>},
    {{"seconds_assembly", "wall time of assembly"}, of_equations<&S::seconds_assembly>},
    {{"seconds_order", "wall time of ordering"}, of_equations<&S::seconds_order>},
    {{"seconds_factor", "wall time of factorisation"}, of_equations<&S::seconds_factor>},
    {{"seconds_condense", "wall time of condensation"}, of_equations<&S::seconds_condense>},
    {{"bytes", "bytes of equations, factors and cached responses"}, of_equations<&S::bytes>},
    {{"peak_bytes", "the most bytes while they were made"}, of_equations<&S::peak_bytes>},
    {{"needed_bytes", "bytes foreseen for the factors of boundary elements, before they are made"},
     of_equations<&S::needed_bytes>},
    {{"imbalance_x", "what reactions miss of tractions along x"}, missed_along<0>},
    {{"imbalance_y", "what reactions miss of tractions along y"}, missed_along<1>},
    {{"imbalance_z", "what reactions miss of tractions along z"}, missed_along<2>},
    {{"imbalance_pressure", "what reactions miss of pressures along a frame's normal"},
     [](const Body& body) { return imbalances_of(body.response()).pressure; }},
    {{"imbalance_loads", "what reactions miss of the body's own loads"},
     [](const Body& body) { return body.own().missed; }},
    {{"local_young", "Young's modulus that a given matrix shows between neighbouring nodes; 0: none is given"},
     [](const Body& body) { return imbalances_of(body.response()).local_young; }},
    {{"filter_moved", "the farthest that the filter moved a profile's point"}, of_fit<&FitReport::moved>, true},
    {{"filter_curvature",
      "the largest change of a profile's curvature if its filter were applied again: about what it took away"},
     of_fit<&FitReport::curvature>,
     true},
    {{"filter_y", "y of the place of filter_curvature"}, of_fit<&FitReport::y>, true},
    {{"kinks", "kinks of a profile given by points"}, of_fit<&FitReport::kinks>, true},
    {{"zigzags", "zig-zags of a profile's points, replaced by means"}, of_fit<&FitReport::zigzags>, true},
    {{"shared", "1: an equal body was prepared before, and nothing was assembled"},
     [](const Body& body) { return body.shared() ? 1.0 : 0.0; }},
    {{"loaded", "1: the body is from a file"}, [](const Body& body) { return body.loaded() ? 1.0 : 0.0; }},
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
  const Statistic& found = statistic_row(statistics, name);
  if (!found.early) require_prepared(body);
  return found.value(body);
}

const StatisticInfo* body_statistic_info(std::int64_t i) {
  return statistic_info(statistics, i);
}

}  // namespace rollcon
