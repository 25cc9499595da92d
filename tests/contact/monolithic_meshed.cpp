#include "bodies/body.hpp"
#include "bodies/pair.hpp"
#include "contact/monolithic_case.hpp"
#include "contact/scene/geometry.hpp"
#include "support/frames.hpp"
#include "support/static_solution.hpp"

namespace rollcon::monolithic_test {
namespace {

constexpr double poisson = 0.3;

struct Made {
  std::shared_ptr<Body> body;
  std::shared_ptr<const void> owner;
  SurfaceMesh mesh;
};

Made make_body(const MeshedPair& pair, int which, std::shared_ptr<Context> context) {
  const double young = pair.stress * (which == 0 ? 1 : 1.7);
  const Model model = pair.model[which];
  Made made;
  if (model == Model::halfspace || model == Model::rigid) {
    const BodyKind kind = model == Model::rigid ? BodyKind::rigid : BodyKind::halfspace;
    made.body = std::make_shared<Body>(context, static_cast<std::int32_t>(kind));
    if (model == Model::halfspace) made.body->set_elastic(0, young, poisson);
    made.body->prepare();
    return made;
  }
  const surfaces::ZoneBlock shape{
      .side = 5, .depth = 3, .zone = 2, .n = pair.n, .grade = pair.grade, .deep = pair.deep};
  const auto map = [&](const Vec3& x) {
    const double across = pair.curved ? -0.08 * x[1] * x[1] * (1 + x[2] / 3) : 0;
    return pair.length * Vec3{x[0], x[1], x[2] + across};
  };
  std::shared_ptr<statics::StaticBody> body;
  if (model == Model::fem)
    body = std::make_shared<statics::StaticBody>(volumes::transform(volumes::zone_block(shape, VolumeType::hex8), map),
                                                 young, poisson);
  else
    body = std::make_shared<statics::StaticBody>(
        surfaces::transform(surfaces::zone_block(shape, ElementType::quad4), map), young, poisson);
  const std::int32_t top[] = {1, 2};
  body->body().set_contact_faces(2, top);
  body->hold_tags({3});
  body->body().prepare();
  made.mesh = body->mesh();
  made.owner = body;
  made.body = {body, &body->body()};
  return made;
}

std::string name_of(Model model) {
  return model == Model::fem ? "FEM" : model == Model::bem ? "BEM" : model == Model::halfspace ? "half-space" : "rigid";
}

}  // namespace

Case meshed(const MeshedPair& pair, Scheme scheme, const Motions& motions) {
  auto context = std::make_shared<Context>();
  const Made one = make_body(pair, 0, context), two = make_body(pair, 1, context);
  PairOfBodies bodies;
  bodies.body = {one.body.get(), two.body.get()};
  if (two.owner) bodies.pose[1].rotation = {{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}}};
  SurfaceMesh mesh;
  if (pair.own_frame || !one.owner) {
    const auto lines = frames::uniform_lines(-0.9 * pair.length, 0.9 * pair.length, pair.n + 1);
    mesh = frames::rectangle(ElementType::quad4, lines, lines);
  } else {
    std::vector<std::int32_t> node;
    mesh = surfaces::part_of(one.mesh, surfaces::elements_with_tag(one.mesh, 2), node);
  }
  auto frame = std::make_shared<Frame>(build_frame(std::move(mesh), Axes{}));
  if (one.owner) curve_frame(*frame, surface_normals(*frame, {}, bodies));
  std::shared_ptr<const Compliance> compliance = make_pair_compliance(*frame, bodies, 1e-6, 2);
  Case c = make_case(name_of(pair.model[0]) + "-" + name_of(pair.model[1]) + (pair.curved ? ", curved" : "") +
                         (pair.own_frame ? ", own frame" : ""),
                     frame, compliance, scheme, motions, pair.length, pair.stress, pair.n <= 8);
  c.keep.insert(c.keep.end(), {context, one.body, two.body, one.owner, two.owner});
  return c;
}

}  // namespace rollcon::monolithic_test
