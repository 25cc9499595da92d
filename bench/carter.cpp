// Measures Carter's strip: force and traction over nodes across the contact, kind of element, scheme and grading, also
// on CONTACT's grids (case e).

#include <cmath>
#include <utility>

#include "meshes.hpp"
#include "study.hpp"
#include "support/carter_strip.hpp"

namespace rollcon::bench {
namespace {

constexpr double half_length = 20;  ///< half length of the strip, in half-widths of the contact

/// Returns the corner lines among lines of nodes: every other one for elements with midside nodes.
std::vector<double> corners(const std::vector<double>& x, ElementType type) {
  if (!is_quadratic(type)) return x;
  std::vector<double> every_other;
  for (std::size_t k = 0; k < x.size(); k += 2) every_other.push_back(x[k]);
  return every_other;
}

/// Returns scenes::strip_nodes with an even number of steps for quadratic elements.
std::vector<double> uniform(int across, ElementType type) {
  std::vector<double> x = scenes::strip_nodes(across);
  if (is_quadratic(type) && x.size() % 2 == 0) x.push_back(2 * x.back() - x[x.size() - 2]);
  return corners(x, type);
}

/// Returns the error of the force vector of the middle section; a plane problem has no spin moment.
double roll(Runner& runner, Record& record, ElementType type, const std::vector<double>& x) {
  const scenes::Strip strip{scenes::carter.hertz, half_length};
  const auto mesh = frames::rectangle(type, x, scenes::strip_lines(half_length));
  record.model = "half-spaces";
  record.threads = runner.threads;
  const Solved solved = cold_solve(runner, record, [&] {
    auto pair = std::make_unique<scenes::RollingPair>(scenes::roller, scenes::roller, runner.threads);
    pair->frame(mesh).option("convection", record.method.c_str());
    scenes::load_strip(*pair, strip, mesh);
    return pair;
  });
  const auto error = scenes::compare(scenes::middle_section(solved.solution));
  record.quantity = "F/(mu P) at given creepage";
  record.against = "Carter's closed form";
  record.value = error.force_ratio;
  record.judge({error.force, NAN});
  record.extra = {{"error_traction_l2", error.traction}, {"error_load", error.load}};

  record.extra.emplace_back("warm_seconds", warm_solve(runner, *solved.pair, {scenes::carter.xi, 0, 0}));
  return error.force;
}

void carter(Runner& runner) {
  for (const FrameKind& kind : frame_kinds) {
    if (kind.rings) continue;
    for (const bool graded : {false, true}) {
      const std::vector<int> sizes = graded                            ? std::vector{10, 20, 30, 40, 60}
                                     : kind.type == ElementType::quad4 ? std::vector{12, 25, 50, 100, 150}
                                                                       : std::vector{12, 24, 48, 72, 96};
      for (const int across : sizes) {
        if (runner.quick && across > 20 && across != 24 && across != 25) continue;
        for (const char* scheme : scenes::schemes) {
          Record record{.case_name = "carter", .method = scheme};
          record.mesh = (graded ? "graded " : "uniform ") + std::to_string(across);
          record.element = kind.name + std::string(graded ? " graded" : "");
          roll(runner, record, kind.type,
               graded ? corners(scenes::graded_nodes(across), kind.type) : uniform(across, kind.type));
          add_size(record, across, 0);
          runner.emit(record);
        }
      }
    }
  }
}

/// Holds CONTACT's results on N strips of which 90 % are in contact: error of the force against its own limit, and
/// seconds of a warm solve of the plane problem. They were measured like those of cases (a) and (b).
struct Mark {
  int n;
  double error, seconds;
};
constexpr Mark contact[] = {
    {16, 0.010, 0.06e-3}, {32, 0.010, 0.16e-3}, {64, 0.010, 0.6e-3}, {128, 0.007, 2.8e-3}, {256, 0.0006, 15e-3}};

void case_e(Runner& runner) {
  for (const Mark& mark : contact) {
    if (runner.quick && mark.n > 32) continue;
    for (const char* scheme : scenes::schemes) {
      Record record{.case_name = "case_e", .method = scheme};
      record.mesh = "strip " + std::to_string(mark.n);
      record.element = "quad4";
      // The nodes are at the centres of the strips.
      const double half = (1 - 1.0 / mark.n) / 0.9;
      const double error = roll(runner, record, ElementType::quad4, frames::uniform_lines(-half, half, mark.n - 1));
      record.extra.insert(record.extra.end(), {{"n", mark.n},
                                               {"contact_error", mark.error},
                                               {"contact_seconds", mark.seconds},
                                               {"error_over_contact", error / mark.error}});
      add_size(record, 0.9 * mark.n, 0);
      runner.emit(record);
    }
  }
}

}  // namespace

std::vector<Case> carter_cases() {
  return {{"carter", "long strip of identical cylinders: elements, gradings, three schemes", carter},
          {"case_e", "Carter's strip: beside CONTACT", case_e}};
}

}  // namespace rollcon::bench
