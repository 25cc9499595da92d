/// Tests what finite-element bodies ask of tags, materials, supports and frames: what they cannot do is refused by a
/// text that names it, and the mended body serves; what comes often costs little.

#include "fem_fixture.hpp"

using namespace capi_test;

class fem_tags_and_frames : public FemApi {
 protected:
  std::int32_t tag_nodes(const std::vector<std::int32_t>& nodes, std::int32_t tag) {
    return rollcon_body_tag_faces_of_nodes(body, static_cast<std::int64_t>(nodes.size()), nodes.data(), 0, tag);
  }

  static inline const std::vector<std::int32_t> top_corners{4, 5, 6, 7}, top_of_hex20{4, 5, 6, 7, 12, 13, 14, 15};

  /// Makes a block held at its bottom, with material and tag 6 on its top.
  void set_block(int per_edge) {
    box = BoxVolume(per_edge);
    set_mesh();
    ASSERT_OK(rollcon_body_set_elastic(body, 0, young, poisson));
    ASSERT_OK(hold_bottom(ROLLCON_DOF_XYZ));
    ASSERT_OK(tag_top(6));
  }

  /// Rolls a rigid ball on the top at (x, y); the frame is still to come.
  rollcon_contact* roll_at(double x, double y) {
    return roll_on_top(context, body, plane, {.x = x, .y = y, .approach = 0.01, .tag = 0});
  }

  /// Lays n x n elements of the frame on the top around (x, y).
  static void lay(rollcon_contact* c, double x, double y, int n, double half) {
    give_frame(c, moved(SquareFrame(n, half), x, y, 1));
  }

  /// Returns the status of a solve on a frame of that width from (x, y) on; its tractions are finite.
  std::int32_t press(double at_x, double at_y, double width) {
    const double x = at_x + width / 2, y = at_y + width / 2;
    const SquareFrame small = moved(SquareFrame(2, width / 2), x, y, 1);
    rollcon_contact* c = roll_on_top(
        context, body, plane, {.x = x, .y = y, .curvature = 0.1, .approach = 1e-3, .mu = 0.2, .creep = 0, .tag = 0});
    give_frame(c, small);
    const std::int32_t status = rollcon_contact_solve(c);
    if (status >= 0) {
      std::vector<double> t(3 * static_cast<std::size_t>(small.nodes), 1e300);
      EXPECT_OK(rollcon_contact_get_tractions(c, ROLLCON_LOCAL, small.nodes, t.data()));
      double sum = 0;
      for (const double value : t) {
        EXPECT_TRUE(std::isfinite(value));
        sum += value;
      }
      EXPECT_LT(sum, 0) << "it is pressed";
    }
    rollcon_contact_release(c);
    return status;
  }

  double normal_force(rollcon_contact* c) {
    const double force = solved_force(c)[2];
    EXPECT_LT(force, 0);
    return force;
  }
};

TEST_F(fem_tags_and_frames, a_loaded_tag_is_on_a_face) {
  const double traction[3] = {1, 0, 0};
  for (const bool pressure : {true, false}) {
    set_element(ROLLCON_HEX20);
    ASSERT_OK(tag_nodes(top_corners, 6));
    ASSERT_OK(pressure ? rollcon_body_set_pressure(body, 6, 2) : rollcon_body_set_traction(body, 6, traction));
    for (int attempt = 0; attempt < 2; ++attempt)
      EXPECT_FAILS(rollcon_body_prepare(body), MESH, "tag 6", "midside nodes", "rollcon_body_set_pressure");
  }
  ASSERT_OK(tag_nodes(top_of_hex20, 6));
  ASSERT_OK(rollcon_body_set_pressure(body, 6, 2));
  ASSERT_OK(rollcon_body_prepare(body));
  double force[3], moment[3];
  ASSERT_OK(rollcon_body_get_reaction(body, force, moment));
  const double error = std::max(std::abs(force[0] + 1), std::abs(force[2] - 2)), bound = 1e-12;
  std::printf("reaction of a pressure and a traction: error %.2e, bound %.2e\n", error, bound);
  EXPECT_LE(error, bound);
}

TEST_F(fem_tags_and_frames, a_tag_taken_away_by_later_ones_is_on_no_face) {
  set_element(ROLLCON_HEX20);
  ASSERT_OK(tag_nodes(top_of_hex20, 6));
  ASSERT_OK(rollcon_body_set_pressure(body, 6, 2));
  ASSERT_OK(tag_nodes(top_of_hex20, 7));
  EXPECT_FAILS(rollcon_body_prepare(body), MESH, "tag 6", "later calls");
  ASSERT_OK(tag_nodes(top_of_hex20, 6));
  EXPECT_OK(rollcon_body_prepare(body));
}

TEST_F(fem_tags_and_frames, a_tag_of_contact_faces_is_on_a_face) {
  const std::int32_t six = 6;
  set_element(ROLLCON_HEX20);
  ASSERT_OK(tag_nodes(top_corners, six));
  ASSERT_OK(rollcon_body_set_contact_faces(body, 1, &six));
  EXPECT_FAILS(rollcon_body_prepare(body), MESH, "tag 6", "midside nodes", "rollcon_body_set_contact_faces");
  rollcon_contact* c = roll_at(0.5, 0.5);
  lay(c, 0.5, 0.5, 4, 0.4);
  EXPECT_FAILS(rollcon_contact_solve(c), MESH, "body 1", "tag 6", "midside nodes");
  ASSERT_OK(tag_nodes(top_of_hex20, six));
  normal_force(c);
  rollcon_contact_release(c);
}

TEST_F(fem_tags_and_frames, a_rigid_body_with_nodes_has_elements) {
  const double x[12] = {-1, -1, 1, 2, -1, 1, 2, 2, 1, -1, 2, 1};
  const std::int32_t quad[4] = {0, 3, 2, 1};
  set_block(4);
  ASSERT_OK(rollcon_body_set_nodes(plane, 4, x, 3, 1));
  EXPECT_FAILS(rollcon_body_prepare(plane), STATE, "rigid body", "no elements", "rollcon_body_add_elements");
  rollcon_contact* c = roll_at(0.5, 0.5);
  ASSERT_OK(rollcon_contact_frame_from_body(c, 1, 6));
  EXPECT_FAILS(rollcon_contact_solve(c), STATE, "body 2", "no elements");
  ASSERT_OK(rollcon_body_add_elements(plane, ROLLCON_QUAD4, 1, quad, 0, 0));
  normal_force(c);
  rollcon_contact_release(c);
}

TEST_F(fem_tags_and_frames, a_face_held_along_its_normal_carries_no_frame) {
  const std::int32_t six = 6;
  const std::array<std::int32_t, 3> masks{ROLLCON_DOF_Z, ROLLCON_DOF_Z + ROLLCON_DOF_X, ROLLCON_DOF_X};
  for (const bool named : {false, true})
    for (const std::int32_t held : masks) {
      rollcon_body_release(body);
      ASSERT_OK(rollcon_body_create(context, ROLLCON_BODY_FEM, &body));
      set_block(4);
      ASSERT_OK(rollcon_body_set_contact_faces(body, named ? 1 : 0, &six));
      ASSERT_OK(hold(box.nodes_at(2, 1), held));
      for (const bool own_faces : {true, false}) {
        rollcon_contact* c = roll_at(0.5, 0.5);
        if (own_faces) {
          ASSERT_OK(rollcon_contact_frame_from_body(c, 1, 6));
        } else {
          lay(c, 0.5, 0.5, 5, 0.4);
        }
        if (held == ROLLCON_DOF_X) {
          normal_force(c);  // its nodes still give way
        } else {
          EXPECT_FAILS(rollcon_contact_solve(c), STATE, "body 1", "held");
        }
        rollcon_contact_release(c);
      }
    }
}

TEST_F(fem_tags_and_frames, elements_of_constant_strain_are_refused_near_incompressibility) {
  struct Case {
    std::int32_t type;
    const char *name, *instead;
  };
  for (const Case& c : {Case{ROLLCON_TET4, "tet4", "tet10"}, Case{ROLLCON_WEDGE6, "wedge6", "wedge15"}}) {
    set_element(c.type, 0.46);
    EXPECT_FAILS(rollcon_body_prepare(body), UNSUPPORTED, "element 0", c.name, "poisson 0.46", "up to 0.45", c.instead);
    ASSERT_OK(rollcon_body_set_elastic(body, 0, young, 0.45));
    EXPECT_OK(rollcon_body_prepare(body));
  }
}

TEST_F(fem_tags_and_frames, shape_functions_alone_bear_no_finer_frame) {
  set_block(4);
  ASSERT_OK(rollcon_body_set_int(body, "between_nodes", 1));
  rollcon_contact* c = roll_at(0.5, 0.5);
  lay(c, 0.5, 0.5, 12, 0.4);
  EXPECT_FAILS(rollcon_contact_solve(c), MESH, "between_nodes", "coarsen");
  lay(c, 0.5, 0.5, 2, 0.4);
  normal_force(c);
  rollcon_contact_release(c);
}

TEST_F(fem_tags_and_frames, going_back_to_earlier_frames_factorises_nothing) {
  constexpr double place[2] = {0.25, 0.75};
  set_block(12);  // so many free faces that it waits for its first frame
  ASSERT_OK(rollcon_body_prepare(body));
  EXPECT_EQ(statistic("factorizations"), 0);
  rollcon_contact* c = nullptr;
  double force[2] = {0, 0};
  for (int round = 0; round < 3; ++round)
    for (int which = 0; which < 2; ++which) {
      rollcon_contact_release(c);
      c = roll_at(place[which], place[which]);
      // The frame is another one every time, lest results be reused from the last one.
      lay(c, place[which], place[which], 7, 0.2 - 1e-3 * round);
      const double now = normal_force(c);
      if (round == 0) {
        force[which] = now;
        EXPECT_EQ(statistic("factorizations"), which + 1);
        continue;
      }
      const double change = std::abs(now / force[which] - 1), bound = 0.01;
      std::printf("round %d, frame %d: %g factorisations of 2, change of force %.2e, bound %.2e\n", round, which,
                  statistic("factorizations"), change, bound);
      EXPECT_EQ(statistic("factorizations"), 2);
      EXPECT_LE(change, bound);
    }
  EXPECT_EQ(statistic("assemblies"), 1);
  EXPECT_GE(statistic("condensations"), 6);
  rollcon_contact_release(c);
}

TEST_F(fem_tags_and_frames, thousands_of_tags_carry_their_own_pressures) {
  constexpr std::int32_t n = 71, tags = n * n;
  std::vector<double> x;
  std::vector<std::int32_t> element, bottom;
  for (int k = 0; k < 2; ++k)
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) x.insert(x.end(), {1.0 * i, 1.0 * j, 1.0 * k});
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i)
      for (const auto& c : BoxVolume::corners) element.push_back(i + c[0] + (n + 1) * (j + c[1] + (n + 1) * c[2]));
  for (std::int32_t i = 0; i < (n + 1) * (n + 1); ++i) bottom.push_back(i);
  ASSERT_OK(rollcon_body_set_nodes(body, 2 * std::int64_t{n + 1} * (n + 1), x.data(), 3, 1));
  ASSERT_OK(rollcon_body_add_elements(body, ROLLCON_HEX8, tags, element.data(), 0, 0));
  ASSERT_OK(rollcon_body_set_elastic(body, 0, young, poisson));
  ASSERT_OK(hold(bottom, ROLLCON_DOF_XYZ));
  double sum = 0;
  const std::int32_t face = BoxVolume::top;
  for (std::int32_t e = 0; e < tags; ++e) {
    const double pressure = 1e-3 * (e % 17);
    // Half of the faces are tagged by element and face, half by their nodes: the upper four of the element.
    if (e % 2 == 0) {
      ASSERT_OK(rollcon_body_tag_faces(body, 1, &e, &face, 0, e + 1));
    } else {
      ASSERT_OK(rollcon_body_tag_faces_of_nodes(body, 4, &element[8 * static_cast<std::size_t>(e) + 4], 0, e + 1));
    }
    ASSERT_OK(rollcon_body_set_pressure(body, e + 1, pressure));
    sum += pressure;
  }
  ASSERT_OK(rollcon_body_prepare(body));
  double force[3], moment[3];
  ASSERT_OK(rollcon_body_get_reaction(body, force, moment));
  const double difference = std::abs(force[2] - sum), bound = 1e-10 * sum;
  std::printf("reaction of %d pressures: error %.2e, bound %.2e\n", tags, difference, bound);
  EXPECT_LE(difference, bound);
}

TEST_F(fem_tags_and_frames, frames_much_smaller_than_a_face_are_borne_or_refused) {
  int borne = 0;
  for (const std::int32_t type : {ROLLCON_HEX8, ROLLCON_HEX20, ROLLCON_WEDGE15}) {
    set_element(type);
    for (const double width : {0.2, 1e-2, 1e-4, 1e-6, 3.8e-8}) {
      for (const double at : {0.0, 0.1}) {
        const std::int32_t status = press(at, at, width);
        EXPECT_TRUE(status >= 0 || status == ROLLCON_ERR_MESH || status == ROLLCON_ERR_SINGULAR)
            << "type " << type << ", width " << width << ": " << error();
        borne += status >= 0;
      }
    }
  }
  EXPECT_GE(borne, 15) << "of 30";
}
