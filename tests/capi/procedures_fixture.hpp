#pragma once
/// Chooses solution procedures by options through the public interface.

#include "fixture.hpp"
#include "support/procedures.hpp"

namespace capi_test {

using rollcon::scenes::Procedure;

inline std::vector<Procedure> all_procedures() {
  std::vector<Procedure> all;
  for (const char* system : rollcon::scenes::systems)
    for (const Procedure& p : rollcon::scenes::procedures_by_solver(system)) all.push_back(p);
  return all;
}

/// Holds what a solve leaves to read.
struct Results {
  std::vector<double> traction, gap, slip;
  std::vector<std::int32_t> state;
  double force[3] = {}, moment[3] = {}, approach = 0, creep[3] = {};
  double iterations = 0, law = 0;
};

inline double largest(const std::vector<double>& v) {
  double m = 0;
  for (const double x : v) m = std::max(m, std::abs(x));
  return m;
}

/// Returns the largest difference over the largest entry of the second; 1 stands for zeros.
inline double difference(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) return std::nan("");
  double d = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (!std::isfinite(a[k])) return std::nan("");
    d = std::max(d, std::abs(a[k] - b[k]));
  }
  const double scale = largest(b);
  return scale > 0 ? d / scale : d;
}

/// Sets the scene of Api on a small frame by a scheme that every procedure can use.
class ProcedureScene : public Api {
 protected:
  void SetUp() override {
    if (!rollcon_has_feature("procedures")) GTEST_SKIP() << "this build has no published solution procedures";
    Api::SetUp();
    frame = SquareFrame(8, 1.5);
    set_scene();
    ASSERT_OK(rollcon_contact_set_str(contact, "convection", "godunov"));
    ASSERT_OK(rollcon_contact_set_creep(contact, -8e-4, 4e-4, 2e-4));
  }

  void set(const char* name, const char* value) {
    if (std::string(name) == "procedure")
      ASSERT_OK(rollcon_contact_set_procedure(contact, value));
    else
      ASSERT_OK(rollcon_contact_set_str(contact, name, value));
  }
  void set(const char* name, double value) { ASSERT_OK(rollcon_contact_set_real(contact, name, value)); }
  void set(const Procedure& p) {
    p.each([&](const char* option, const char* value) { set(option, value); });
  }
  void by_force(std::int32_t direction, double value) {
    ASSERT_OK(rollcon_contact_prescribe(contact, direction, ROLLCON_BY_FORCE, value));
  }
  void by_motion(std::int32_t direction, double value) {
    ASSERT_OK(rollcon_contact_prescribe(contact, direction, ROLLCON_BY_MOTION, value));
  }
  std::int32_t solve_cold() {
    EXPECT_OK(rollcon_contact_reset(contact));
    return rollcon_contact_solve(contact);
  }
  double stat(const char* name) const {
    double v = 0;
    EXPECT_OK(rollcon_contact_get_stat(contact, name, &v)) << name;
    return v;
  }
  std::vector<double> field(std::int32_t which, std::size_t components) const {
    std::vector<double> v(components * static_cast<std::size_t>(frame.nodes));
    EXPECT_OK(rollcon_contact_get_field(contact, which, ROLLCON_LOCAL, static_cast<std::int64_t>(v.size()), v.data(),
                                        nullptr));
    return v;
  }
  Results results() const {
    Results r;
    r.traction = field(ROLLCON_FIELD_TRACTION, 3);
    r.gap = field(ROLLCON_FIELD_GAP, 1);
    r.slip = field(ROLLCON_FIELD_SLIP, 2);
    r.state.resize(static_cast<std::size_t>(frame.nodes));
    EXPECT_OK(rollcon_contact_get_node_states(contact, frame.nodes, r.state.data()));
    EXPECT_OK(rollcon_contact_get_resultant(contact, ROLLCON_LOCAL, r.force, r.moment));
    EXPECT_OK(rollcon_contact_get_motion(contact, &r.approach, r.creep));
    r.iterations = stat("iterations");
    for (const char* law : {"law_normal", "law_friction", "law_slip", "law_equilibrium"})
      r.law = std::max(r.law, stat(law));
    return r;
  }
  /// Returns the results of the standard procedure, and leaves it set.
  Results standard() {
    set(Procedure{});
    EXPECT_OK(solve_cold());
    return results();
  }
};

}  // namespace capi_test
