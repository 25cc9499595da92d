#include "contact/prepare/reach.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "contact/newton/start.hpp"
#include "contact/prepare/preparation.hpp"

namespace rollcon {
namespace {

// Beyond the guessed edge of the contact, in gap: the proof holds from 1.37 of a Hertzian contact.
constexpr double first_margin = 1.6, next_margin = 1.5;
constexpr double more = 1.15;             // room for what comes next when rows are added
constexpr std::int64_t most_batches = 4;  // then all rows: the contact wanders
constexpr double worth_while = 0.1;       // of the nodes left out, else all rows at once
constexpr std::int64_t fewest = 200;      // nodes of a frame: on smaller ones rows cost nothing
constexpr const char* wanders = "the contact wanders";
// Bound of |ck| / cn: (1 - 2 nu) / (2 (1 - nu)) for nu > -1.
constexpr double greatest_coupling = 0.75;

double gap_at(const Problem& p, std::size_t k) {
  return p.gap[k] / p.closing(k);
}

// Tractions interpolated from values of one sign must keep it.
bool linear_elements(const SurfaceMesh& mesh) {
  return std::all_of(mesh.type.begin(), mesh.type.end(),
                     [](ElementType t) { return t == ElementType::tri3 || t == ElementType::quad4; });
}

double greatest_friction(const SolverState& s) {
  return s.given.friction * *std::max_element(s.prepared->problem.mu.begin(), s.prepared->problem.mu.end());
}

// Part of the normal displacements by pressures that coupling cannot take away.
double sure_part(const SolverState& s) {
  const double coupled = s.prepared->compliance->couples() ? greatest_coupling * greatest_friction(s) : 0;
  return (1 - coupled) * (1 - 10 * s.prepared->accuracy);
}

const char* reason_against(const SolverState& s, const Options& o) {
  if (o.reach == 0) return "option reach is 0";
  if (!s.prepared->problem.op->dense()) return "nothing is assembled";
  if (s.prepared->table) return "rows are copied from a table";
  if (!s.procedure.standard()) return "the published procedures work on all nodes";
  if (s.prepared->problem.nodes < fewest) return "the frame is small";
  for (const Body* body : s.prepared->pair.body)
    if (body->kind() != BodyKind::halfspace && !body->rigid())
      return "pressure on a body with a mesh may pull its surface outwards elsewhere";
  if (s.prepared->frame.curved()) return "the frame is curved";
  if (!(sure_part(s) > 0)) return "coupling and friction are strong: no bound";
  if (!linear_elements(s.prepared->frame.mesh)) return "shape functions of quadratic elements change sign";
  return nullptr;
}

void find_radius(SolverState& s) {
  const Frame& frame = s.prepared->frame;
  std::vector<double>& radius = s.reach.radius;
  radius.assign(frame.x.size(), 0.0);
  for (std::int64_t e = 0; e < frame.elements(); ++e)
    for (const std::int32_t a : frame.mesh.element(e))
      for (const std::int32_t b : frame.mesh.element(e)) {
        const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
        radius[i] = std::max(radius[i], std::hypot(frame.x[i] - frame.x[j], frame.y[i] - frame.y[j]));
      }
}

double least_gap(const SolverState& s) {
  double low = INFINITY;
  for (std::size_t k = 0; k < s.prepared->problem.gap.size(); ++k)
    if (s.prepared->frame.used[k]) low = std::min(low, gap_at(s.prepared->problem, k));
  return low;
}

// Gap up to which nodes are taken to be within reach.
double level_of(const SolverState& s, double low) {
  const Problem& p = s.prepared->problem;
  const Reach& r = s.reach;
  if (!r.known) {
    const GuessedContact guess = guess_contact(p, s.given);
    return low + first_margin * std::max(guess.half, 0.0);
  }
  const double ratio = s.given.by_force[approach] ? s.given.value[approach] / r.load
                                                  : (s.given.value[approach] - low) / (r.depth - r.low);
  return low + next_margin * (r.edge - r.low) * std::max(ratio, 0.0);
}

// The solution's load, edge and approach, for the next choice.
void remember(SolverState& s) {
  const Problem& p = s.prepared->problem;
  Reach& r = s.reach;
  r.known = false;
  r.low = INFINITY;
  r.edge = -INFINITY;
  r.load = 0;
  for (std::size_t k = 0; k < p.gap.size(); ++k) {
    if (!p.used[k]) continue;
    r.low = std::min(r.low, gap_at(p, k));
    if (!(s.iterate.lambda[2][k] < 0)) continue;
    r.edge = std::max(r.edge, gap_at(p, k));
    r.load -= p.weight[k] * s.iterate.lambda[2][k];
  }
  r.depth = s.iterate.motion[approach];
  r.known = r.load > 0 && r.depth > r.low && r.edge > r.low;
}

}  // namespace

void choose_reach(SolverState& s, const Options& options) {
  const Problem& p = s.prepared->problem;
  Reach& r = s.reach;
  const bool first = !p.op->normal;
  if (first) r = {};
  r.returned = 0;
  r.wanted.clear();
  r.why_not = reason_against(s, options);
  if (r.why_not) {
    take_reach(s);
    return;
  }
  if (!first && p.op->rows == p.nodes) {
    r.why_not = r.why_all ? r.why_all : "all rows are there";
    return;
  }
  if (first) find_radius(s);
  const double low = least_gap(s), level = level_of(s, low);
  r.wanted.assign(p.gap.size(), 0);
  bool missing = false;
  const auto mark = [&](double up_to) {
    std::int64_t count = 0;
    for (std::size_t k = 0; k < r.wanted.size(); ++k) {
      bool in = !(gap_at(p, k) > up_to);
      for (const auto& lambda : s.iterate.lambda) in = in || lambda[k] != 0;
      r.wanted[k] = in;
      missing = missing || (in && !(p.op->normal && p.op->has_row(k)));
      count += in || (p.op->normal && p.op->has_row(k));
    }
    return count;
  };
  std::int64_t count = mark(level);
  if (!missing) return;
  if (!first) {
    ++r.batches;
    count = mark(low + more * (level - low));
  }
  const auto left_out = static_cast<double>(p.nodes - count);
  if (r.batches >= most_batches || left_out < worth_while * static_cast<double>(p.nodes)) {
    r.wanted.clear();
    r.why_not = r.why_all = r.batches >= most_batches ? wanders : "nearly all nodes are in reach";
  }
}

void take_reach(SolverState& s) {
  Problem& p = s.preparation->made->problem;
  Reach& r = s.reach;
  r.on = !r.why_not && p.op->normal && p.op->rows < p.nodes;
  r.nodes = 0;
  for (std::size_t k = 0; k < p.used.size(); ++k) {
    p.used[k] = s.prepared->frame.used[k] && (!r.on || p.op->has_row(k));
    r.nodes += p.used[k];
  }
}

// Pressures p >= 0 part the surfaces of half-spaces: by at least cn F / |x - y| on average over the loaded points y,
// and no less than cn F / sqrt(mean |x - y|^2). Friction takes away no more than
// |ck| mu of it.
std::int64_t find_doubtful(SolverState& s) {
  const Problem& p = s.prepared->problem;
  Reach& r = s.reach;
  double force = 0, mx = 0, my = 0, spread = 0;
  for (std::size_t k = 0; k < p.gap.size(); ++k) {
    const double pressure = -s.iterate.lambda[2][k];
    if (!(pressure > 0)) continue;
    force += pressure * p.weight[k];
    mx += pressure * p.moment_x[k];
    my += pressure * p.moment_y[k];
  }
  const double x = force > 0 ? mx / force : 0, y = force > 0 ? my / force : 0;
  for (std::size_t k = 0; k < p.gap.size(); ++k) {
    const double pressure = -s.iterate.lambda[2][k];
    if (!(pressure > 0)) continue;
    const double distance = std::hypot(s.prepared->frame.x[k] - x, s.prepared->frame.y[k] - y) + r.radius[k];
    spread += pressure * p.weight[k] * distance * distance / force;
  }
  const double sure = sure_part(s) * force / (std::numbers::pi * p.stiffness);
  const double depth = s.iterate.motion[approach];
  r.wanted.assign(p.gap.size(), 0);
  std::int64_t doubtful = 0;
  for (std::size_t k = 0; k < p.gap.size(); ++k) {
    if (!s.prepared->frame.used[k] || p.op->has_row(k)) continue;
    const double dx = s.prepared->frame.x[k] - x, dy = s.prepared->frame.y[k] - y;
    const double apart = force > 0 ? sure / std::sqrt(dx * dx + dy * dy + spread) : 0;
    if (p.rigid_gap(k, depth) + apart > 0) continue;
    r.wanted[k] = 1;
    ++doubtful;
  }
  return doubtful;
}

bool bring_back(SolverState& s, const Options& options) {
  Reach& r = s.reach;
  const Problem& p = s.prepared->problem;
  if (!r.on) return false;
  if (find_doubtful(s) == 0) {
    remember(s);
    return false;
  }
  if (!s.preparation) {
    r.doubtful = true;
    return false;
  }
  // With them comes what lies no higher.
  const double low = least_gap(s);
  double level = low;
  for (std::size_t k = 0; k < r.wanted.size(); ++k)
    if (r.wanted[k]) level = std::max(level, gap_at(p, k));
  level = low + more * (level - low);
  ++r.batches;
  const std::vector<std::uint8_t> before = p.op->there;
  for (std::size_t k = 0; k < r.wanted.size(); ++k) r.wanted[k] = r.batches >= most_batches || !(gap_at(p, k) > level);
  if (r.batches >= most_batches) r.why_all = wanders;
  require_rows(s, options, r.wanted);
  bool open = true;
  for (std::size_t k = 0; k < before.size(); ++k) {
    if (before[k] || !p.used[k]) continue;
    ++r.returned;
    s.iterate.update_gap(p, static_cast<std::int64_t>(k));
    open = open && p.rigid_gap(k, s.iterate.motion[approach]) - s.iterate.image[2][k] > 0;
  }
  if (open) remember(s);
  return !open;
}

}  // namespace rollcon
