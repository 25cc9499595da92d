#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "support/extreme_bodies.hpp"
#include "support/frames.hpp"

namespace rollcon::extremes {
namespace {

using scenes::AnyBody;
using scenes::Elastic;

constexpr double young = 1e4;

Elastic elastic(double e, double poisson) {
  return {.shear = e / (2 * (1 + poisson)), .poisson = poisson};
}

const char* name_of(Model model) {
  return model == Model::fem ? "finite elements" : "boundary elements";
}

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.7g", value);
  return text;
}

/// Returns the material of a body.
std::optional<Elastic> material_of(const AnyBody& body) {
  if (const auto* half = std::get_if<scenes::HalfspaceBody>(&body)) return half->material;
  if (const auto* meshed = std::get_if<scenes::MeshedBody>(&body)) return meshed->material;
  return std::nullopt;
}

}  // namespace

Scene scene_on_block(const std::string& group, const std::string& name, const BlockShape& shape, AnyBody second,
                     const Press& press) {
  Scene s;
  s.group = group;
  s.name = name;
  s.given.rounding = 4096;
  scenes::MeshedBody block = make_block(shape);
  s.frame_body = 1;
  s.frame_tag = 6;
  s.given.frame = top_of(block, 1);
  s.given.regular = equal_cells(s.given.frame);
  const Elastic first = *block.material;
  const std::optional<Elastic> other = material_of(second);
  s.body1 = std::move(block);
  if (std::holds_alternative<scenes::MeshedBody>(second)) s.pose = turn_body_2;
  s.body2 = std::move(second);
  give_press(s, press, other ? closed_forms::effective_modulus(first, *other) : closed_forms::effective_modulus(first));
  s.right = {ROLLCON_OK};
  return s;
}

namespace {

void add_poisson(std::vector<Scene>& all) {
  for (const Model model : {Model::fem, Model::bem})
    for (const double nu : {-0.9, 0.0, 0.3, 0.49, 0.4999, 0.499999, 0.5}) {
      BlockShape shape{.model = model};
      shape.poisson = nu;
      Scene s = scene_on_block("Poisson's ratio", std::string(name_of(model)) + ", " + number(nu), shape,
                               scenes::HalfspaceBody{elastic(young, 0.3)});
      if (model == Model::fem && nu == 0.5) s.right = {ROLLCON_ERR_UNSUPPORTED};
      all.push_back(std::move(s));
    }
}

void add_stiffness(std::vector<Scene>& all) {
  for (const Model model : {Model::fem, Model::bem}) {
    for (const double ratio : {1e-12, 1e-6, 1.0, 1e6, 1e12}) {
      BlockShape shape{.model = model};
      all.push_back(scene_on_block("stiffness ratio",
                                   std::string(name_of(model)) + " on a half-space, " + number(ratio), shape,
                                   scenes::HalfspaceBody{elastic(ratio * young, 0.3)}));
      BlockShape other{.model = model == Model::fem ? Model::bem : Model::fem};
      other.half = {1.25, 1.25, 1};
      other.young = ratio * young;
      all.push_back(scene_on_block("stiffness ratio",
                                   std::string(name_of(model)) + " on another mesh, " + number(ratio), shape,
                                   make_block(other)));
    }
    for (const double modulus : {1e-6, 1e4, 1e15}) {
      BlockShape shape{.model = model};
      shape.young = modulus;
      all.push_back(scene_on_block("stiffness", std::string(name_of(model)) + ", " + number(modulus), shape,
                                   scenes::HalfspaceBody{elastic(modulus, 0.3)}));
    }
  }
}

void add_meshes(std::vector<Scene>& all) {
  const auto add = [&](const std::string& name, BlockShape shape, Press press = {}) {
    for (const Model model : {Model::fem, Model::bem}) {
      shape.model = model;
      all.push_back(
          scene_on_block("meshes", std::string(name_of(model)) + ", " + name, shape, scenes::RigidBody{}, press));
    }
  };
  BlockShape long_elements;
  long_elements.half = {1, 1000, 1};
  add("elements 1 : 1000 in plan", long_elements);
  BlockShape flat;
  flat.half = {1, 1, 1e-3};
  flat.n = {6, 6, 2};
  add("a glued layer 1 : 1000", flat, {.strain = 1e-4});
  BlockShape graded;
  for (std::size_t c = 0; c < 2; ++c) graded.line[c] = {-1, -0.3, -0.03, -1e-4, 0, 0.1, 0.4, 1};
  graded.line[2] = {-1, 0.5, 0.95, 1 - 1e-4, 1};
  add("sizes graded over 1e4", graded);
  for (const double apart : {1e-3, 1e-6}) {
    BlockShape near;
    near.line[0] = near.line[1] = {-1, -0.6, -0.2, 0.2, 0.2 + apart, 0.6, 1};
    add("nodes " + number(apart) + " apart", near);
  }
  BlockShape slivers{.face = ElementType::tri3, .cell = VolumeType::tet4};
  slivers.shear = {0, 0, 30};
  add("slivers", slivers);
  BlockShape random{.face = ElementType::tri3, .cell = VolumeType::tet4};
  random.distort = 0.3;
  add("random triangles and tetrahedra", random);
  BlockShape curved{.face = ElementType::quad9, .cell = VolumeType::hex20};
  curved.n = {4, 4, 2};
  curved.distort = 0.2;
  add("quadratic elements near folding", curved);
  BlockShape least;
  least.n = {2, 2, 1};
  add("18 nodes", least);
}

void add_contacts(std::vector<Scene>& all) {
  for (const Model model : {Model::fem, Model::bem}) {
    const BlockShape shape{.model = model};
    const auto add = [&](const std::string& name, const Press& press) -> Scene& {
      all.push_back(scene_on_block("contacts on bodies", std::string(name_of(model)) + ", " + name, shape,
                                   scenes::RigidBody{}, press));
      return all.back();
    };
    const auto by_array = [](Scene& s, auto gap) {
      s.given.quadratic.reset();
      for (const Vec3& x : s.given.frame.node) s.given.gap.push_back(gap(x));
    };
    by_array(add("flat on flat", {}), [](const Vec3&) { return 0.0; });
    by_array(add("at the body's rim", {}),
             [](const Vec3& x) { return 0.02 * ((x[0] - 1) * (x[0] - 1) + x[1] * x[1]); });
    by_array(add("at a corner", {}),
             [](const Vec3& x) { return 0.02 * ((x[0] - 1) * (x[0] - 1) + (x[1] - 1) * (x[1] - 1)); });
    by_array(add("two patches", {}),
             [](const Vec3& x) { return 0.08 * (std::pow(std::abs(x[0]) - 0.66, 2) + x[1] * x[1]); });
    for (const double factor : {1e-12, 1e-3, 1e3}) add("creepage times " + number(factor), {.creep = factor});
    add("spin alone", {}).creep(0, 0, 1e3);
    for (const double mu : {0.0, 1e-12, 1.0, 10.0}) add("friction " + number(mu), {.friction = mu});
    add("hardly touching", {.size = 1e-3}).right = {ROLLCON_OK, ROLLCON_COARSE};
    Scene& away = add("apart", {});
    away.approach(-1e-3).right = {ROLLCON_NO_CONTACT};
    for (const double part : {0.9, 0.999, 0.999999}) {
      Scene& s = add("force " + number(part) + " of friction", {});
      s.force(ROLLCON_LONGITUDINAL, part * 0.3 * s.given.value[ROLLCON_NORMAL - 1]);
    }
    Scene& s = add("force beyond friction", {});
    s.force(ROLLCON_LATERAL, 0.31 * s.given.value[ROLLCON_NORMAL - 1]).right = {ROLLCON_ERR_LOAD};
  }
}

}  // namespace

std::vector<Scene> named_body_scenes() {
  std::vector<Scene> all;
  add_poisson(all);
  add_stiffness(all);
  add_meshes(all);
  add_contacts(all);
  for (Scene& s : conformal_scenes()) all.push_back(std::move(s));
  // Contact that reaches the edge of a body is said to reach the rim where the frame ends there.
  for (Scene& s : all)
    if (s.right.front() == ROLLCON_OK) s.right.push_back(ROLLCON_RIM_CONTACT);
  return all;
}

}  // namespace rollcon::extremes
