/// Implements the calls that set gaps on grids and make contact frames for a caller.

#include <cstdint>
#include <vector>

#include "capi/guard.hpp"
#include "contact/contact.hpp"
#include "contact/solver.hpp"
#include "framing/makers.hpp"
#include "io/mesh_file.hpp"
#include "mesh/mesh_inputs.hpp"
#include "support/input_checks.hpp"
#include "support/memory_limit.hpp"

using namespace rollcon;
using namespace rollcon::capi;

namespace {

constexpr std::int64_t most_intervals = 10'000, most_cells = 30'000;

void require_within(std::int64_t value, std::int64_t least, std::int64_t most, const char* name) {
  if (value < least || value > most)
    fail(Status::err_argument, "%s is %lld; allowed: %lld to %lld", name, static_cast<long long>(value),
         static_cast<long long>(least), static_cast<long long>(most));
}

void require_length(double value, const char* name) {
  require_finite(value, name);
  if (!(value > 0)) fail(Status::err_argument, "%s is %g; allowed: > 0", name, value);
}

/// Checks that a mesh with `along` by `across` nodes can be numbered and stored.
void require_room(std::int64_t along, std::int64_t across) {
  const std::int64_t nodes = along * across;
  if (nodes > INT32_MAX)
    fail(Status::err_argument, "the frame would have %lld nodes; allowed: at most %d", static_cast<long long>(nodes),
         INT32_MAX);
  // Coordinates and elements take about this much while the arrays grow.
  const double bytes = 200.0 * static_cast<double>(nodes);
  require_memory({bytes, bytes}, "ask for fewer elements", "a frame of %lld nodes needs",
                 static_cast<long long>(nodes));
}

}  // namespace

rollcon_status rollcon_contact_frame_from_file(rollcon_contact* contact, const char* path, const char* part) {
  return with_contact(__func__, contact, [&](Contact& self) {
    require_pointer(path, "path");
    require_pointer(part, "part");
    const MeshFile file = part_of(read_mesh_file(path), path, part, false);
    if (!file.told.empty()) self.solver->host.context->log(LogLevel::warning, "%s: %s", path, file.told.c_str());
    SurfaceMesh mesh = mesh_of_nodes(file.nodes(), file.node.data()->data(), 3, 1, 0);
    each_run(file, [&](int32_t type, int64_t n, const int32_t* nodes, int32_t tag) {
      append_elements(mesh, type, n, nodes, 0, tag, "frame", "rollcon_contact_frame_from_file");
    });
    self.scene.set_made_frame(std::move(mesh), false, true);
  });
}

rollcon_status rollcon_contact_frame_rectangle(rollcon_contact* contact, int32_t type, int32_t nx, int32_t ny,
                                               double x_least, double x_greatest, double y_least, double y_greatest) {
  return with_contact(__func__, contact, [&](Contact& self) {
    if (!is_element_type(type))
      fail(Status::err_argument, "type is %d; allowed: 203 (tri3), 206 (tri6), 214 (quad4), 218 (quad8), 219 (quad9)",
           type);
    require_within(nx, 1, most_cells, "nx");
    require_within(ny, 1, most_cells, "ny");
    const std::int64_t lines = is_quadratic(static_cast<ElementType>(type)) ? 2 : 1;
    require_room(lines * nx + 1, lines * ny + 1);
    require_ascending(x_least, "x_least", x_greatest, "x_greatest");
    require_ascending(y_least, "y_least", y_greatest, "y_greatest");
    const Rectangle bounds{x_least, x_greatest, y_least, y_greatest};
    self.scene.set_made_frame(rectangle_mesh(self.scene.axes(), static_cast<ElementType>(type), nx, ny, bounds), false,
                              true);
  });
}

rollcon_status rollcon_contact_frame_ellipse(rollcon_contact* contact, int32_t along, int32_t across, double a,
                                             double b, double angle) {
  return with_contact(__func__, contact, [&](Contact& self) {
    require_within(along, 2, most_intervals, "along");
    require_within(across, 2, most_intervals, "across");
    require_room(along + 1, across + 1);
    require_length(a, "a");
    require_length(b, "b");
    require_finite(angle, "angle");
    self.scene.set_made_frame(strips_mesh(self.scene.axes(), strips_of_ellipse(a, b, angle, across), along), true,
                              true);
  });
}

rollcon_status rollcon_contact_set_gap_grid(rollcon_contact* contact, int32_t nx, double x_least, double x_greatest,
                                            double y_least, double y_greatest, int64_t n, const double* gap) {
  return with_contact(__func__, contact, [&](Contact& self) {
    if (nx < 2) fail(Status::err_argument, "nx is %d; allowed: 2 or more", nx);
    if (n < 2 * static_cast<std::int64_t>(nx) || n % nx != 0)
      fail(Status::err_argument, "n is %lld; allowed: a multiple of nx = %d, 2 lines or more",
           static_cast<long long>(n), nx);
    self.scene.set_gap_grid({nx, n / nx, x_least, x_greatest, y_least, y_greatest}, gap);
  });
}

rollcon_status rollcon_contact_frame_strips(rollcon_contact* contact, int32_t along, int64_t n, const double* lines) {
  return with_contact(__func__, contact, [&](Contact& self) {
    require_within(along, 2, most_intervals, "along");
    require_within(n, 3, most_intervals + 1, "n");
    require_room(along + 1, n);
    require_pointer(lines, "lines");
    require_finite(n, 3, lines, "lines", 0);
    std::vector<Strip> strip;
    for (std::int64_t i = 0; i < n; ++i) {
      const double* l = lines + 3 * i;
      if (i > 0 && !(l[0] > l[-3]))
        fail(Status::err_argument, "y of lines %lld and %lld (counting from 0) is %g and %g; allowed: ascending",
             static_cast<long long>(i - 1), static_cast<long long>(i), l[-3], l[0]);
      const bool outer = i == 0 || i == n - 1;
      if (!(l[2] > l[1] || (outer && l[2] == l[1])))
        fail(Status::err_argument,
             "line %lld (counting from 0) goes from %g to %g; allowed: ascending, and on the first and the last "
             "line equal",
             static_cast<long long>(i), l[1], l[2]);
      strip.push_back({l[0], l[1], l[2]});
    }
    self.scene.set_made_frame(strips_mesh(self.scene.axes(), strip, along), true, true);
  });
}
