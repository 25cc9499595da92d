#include "framing/step_frames.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>

#include "framing/makers.hpp"
#include "mesh/lattice_values.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

/// Hold errors of creepages under given forces: that of cells times the square of their number over the contact, and
/// that of rolling divided by the square of the part of the contact that rolls in within a step (docs/time.md).
constexpr double error_of_cells = 3.8, error_of_rolling = 0.4;

/// Returns how many cells the contact has at least each way: they cause a third of the error asked for.
double cells_for(double accuracy) {
  constexpr double part = 1.0 / 3, least = 16, most = 96;
  return std::clamp(std::sqrt(error_of_cells / (part * accuracy)), least, most);
}

/// Holds a lattice along the axes by its sides and its numbers of cells.
struct StepFrame {
  Rectangle sides{};
  std::int64_t along = 0, across = 0;
  bool same = false;  ///< it is the one of the step before

  double cell_along() const { return (sides.x_greatest - sides.x_least) / static_cast<double>(along); }
  double cell_across() const { return (sides.y_greatest - sides.y_least) / static_cast<double>(across); }
};

/// Holds the cells of a frame along one axis.
struct Axis {
  double start = 0, spacing = 0;
  std::int64_t cells = 0;
  double end() const { return start + static_cast<double>(cells) * spacing; }
  bool operator==(const Axis&) const = default;
};

/// Returns the cells over a range; `last`: those of the step before, null if there are none.
Axis choose_axis(const Axis* last, double least, double greatest, double extent, double wanted) {
  // Parts of the number of cells wanted: its bounds, and the margin that is added where the contact grows.
  constexpr double fewest = 0.7, most = 2, margin = 0.1;
  constexpr double most_cells = 1024, far = 1e6;
  const double middle = 0.5 * (least + greatest);
  double spacing = std::max(extent / wanted, (greatest - least) / most_cells), start = middle;
  bool same = false;
  if (last && std::abs(middle - last->start) < far * last->spacing) {
    // Spacings differ by powers of 2, so that the nodes of one axis are among those of the other.
    const double ratio = spacing / last->spacing;
    same = ratio < 1 / fewest && ratio > 1 / most;
    spacing = same ? last->spacing : std::ldexp(last->spacing, static_cast<int>(std::lround(std::log2(ratio))));
    start = last->start;
  }
  // Cells are numbered from the start.
  std::int64_t low = to_index(std::floor((least - start) / spacing)) - 1,
               high = to_index(std::ceil((greatest - start) / spacing)) + 1;
  if (same && low >= 0 && high <= last->cells) {
    if (last->cells <= 2 * (high - low)) return *last;
  } else if (same) {
    const auto more = to_index(std::ceil(margin * wanted));
    if (low < 0) low -= more;
    if (high > last->cells) high += more;
  }
  return {start + static_cast<double>(low) * spacing, spacing, high - low};
}

StepFrame choose_step_frame(const std::optional<Lattice>& last, const StepContact& contact) {
  const double wanted = cells_for(contact.accuracy);
  Axis before[2];
  if (last) before[0] = {last->x0, last->dx, last->nx - 1}, before[1] = {last->y0, last->dy, last->ny - 1};
  const Rectangle& b = contact.box;
  const Axis x = choose_axis(last ? &before[0] : nullptr, b.x_least, b.x_greatest, contact.length, wanted),
             y = choose_axis(last ? &before[1] : nullptr, b.y_least, b.y_greatest, contact.width, wanted);
  return {{x.start, x.end(), y.start, y.end()}, x.cells, y.cells, last && x == before[0] && y == before[1]};
}

/// Returns the error that the cells and the way of a step cause.
ErrorEstimate estimate(const StepFrame& frame, const StepContact& contact, double distance) {
  const double cells = std::min(contact.length / frame.cell_along(), contact.width / frame.cell_across());
  const double rolled_in = 4 * distance / (std::numbers::pi * contact.length);
  ErrorEstimate e;
  e.known = true;
  e.normal = error_of_cells / (cells * cells);
  e.tangential = e.tractions = e.normal + error_of_rolling * rolled_in * rolled_in;
  return e;
}

Rectangle widened(const Rectangle& box) {
  constexpr double wider = 0.125;
  const double x = wider * (box.x_greatest - box.x_least), y = wider * (box.y_greatest - box.y_least);
  return {box.x_least - x, box.x_greatest + x, box.y_least - y, box.y_greatest + y};
}

Status tell_long_step(const Solver& solver, const StepContact& contact, double distance, double error) {
  std::array<char, 256> text;
  std::snprintf(text.data(), text.size(),
                "frames: the step rolls by %.2g of the contact's length: creepages are off by about %.2g, more than "
                "frame_accuracy, %.2g: take shorter steps",
                distance / contact.length, error, contact.accuracy);
  solver.host.caveat(Status::inaccurate, text.data());
  return Status::inaccurate;
}

}  // namespace

Status StepFrames::solve(Solver& solver, const StepContact& given) {
  constexpr int most_trials = 5;
  const Scene& scene = solver.scene;
  const PastStep& last = solver.steps().last;
  StepContact contact = given;
  std::optional<Lattice> before;
  if (last.loaded && last.on) before = find_lattice(last.on->frame);
  if (before && !lies_along_axes(*before)) before.reset();
  solver.scale_tangential_loads(1);
  for (int trial = 0;; ++trial) {
    const StepFrame frame = choose_step_frame(before, contact);
    if (frame.same ? last.mesh != scene.revision.mesh || axes_ != scene.revision.axes
                   : !lies(solver, {frame.sides, frame.along, frame.across}))
      lay(solver, frame.sides, frame.along, frame.across);
    const Status status = solver.solve();
    if (status == Status::rim_contact && trial < most_trials) {
      contact.box = widened(contact.box);
      continue;
    }
    if (status != Status::ok) {
      solver.tell(status);
      return status;
    }
    const bool rolls = last.loaded && scene.step_kind() == StepKind::rolling;
    const double distance = rolls ? solver.solution().prepared->distance : 0;
    const ErrorEstimate& error = solver.derived().error_estimate = estimate(frame, contact, distance);
    return error.worst() <= contact.accuracy ? status : tell_long_step(solver, contact, distance, error.worst());
  }
}

void StepFrames::lay(Solver& solver, const Rectangle& sides, std::int64_t along, std::int64_t across) {
  Scene& scene = solver.scene;
  scene.set_made_frame(rectangle_mesh(scene.axes(), ElementType::quad4, along, across, sides), false, false);
  laid_ = {sides, along, across};
  mesh_ = scene.revision.mesh;
  axes_ = scene.revision.axes;
}

bool StepFrames::lies(const Solver& solver, const RectangleCells& cells) const {
  return laid_ == cells && mesh_ == solver.scene.revision.mesh && axes_ == solver.scene.revision.axes;
}

}  // namespace rollcon
