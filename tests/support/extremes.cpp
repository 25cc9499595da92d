#include "support/extremes.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

namespace rollcon::extremes {

Scene& Scene::motion(std::int32_t direction, double value) {
  given.by_force[static_cast<std::size_t>(direction) - 1] = false;
  given.value[static_cast<std::size_t>(direction) - 1] = value;
  return *this;
}

Scene& Scene::force(std::int32_t direction, double value) {
  given.by_force[static_cast<std::size_t>(direction) - 1] = true;
  given.value[static_cast<std::size_t>(direction) - 1] = value;
  return *this;
}

Scene& Scene::creep(double longitudinal, double lateral, double spin) {
  return motion(ROLLCON_LONGITUDINAL, longitudinal).motion(ROLLCON_LATERAL, lateral).motion(ROLLCON_SPIN, spin);
}

Scene& Scene::friction(double mu) {
  given.friction = {mu};
  return *this;
}

Scene& Scene::scheme(laws::Scheme scheme) {
  given.scheme = scheme;
  return *this;
}

Scene& Scene::set(const std::string& which, Setting value) {
  option.emplace_back(which, std::move(value));
  return *this;
}

const char* name_of(laws::Scheme scheme) {
  switch (scheme) {
    case laws::Scheme::godunov:
      return "godunov";
    case laws::Scheme::least_squares:
      return "least_squares";
    default:
      return "characteristic";
  }
}

std::unique_ptr<scenes::RollingPair> make_pair(const Scene& scene, int threads) {
  return std::make_unique<scenes::RollingPair>(scene.body1, scene.body2, threads);
}

void give_loads(scenes::RollingPair& pair, const Scene& scene) {
  const laws::Given& g = scene.given;
  const auto must = [](std::int32_t status, const char* what) {
    if (status < 0) throw std::runtime_error(std::string(what) + ": " + rollcon_status_string(status));
  };
  pair.axes(g.origin, g.rolling, g.normal).speed(g.speed);
  if (g.quadratic)
    pair.gap_quadratic((*g.quadratic)[0], (*g.quadratic)[1], (*g.quadratic)[2]);
  else if (!g.gap.empty())
    pair.gap(g.gap);
  pair.creep(g.value[0], g.value[1], g.value[3]);
  if (!g.by_force[2]) pair.approach(g.value[2]);
  for (std::int32_t d = 1; d <= 4; ++d) {
    const auto i = static_cast<std::size_t>(d) - 1;
    if (g.by_force[i]) pair.tangential_force(d, g.value[i]);
  }
  pair.creep_field(g.creep_field);
  const bool field = g.friction.size() != 1;
  if (!g.law.coulomb())
    must(rollcon_contact_set_friction(pair.handle(), g.law.name.c_str(),
                                      static_cast<std::int32_t>(g.law.parameter.size()), g.law.parameter.data()),
         "set_friction");
  else if (!field)
    pair.friction(g.friction[0]);
  must(rollcon_contact_set_friction_field(pair.handle(), field ? static_cast<std::int64_t>(g.friction.size()) : 0,
                                          g.friction.data()),
       "set_friction_field");
  pair.option("convection", name_of(g.scheme));
  for (const std::pair<std::string, Setting>& option : scene.option)
    std::visit(
        [&](const auto& v) {
          if constexpr (std::is_same_v<std::decay_t<decltype(v)>, std::string>)
            pair.option(option.first.c_str(), v.c_str());
          else
            pair.option(option.first.c_str(), v);
        },
        option.second);
}

void give_scene(scenes::RollingPair& pair, const Scene& scene) {
  if (scene.frame_body > 0)
    pair.frame_from_body(scene.frame_body, scene.frame_tag);
  else
    pair.frame(scene.given.frame);
  if (scene.pose) scene.pose(pair);
  give_loads(pair, scene);
}

bool Scene::is_right(std::int32_t status) const {
  const auto has = [&](std::int32_t s) { return std::count(right.begin(), right.end(), s) > 0; };
  return has(status) || (status == ROLLCON_COARSE && has(ROLLCON_OK));
}

bool Ending::solved() const {
  return status == ROLLCON_OK || status == ROLLCON_RIM_CONTACT || status == ROLLCON_COARSE ||
         status == ROLLCON_NO_CONTACT || status == ROLLCON_INACCURATE || status == ROLLCON_TOO_DEEP;
}

Ending solve(scenes::RollingPair& pair, const Scene& scene, bool condition, std::size_t most_nodes) {
  Ending e;
  e.nodes = static_cast<double>(scene.given.frame.nodes());
  const auto began = std::chrono::steady_clock::now();
  e.status = rollcon_contact_solve(pair.handle());
  e.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  if (e.status < 0) {
    try {
      pair.solve();  // once more, for its text
      e.message = "refused once and then not";
    } catch (const std::exception& error) {
      e.message = error.what();
    }
    return e;
  }
  e.iterations = pair.stat("iterations");
  e.fallbacks = pair.stat("fallbacks");
  e.residual = std::max(pair.stat("residual_normal"), pair.stat("residual_tangential"));
  e.law = laws::check(pair.handle(), scene.given, most_nodes);
  if (condition) (void)rollcon_contact_get_stat(pair.handle(), "condition", &e.condition);
  e.traction.resize(static_cast<std::size_t>(3 * scene.given.frame.nodes()));
  (void)rollcon_contact_get_tractions(pair.handle(), ROLLCON_LOCAL, scene.given.frame.nodes(), e.traction.data());
  return e;
}

Scene disturbed(const Scene& scene, int way) {
  Scene other = scene;
  other.right = {};
  laws::Given& g = other.given;
  double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
  for (const Vec3& x : g.frame.node)
    for (std::size_t c = 0; c < 2; ++c) low[c] = std::min(low[c], x[c]), high[c] = std::max(high[c], x[c]);
  const double width = std::max(high[0] - low[0], high[1] - low[1]);
  const auto away = [](double value, double factor, double else_this) {
    return value != 0 && std::abs(value) < 1 ? factor * value : else_this;
  };
  double& normal = g.value[ROLLCON_NORMAL - 1];
  const auto before = g.value;
  const bool tangential_forces = g.by_force[0] || g.by_force[1] || g.by_force[3];
  g.creep_field.clear();
  switch (way) {
    case 0:
      normal *= 3;
      other.friction(3);
      other.creep(away(tangential_forces ? 0 : before[0], -1e3, 0.1),
                  away(tangential_forces ? 0 : before[1], -1e3, -0.2), 0);
      break;
    case 1:
      normal *= 1e-3;
      other.friction(1e-3);
      other.creep(0, 0, 5 / width);
      break;
    default: {
      if (!g.gap.empty() || g.quadratic) {
        std::vector<double> h = g.gap;
        for (const Vec3& x : g.frame.node) {
          if (g.gap.empty())
            h.push_back((*g.quadratic)[0] * x[0] * x[0] + (*g.quadratic)[1] * x[1] * x[1] +
                        (*g.quadratic)[2] * x[0] * x[1]);
        }
        const auto [least, most] = std::minmax_element(h.begin(), h.end());
        const double slope = 0.2 * (*most - *least) / width, lowest = *least;
        for (std::size_t k = 0; k < h.size(); ++k)
          h[k] = lowest + (h[k] - lowest) + slope * (g.frame.node[k][0] - low[0]);
        g.gap = h;
        g.quadratic.reset();
      }
      other.friction(0.3);
      other.creep(1e-6, 2e-6, 0);
    }
  }
  return other;
}

double traction_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double worst[2] = {}, scale[2] = {};
  if (a.size() != b.size()) return INFINITY;
  for (std::size_t k = 0; k + 2 < b.size(); k += 3) {
    worst[0] = std::max(worst[0], std::abs(a[k + 2] - b[k + 2]));
    scale[0] = std::max(scale[0], std::abs(b[k + 2]));
    worst[1] = std::max(worst[1], std::hypot(a[k] - b[k], a[k + 1] - b[k + 1]));
    scale[1] = std::max(scale[1], std::hypot(b[k], b[k + 1]));
  }
  if (scale[1] == 0) scale[1] = scale[0];
  double difference = 0;
  for (std::size_t i = 0; i < 2; ++i)
    if (worst[i] > 0) difference = std::max(difference, scale[i] > 0 ? worst[i] / scale[i] : INFINITY);
  return difference;
}

double load_over_friction(const Scene& scene) {
  const laws::Given& g = scene.given;
  const auto wanted = [&](std::int32_t d) {
    const auto i = static_cast<std::size_t>(d) - 1;
    return g.by_force[i] ? g.value[i] : 0;
  };
  const double f1 = wanted(ROLLCON_LONGITUDINAL), f2 = wanted(ROLLCON_LATERAL);
  const double force = std::hypot(f1, f2), moment = wanted(ROLLCON_SPIN);
  double low = INFINITY, high = -INFINITY;
  for (const Vec3& x : g.frame.node) low = std::min(low, x[0]), high = std::max(high, x[0]);
  constexpr double fast = 1e6;  // fast enough that every node slides that way
  Scene sliding = scene;
  if (force > 0) sliding.motion(ROLLCON_LONGITUDINAL, -fast * f1 / force).motion(ROLLCON_LATERAL, -fast * f2 / force);
  if (g.by_force[ROLLCON_SPIN - 1])
    sliding.motion(ROLLCON_SPIN, moment == 0 || force > 0 ? 0
                                 : moment > 0             ? -fast / (high - low)
                                                          : fast / (high - low));
  const auto pair = make_pair(sliding);
  give_scene(*pair, sliding);
  const std::int32_t status = rollcon_contact_solve(pair->handle());
  if (status < 0 || status == ROLLCON_NOT_CONVERGED) return NAN;
  const scenes::Solution s = pair->solution();
  const auto over = [](double value, double limit) { return value == 0 ? 0 : limit > 0 ? value / limit : INFINITY; };
  if (force > 0) return over(force, (s.force[0] * f1 + s.force[1] * f2) / force);
  return over(std::abs(moment), moment > 0 ? s.moment[2] : -s.moment[2]);
}

std::string describe(const Scene& scene) {
  const auto body = [](const scenes::AnyBody& any) -> std::string {
    char text[64];
    if (const auto* half = std::get_if<scenes::HalfspaceBody>(&any)) {
      std::snprintf(text, sizeof text, "E %.3g nu %.7g", half->material.young(), half->material.poisson);
      return text;
    }
    if (std::holds_alternative<scenes::RigidBody>(any)) return "rigid";
    return std::holds_alternative<scenes::TwinBody>(any) ? "twin" : "meshed";
  };
  const laws::Given& g = scene.given;
  const auto [low, high] = std::minmax_element(g.friction.begin(), g.friction.end());
  std::string s = body(scene.body1) + " | " + body(scene.body2);
  char text[400];
  std::snprintf(text, sizeof text, " | %lld nodes, %lld elements (%d) | mu %.3g..%.3g | %s",
                static_cast<long long>(g.frame.nodes()), static_cast<long long>(g.frame.elements()),
                g.frame.type.empty() ? 0 : static_cast<int>(g.frame.type[0]), *low, *high, name_of(g.scheme));
  s += text;
  constexpr const char* names[] = {"longitudinal", "lateral", "normal", "spin"};
  for (std::size_t d = 0; d < 4; ++d) {
    std::snprintf(text, sizeof text, " | %s%s %.4g", names[d], g.by_force[d] ? " force" : "", g.value[d]);
    s += text;
  }
  for (const auto& [name, value] : scene.option) {
    s += " | " + name + " ";
    if (const auto* word = std::get_if<std::string>(&value)) s += *word;
    if (const auto* real = std::get_if<double>(&value)) std::snprintf(text, sizeof text, "%.3g", *real), s += text;
    if (const auto* integer = std::get_if<std::int64_t>(&value)) s += std::to_string(*integer);
  }
  return s;
}

}  // namespace rollcon::extremes
