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
  if (!body.prepared())
    fail(Status::err_state, "the body is not prepared: call rollcon_body_prepare first");
}

void require_prepared_mesh(const Body& body) {
  if (body.kind() == BodyKind::halfspace)
    fail(Status::err_state, "a half-space has no mesh: there is nothing to read");
  require_prepared(body);
}

struct Statistic {
  const char* name;
  double (*value)(const BodyStatistics&);
};

/// Of any prepared body.
struct Origin {
  const char* name;
  bool (Body::*is)() const;
};
constexpr Origin origins[] = {{"shared", &Body::shared}, {"loaded", &Body::loaded}};

template <class T>
double number(T v) {
  return static_cast<double>(v);
}

constexpr Statistic statistics[] = {
    {"unknowns", [](const BodyStatistics& s) { return number(s.unknowns); }},
    {"assemblies", [](const BodyStatistics& s) { return number(s.assemblies); }},
    {"factorizations", [](const BodyStatistics& s) { return number(s.factorizations); }},
    {"condensations", [](const BodyStatistics& s) { return number(s.condensations); }},
    {"condensed_unknowns", [](const BodyStatistics& s) { return number(s.condensed); }},
    {"factor_nonzeros", [](const BodyStatistics& s) { return number(s.nonzeros); }},
    {"kernel_evaluations", [](const BodyStatistics& s) { return number(s.kernel_evaluations); }},
    {"responses_kept", [](const BodyStatistics& s) { return number(s.responses_kept); }},
    {"responses_dropped", [](const BodyStatistics& s) { return number(s.responses_dropped); }},
    {"condition", [](const BodyStatistics& s) { return s.condition; }},
    {"imbalance", [](const BodyStatistics& s) { return s.imbalance; }},
    {"seconds_assembly", [](const BodyStatistics& s) { return s.seconds_assembly; }},
    {"seconds_order", [](const BodyStatistics& s) { return s.seconds_order; }},
    {"seconds_factor", [](const BodyStatistics& s) { return s.seconds_factor; }},
    {"seconds_condense", [](const BodyStatistics& s) { return s.seconds_condense; }},
    {"bytes", [](const BodyStatistics& s) { return number(s.bytes); }},
    {"peak_bytes", [](const BodyStatistics& s) { return number(s.peak_bytes); }},
};

/// Which loads make up "imbalance".
struct Missed {
  const char* name;
  double (*value)(const Imbalances&);
};
constexpr Missed missed_loads[] = {
    {"imbalance_x", [](const Imbalances& i) { return i.along[0]; }},
    {"imbalance_y", [](const Imbalances& i) { return i.along[1]; }},
    {"imbalance_z", [](const Imbalances& i) { return i.along[2]; }},
    {"imbalance_pressure", [](const Imbalances& i) { return i.pressure; }},
    {"imbalance_loads", [](const Imbalances& i) { return i.loads; }},
};

}  // namespace

void body_displacements(const Body& body, std::int64_t capacity, double* u) {
  require_prepared_mesh(body);
  const std::int64_t nodes = body.mesh().surface.nodes();
  if (capacity < nodes)
    fail(Status::err_capacity, "capacity is %lld nodes; needed: %lld",
         static_cast<long long>(capacity), static_cast<long long>(nodes));
  std::span<const double> own;
  if (body.response()) own = body.response()->own_displacement();
  if (own.empty())
    std::fill_n(u, 3 * nodes, 0.0);
  else
    std::copy(own.begin(), own.end(), u);
}

void body_reaction(const Body& body, Vec3& force, Vec3& moment) {
  require_prepared_mesh(body);
  Resultant r;
  if (body.response()) r = body.response()->support_reaction();
  force = r.force;
  moment = r.moment;
}

double body_statistic(const Body& body, const char* name) {
  for (const Origin& origin : origins)
    if (std::strcmp(origin.name, name) == 0) {
      require_prepared(body);
      return (body.*origin.is)() ? 1 : 0;
    }
  for (const Missed& missed : missed_loads)
    if (std::strcmp(missed.name, name) == 0) {
      require_prepared(body);
      return missed.value(imbalances_of(body.response()));
    }
  const auto* found = std::find_if(std::begin(statistics), std::end(statistics),
                                   [&](const Statistic& s) { return !std::strcmp(s.name, name); });
  if (found == std::end(statistics)) {
    std::string known;
    for (std::int64_t i = 0; i < body_statistic_count(); ++i)
      known += (known.empty() ? "" : ", ") + std::string(body_statistic_name(i));
    fail(Status::err_option, "unknown statistic '%.64s'; statistics are: %s", name, known.c_str());
  }
  require_prepared(body);
  return body.response() ? found->value(body.response()->statistics()) : 0;
}

std::int64_t body_statistic_count() {
  return static_cast<std::int64_t>(std::size(statistics) + std::size(missed_loads) +
                                   std::size(origins));
}

const char* body_statistic_name(std::int64_t i) {
  auto k = static_cast<std::size_t>(i);
  if (k < std::size(statistics)) return statistics[k].name;
  k -= std::size(statistics);
  if (k < std::size(missed_loads)) return missed_loads[k].name;
  return origins[k - std::size(missed_loads)].name;
}

}  // namespace rollcon
