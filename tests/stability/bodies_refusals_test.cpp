/// Tests what the library says of bodies that it cannot answer for: refusals with value, range and remedy, and warnings
/// where digits are lost.

#include <initializer_list>

#include "support/extreme_bodies.hpp"
#include "support/frames.hpp"
#include "support/testing.hpp"

namespace rollcon {
namespace {

using extremes::BlockShape;
using extremes::make_block;
using extremes::Model;

/// Holds a context that remembers what it is told, with a body in it.
class Told {
 public:
  explicit Told(const scenes::MeshedBody& body) {
    rollcon_context_create(rollcon_abi(), &context_);
    rollcon_context_set_log(
        context_, ROLLCON_LOG_WARNING,
        [](std::int32_t, const char* text, void* to) {
          const std::string line = text;
          // Contacts of few nodes are reported, too, which does not concern these tests.
          if (line.find("too few nodes in contact") == std::string::npos) *static_cast<std::string*>(to) += line + "\n";
        },
        &text_);
    body_ = scenes::make_body(context_, body);
  }
  ~Told() {
    rollcon_body_release(body_);
    rollcon_context_release(context_);
  }
  Told(const Told&) = delete;
  Told& operator=(const Told&) = delete;

  rollcon_body* body() { return body_; }
  std::int32_t prepare() { return rollcon_body_prepare(body_); }
  struct Press {
    double approach = 1e-3, lateral = 0, friction = 0.3;
  };
  /// Presses a rigid ball into the body, which rolls with a lateral creepage.
  std::int32_t press(const SurfaceMesh* frame, const Press& how = {1e-3, 0, 0.3}) {
    rollcon_body* ball = nullptr;
    rollcon_contact* contact = nullptr;
    EXPECT_EQ(rollcon_body_create(context_, ROLLCON_BODY_RIGID, &ball), ROLLCON_OK);
    EXPECT_EQ(rollcon_contact_create(context_, body_, ball, &contact), ROLLCON_OK);
    if (frame) {
      rollcon_contact_frame_nodes(contact, frame->nodes(), frame->node[0].data(), 3, 1);
      rollcon_contact_frame_add_elements(contact, ROLLCON_QUAD4, frame->elements(), frame->connectivity.data(), 0, 0);
    } else {
      rollcon_contact_frame_from_body(contact, 1, 6);
    }
    rollcon_contact_set_gap_quadratic(contact, 0.01, 0.01, 0);
    rollcon_contact_set_friction(contact, "coulomb", 1, &how.friction);
    rollcon_contact_prescribe(contact, ROLLCON_NORMAL, ROLLCON_BY_MOTION, how.approach);
    rollcon_contact_set_creep(contact, 0, how.lateral, 0);
    const std::int32_t status = rollcon_contact_solve(contact);
    rollcon_contact_release(contact);
    rollcon_body_release(ball);
    return status;
  }
  void expect(std::initializer_list<const char*> words) const {
    for (const char* word : words)
      EXPECT_NE(text_.find(word), std::string::npos) << "'" << word << "' is not in: " << text_;
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  rollcon_context* context_ = nullptr;
  rollcon_body* body_ = nullptr;
};

TEST(stability_bodies, limits_of_poisson_are_named_with_the_remedy) {
  struct Limit {
    VolumeType cell;
    double poisson;
    std::initializer_list<const char*> words;
  };
  for (const auto& [cell, poisson, words] :
       {Limit{VolumeType::hex8, 0.5, {"poisson 0.5;", "0.4999999", "boundary-element"}},
        Limit{VolumeType::tet10, 0.49999999, {"0.49999999", "0.4999999", "boundary-element"}},
        Limit{VolumeType::tet4, 0.49, {"poisson 0.49;", "0.45", "tet10"}},
        Limit{VolumeType::wedge6, 0.4999999, {"0.4999999;", "0.45", "wedge15"}}}) {
    BlockShape shape{.model = Model::fem};
    shape.cell = cell;
    shape.poisson = poisson;
    Told told(make_block(shape));
    EXPECT_EQ(told.prepare(), ROLLCON_ERR_UNSUPPORTED);
    told.expect(words);
  }
  scenes::MeshedBody shell = scenes::meshed(surfaces::with_cavity(surfaces::cube_sphere(ElementType::quad4, 3, 2, 1),
                                                                  surfaces::cube_sphere(ElementType::quad4, 3, 1, 2)),
                                            {.shear = 1, .poisson = 0.4999999});
  shell.held_tag = {1};
  Told told(shell);
  EXPECT_EQ(told.prepare(), ROLLCON_ERR_UNSUPPORTED);
  told.expect({"0.4999999", "0.49,", "held cavity"});
}

TEST(stability_bodies, lost_digits_are_told) {
  // The soft base lies under a cover 1e12 times as stiff.
  scenes::MeshedBody body = make_block({.model = Model::fem});
  for (std::int64_t e = 0; e < body.volume.elements(); ++e) {
    double height = 0;
    for (const std::int32_t k : body.volume.element(e)) height += body.mesh.node[static_cast<std::size_t>(k)][2] / 8;
    body.volume.tag[static_cast<std::size_t>(e)] = height > -0.3 ? 2 : 1;
  }
  for (const double ratio : {1e6, 1e12}) {
    Told told(body);
    rollcon_body_set_elastic(told.body(), 1, 1, 0.3);
    rollcon_body_set_elastic(told.body(), 2, ratio, 0.3);
    EXPECT_EQ(told.prepare(), ROLLCON_OK) << told.text();
    double condition = 0;
    rollcon_body_get_stat(told.body(), "condition", &condition);
    EXPECT_GT(condition, ratio);
    if (ratio < 1e7)
      EXPECT_EQ(told.text(), "");
    else
      told.expect({"condition", "moduli"});
  }
}

// A plate held at one edge bends too softly beside its elements' own stiffness, the more so the nearer Poisson's ratio
// is to 1/2.
TEST(stability_bodies, plates_that_bend_beyond_rounding_are_refused) {
  BlockShape plate{.model = Model::fem, .cell = VolumeType::hex20};
  plate.half = {1.2, 1.2, 0.0026};
  plate.n = {3, 3, 2};
  plate.poisson = 0.4999;
  plate.held = {1};
  Told told(make_block(plate));
  EXPECT_EQ(told.prepare(), ROLLCON_ERR_SINGULAR);
  told.expect({"check its supports", "times as long as thick", "poisson up to 0.4999", "hold it along its length",
               "thicker", "further from 0.5"});
  // The remedies in the message help.
  BlockShape glued = plate, thick = plate, compressible = plate, ends = plate;
  glued.held = {5};
  thick.half[2] = 0.05;
  compressible.poisson = 0.3;
  ends.held = {1, 2};
  for (const BlockShape& shape : {glued, thick, compressible, ends})
    EXPECT_EQ(Told(make_block(shape)).prepare(), ROLLCON_OK);
  // Other causes are not put down to thinness.
  thick.held = {};
  Told loose(make_block(thick));
  EXPECT_NE(loose.prepare(), ROLLCON_OK);
  EXPECT_EQ(loose.text().find("as long as thick"), std::string::npos) << loose.text();
}

TEST(stability_bodies, thin_bodies_are_told) {
  // The plate can bend; its elements are 17 times as long as it is thick.
  BlockShape plate;
  plate.half = {1, 1, 0.02};
  plate.n = {6, 6, 1};
  plate.held = {1, 2, 3, 4};
  for (const Model model : {Model::fem, Model::bem}) {
    plate.model = model;
    Told told(make_block(plate));
    EXPECT_EQ(told.prepare(), ROLLCON_OK);
    told.expect({"long beside its thickness", "too stiff"});
  }
  // A glued layer lies under a finer frame; its own faces are good.
  BlockShape layer = plate;
  layer.held = {5};
  const auto lines = frames::uniform_lines(-0.8, 0.8, 12);
  const SurfaceMesh fine = frames::rectangle(ElementType::quad4, lines, lines);
  for (const Model model : {Model::fem, Model::bem}) {
    layer.model = model;
    Told told(make_block(layer));
    EXPECT_EQ(told.prepare(), ROLLCON_OK);
    EXPECT_GE(told.press(nullptr), 0);
    EXPECT_EQ(told.text(), "");
    EXPECT_GE(told.press(&fine), 0);
    told.expect({"times as thick as its faces are long", "half-space is too soft"});
  }
  // The block is thick enough, so nothing is told.
  Told block(make_block({.model = Model::bem}));
  EXPECT_GE(block.press(nullptr), 0);
  EXPECT_GE(block.press(&fine), 0);
  EXPECT_EQ(block.text(), "");
}

// A tall block of few faces, three times as long as it is thick, is pushed sideways.
TEST(stability_bodies, bending_of_boundary_elements_that_are_too_long_is_told_where_forces_bend) {
  BlockShape tall{.model = Model::bem};
  tall.half = {1, 1, 12};
  tall.n = {2, 2, 4};
  Told told(make_block(tall));
  EXPECT_GE(told.press(nullptr), 0) << told.text();
  EXPECT_EQ(told.text().find("axis y bends it"), std::string::npos) << told.text();
  EXPECT_GE(told.press(nullptr, {1e-3, 1}), 0) << told.text();
  told.expect({"body 1: a force along its axis y bends it", "too long for its thickness", "quadratic ones"});
  double imbalance = 0, along[3] = {}, pressure = 0, loads = 1;
  rollcon_body_get_stat(told.body(), "imbalance", &imbalance);
  rollcon_body_get_stat(told.body(), "imbalance_x", &along[0]);
  rollcon_body_get_stat(told.body(), "imbalance_y", &along[1]);
  rollcon_body_get_stat(told.body(), "imbalance_z", &along[2]);
  rollcon_body_get_stat(told.body(), "imbalance_pressure", &pressure);
  rollcon_body_get_stat(told.body(), "imbalance_loads", &loads);
  std::printf("missed: x %.3g, y %.3g, z %.3g, pressure %.3g\n", along[0], along[1], along[2], pressure);
  EXPECT_EQ(imbalance, std::max(along[0], along[1]));
  EXPECT_LT(std::max(along[2], pressure), 0.1);
  EXPECT_EQ(loads, 0);
  BlockShape wide{.model = Model::bem};
  Told good(make_block(wide));
  EXPECT_GE(good.press(nullptr, {1e-3, 1}), 0);
  EXPECT_EQ(good.text(), "");
}

// The contact is 0.75 wide and the block 1 deep.
TEST(stability_bodies, volume_elements_too_deep_for_the_contact_are_told) {
  struct Case {
    VolumeType cell;
    int layers;
    double friction;
    bool told;
  };
  for (const auto& [cell, layers, friction, deep] :
       {Case{VolumeType::hex8, 1, 0.3, true}, Case{VolumeType::hex8, 3, 0.3, true},
        Case{VolumeType::hex8, 8, 0.3, false}, Case{VolumeType::hex8, 2, 0, true}, Case{VolumeType::hex8, 4, 0, false},
        Case{VolumeType::hex20, 1, 0.3, true}, Case{VolumeType::hex20, 2, 0.3, false}}) {
    BlockShape block{.model = Model::fem, .cell = cell};
    block.n = {16, 16, layers};
    Told told(make_block(block));
    EXPECT_EQ(told.press(nullptr, {3e-3, 0, friction}), deep ? ROLLCON_INACCURATE : ROLLCON_OK)
        << layers << " layers: " << told.text();
    if (deep)
      told.expect({"body 1: its elements under the frame are too deep", "or quadratic ones no deeper than"});
    else
      EXPECT_EQ(told.text(), "");
  }
}

// A thin layer on a deep one is a body of two layers; five layers, each twice as deep as the one above, are told
// nothing.
TEST(stability_bodies, few_layers_below_a_thin_one_are_told) {
  const std::vector<double> thin_on_deep{-1, 0.8, 1}, graded{-1, 0, 0.5, 0.75, 0.875, 1};
  for (const auto& lines : {thin_on_deep, graded}) {
    BlockShape block{.model = Model::fem};
    block.n = {16, 16, static_cast<int>(lines.size()) - 1};
    block.line[2] = lines;
    Told told(make_block(block));
    const bool few = lines.size() == 3;
    EXPECT_EQ(told.press(nullptr, {4e-3, 0}), few ? ROLLCON_INACCURATE : ROLLCON_OK) << told.text();
    if (few)
      told.expect({"body 1: its elements under the frame are too deep"});
    else
      EXPECT_EQ(told.text(), "");
  }
}

TEST(stability_bodies, covers_pressed_by_more_than_half_of_their_thickness_are_too_deep) {
  for (const Model model : {Model::fem, Model::bem}) {
    BlockShape cover{.model = model};
    cover.half = {3, 3, 0.5};
    cover.n = {12, 12, 3};
    Told told(make_block(cover));
    EXPECT_EQ(told.press(nullptr, {0.02, 0}), ROLLCON_OK) << told.text();
    EXPECT_EQ(told.press(nullptr, {0.26, 0}), ROLLCON_TOO_DEEP) << told.text();
    told.expect({"approach each other by 0.26", "0.5 thick"});
  }
}

}  // namespace
}  // namespace rollcon
