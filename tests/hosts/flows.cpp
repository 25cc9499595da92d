#include "flows.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <utility>

#include "capi/body_fixture.hpp"
#include "capi/fem_fixture.hpp"

namespace hosts {
namespace {

using capi_test::BoxVolume;
using capi_test::CubeSurface;
using capi_test::SquareFrame;

/// Holds the handles of a flow; what was made is released in whatever way it ends.
struct Handles {
  rollcon_context* context = nullptr;
  rollcon_body *body = nullptr, *plane = nullptr;
  rollcon_contact* contact = nullptr;

  Handles() = default;
  Handles(const Handles&) = delete;
  Handles& operator=(const Handles&) = delete;
  ~Handles() { release(); }
  /// Releases each once.
  void release() {
    rollcon_contact_release(std::exchange(contact, nullptr));
    rollcon_body_release(std::exchange(plane, nullptr));
    rollcon_body_release(std::exchange(body, nullptr));
    rollcon_context_release(std::exchange(context, nullptr));
  }
};

#define CALL(function, ...) call(#function, [&] { return function(__VA_ARGS__); })

void end(Caller& call, Handles& h) {
  call("releases", [&] {
    h.release();
    return ROLLCON_OK;
  });
}

void begin(Caller& call, Handles& h) {
  CALL(rollcon_context_create, ROLLCON_ABI, &h.context);
  call.context = h.context;
  CALL(rollcon_context_set_threads, h.context, call.threads);
  CALL(rollcon_body_create, h.context, ROLLCON_BODY_RIGID, &h.plane);
}

/// Returns a new name, because flows may run in many threads and processes.
std::string new_file(const char* ending) {
  static std::atomic<int> count{0};
  return folder() + "/" + std::to_string(getpid()) + "-" + std::to_string(++count) + ending;
}

void made(Caller& call, rollcon_contact* contact) {
  if (call.made_contact) call.made_contact(contact);
}

/// Rolls a sphere of radius 50 on a rigid plane.
void roll_sphere(Caller& call, Handles& h, int per_edge) {
  const SquareFrame frame(per_edge, 1.5);
  const double friction = 0.1;
  begin(call, h);
  CALL(rollcon_body_create, h.context, ROLLCON_BODY_HALFSPACE, &h.body);
  CALL(rollcon_body_set_elastic, h.body, 0, 1e4, 0.3);
  CALL(rollcon_contact_create, h.context, h.body, h.plane, &h.contact);
  CALL(rollcon_contact_frame_nodes, h.contact, frame.nodes, frame.x.data(), 3, 1);
  CALL(rollcon_contact_frame_add_elements, h.contact, ROLLCON_QUAD4, frame.elements, frame.connectivity.data(), 0, 0);
  CALL(rollcon_contact_set_gap_quadratic, h.contact, 0.01, 0.01, 0);
  CALL(rollcon_contact_set_friction, h.contact, "coulomb", 1, &friction);
  CALL(rollcon_contact_set_rolling, h.contact, 10);
  CALL(rollcon_contact_prescribe, h.contact, ROLLCON_NORMAL, ROLLCON_BY_FORCE, 300);
  CALL(rollcon_contact_set_creep, h.contact, 1e-3, 2e-4, 1e-3);
  CALL(rollcon_contact_set_real, h.contact, "tolerance", 1e-13);
  made(call, h.contact);
}

/// Rolls a rigid sphere of radius 1 on the top of a unit cube; faces of the top have tag 6.
void roll_on_cube(Caller& call, Handles& h) {
  const double origin[3] = {0.5, 0.5, 1}, rolling[3] = {1, 0, 0}, normal[3] = {0, 0, 1};
  const double friction = 0.3;
  CALL(rollcon_contact_create, h.context, h.body, h.plane, &h.contact);
  CALL(rollcon_contact_set_axes, h.contact, origin, rolling, normal);
  CALL(rollcon_contact_frame_from_body, h.contact, 1, 6);
  CALL(rollcon_contact_set_gap_quadratic, h.contact, 0.5, 0.5, 0);
  CALL(rollcon_contact_set_friction, h.contact, "coulomb", 1, &friction);
  CALL(rollcon_contact_prescribe, h.contact, ROLLCON_NORMAL, ROLLCON_BY_MOTION, 0.06);
  CALL(rollcon_contact_set_creep, h.contact, 1e-2, 0, 0);
  made(call, h.contact);
}

/// Returns everything that a contact tells after its solve.
std::vector<double> solve(Caller& call, Handles& h) {
  std::int64_t nodes = 0, elements = 0, needed = 0;
  std::array<double, 3> force{}, moment{};
  CALL(rollcon_contact_solve, h.contact);
  CALL(rollcon_contact_get_size, h.contact, &nodes, &elements);
  std::vector<double> out(static_cast<std::size_t>(3 * nodes)), at(3);
  CALL(rollcon_contact_get_tractions, h.contact, ROLLCON_GLOBAL, nodes, out.data());
  CALL(rollcon_contact_get_resultant, h.contact, ROLLCON_LOCAL, force.data(), moment.data());
  const double point[2] = {0.1, 0.2};
  CALL(rollcon_contact_get_displacements_at, h.contact, 1, 1, point, at.data());
  const double stress[6] = {1, 2, 3, 4, 5, 6};
  double principal[3];
  CALL(rollcon_stress_invariants, 1, stress, principal, nullptr, nullptr);
  CALL(rollcon_contact_get_plan, h.contact, 0, nullptr, &needed);
  std::vector<char> plan(static_cast<std::size_t>(needed));
  CALL(rollcon_contact_get_plan, h.contact, needed, plan.data(), nullptr);
  if (rollcon_has_feature("vtu")) {
    const std::string file = new_file(".vtu");
    CALL(rollcon_contact_write, h.contact, file.c_str());
    std::filesystem::remove(file);
  }
  out.insert(out.end(), at.begin(), at.end());
  out.insert(out.end(), force.begin(), force.end());
  out.insert(out.end(), moment.begin(), moment.end());
  return out;
}

void add_slopes(Caller& call, Handles& h, std::vector<double>& out) {
  for (const std::int32_t p :
       std::initializer_list<std::int32_t>{ROLLCON_LONGITUDINAL, ROLLCON_SPIN, ROLLCON_FRICTION}) {
    std::array<double, 3> force{};
    CALL(rollcon_contact_get_sensitivity, h.contact, p, force.data(), nullptr, nullptr, nullptr);
    out.insert(out.end(), force.begin(), force.end());
  }
}

template <int per_edge>
std::vector<double> halfspace(Caller& call, const char* operators, const char* linear_solver) {
  Handles h;
  roll_sphere(call, h, per_edge);
  CALL(rollcon_contact_set_str, h.contact, "operators", operators);
  CALL(rollcon_contact_set_str, h.contact, "linear_solver", linear_solver);
  std::vector<double> out = solve(call, h);
  add_slopes(call, h, out);
  CALL(rollcon_contact_set_creep, h.contact, 2e-3, 0, 0);
  const std::vector<double> again = solve(call, h);
  out.insert(out.end(), again.begin(), again.end());
  end(call, h);
  return out;
}

std::vector<double> dense(Caller& call) {
  return halfspace<6>(call, "dense", "lu");
}
std::vector<double> table(Caller& call) {
  return halfspace<8>(call, "table", "auto");
}
std::vector<double> fft(Caller& call) {
  return halfspace<8>(call, "fft", "auto");
}

std::vector<double> monolithic(Caller& call) {
  Handles h;
  roll_sphere(call, h, 6);
  CALL(rollcon_contact_prescribe, h.contact, ROLLCON_NORMAL, ROLLCON_BY_MOTION, 0.02);
  CALL(rollcon_contact_set_str, h.contact, "convection", "godunov");
  CALL(rollcon_contact_set_procedure, h.contact, "system=monolithic jacobian=exact");
  CALL(rollcon_contact_set_str, h.contact, "linear_solver", "gmres");
  std::vector<double> out = solve(call, h);
  end(call, h);
  return out;
}

std::vector<double> many(Caller& call) {
  Handles h;
  constexpr std::int64_t cases = 12;
  roll_sphere(call, h, 6);
  CALL(rollcon_contact_set_str, h.contact, "operators", "table");
  std::vector<double> value, result(6 * cases);
  for (std::int64_t i = 0; i < cases; ++i) {
    value.push_back(200.0 + 50.0 * static_cast<double>(i / 4));
    value.push_back(2e-4 * static_cast<double>(i % 4 + 1));
  }
  std::array<std::int32_t, cases> status{};
  const auto all = [&] {
    const std::int32_t summary = rollcon_contact_solve_many(h.contact, "normal longitudinal", cases, value.data(),
                                                            "force moment", 6, result.data(), nullptr, status.data());
    if (summary < 0) return summary;
    // A case that found no memory has that status; the flow wants every case.
    const auto failed = std::find_if(status.begin(), status.end(), [](auto s) { return s < 0; });
    return failed == status.end() ? summary : *failed;
  };
  call("rollcon_contact_solve_many", all);
  end(call, h);
  return result;
}

void set_bem(Caller& call, Handles& h) {
  const CubeSurface cube(3);
  CALL(rollcon_body_create, h.context, ROLLCON_BODY_BEM, &h.body);
  CALL(rollcon_body_set_elastic, h.body, 0, 200, 0.3);
  CALL(rollcon_body_set_nodes, h.body, cube.nodes(), cube.x.data(), 3, 1);
  for (std::int32_t f = 0; f < 6; ++f)
    CALL(rollcon_body_add_elements, h.body, ROLLCON_QUAD4, cube.face_elements(),
         cube.face[static_cast<std::size_t>(f)].data(), 0, f + 1);
  const std::vector<std::int32_t> bottom = cube.nodes_at(2, 0);
  CALL(rollcon_body_set_support, h.body, static_cast<std::int64_t>(bottom.size()), bottom.data(), 0, ROLLCON_DOF_XYZ,
       nullptr);
}

void set_fem(Caller& call, Handles& h) {
  const BoxVolume box(3);
  const auto [element, face] = box.top_faces();
  const std::vector<std::int32_t> bottom = box.nodes_at(2, 0);
  CALL(rollcon_body_create, h.context, ROLLCON_BODY_FEM, &h.body);
  CALL(rollcon_body_set_elastic, h.body, 0, 200, 0.3);
  CALL(rollcon_body_set_nodes, h.body, box.nodes(), box.x.data(), 3, 1);
  CALL(rollcon_body_add_elements, h.body, ROLLCON_HEX8, box.elements(), box.connectivity.data(), 0, 0);
  const std::int32_t *elements = element.data(), *faces = face.data();
  const auto count = static_cast<std::int64_t>(element.size());
  CALL(rollcon_body_tag_faces, h.body, count, elements, faces, 0, 6);
  CALL(rollcon_body_set_support, h.body, static_cast<std::int64_t>(bottom.size()), bottom.data(), 0, ROLLCON_DOF_XYZ,
       nullptr);
}

/// Prepares, solves, saves, and solves again what was loaded.
std::vector<double> with_file(Caller& call, Handles& h) {
  CALL(rollcon_body_prepare, h.body);
  roll_on_cube(call, h);
  std::vector<double> out = solve(call, h);
  const std::string file = new_file(".body");
  CALL(rollcon_body_save, h.body, file.c_str());
  Handles again;
  begin(call, again);
  CALL(rollcon_body_load, again.context, file.c_str(), &again.body);
  roll_on_cube(call, again);
  const std::vector<double> loaded = solve(call, again);
  out.insert(out.end(), loaded.begin(), loaded.end());
  std::filesystem::remove(file);
  end(call, again);
  end(call, h);
  return out;
}

std::vector<double> bem(Caller& call) {
  Handles h;
  begin(call, h);
  set_bem(call, h);
  return with_file(call, h);
}

std::vector<double> fem(Caller& call) {
  Handles h;
  begin(call, h);
  set_fem(call, h);
  return with_file(call, h);
}

constexpr Flow all[] = {{"dense", nullptr, dense},
                        {"table", nullptr, table},
                        {"fft", "fftw", fft},
                        {"many", nullptr, many},
                        {"monolithic", "procedures", monolithic},
                        {"bem", "bem", bem},
                        {"fem", "fem", fem}};

}  // namespace

void Caller::operator()(const char* name, const std::function<std::int32_t()>& function) {
  const std::int32_t status = make(name, function);
  if (status >= 0) return;
  throw Unexpected(std::string(name) + ": " + rollcon_status_string(status) + " (" + rollcon_last_error() + ")");
}

std::int32_t Caller::make(const char*, const std::function<std::int32_t()>& function) {
  return function();
}

std::vector<Flow> flows() {
  std::vector<Flow> present;
  for (const Flow& f : all)
    if (!f.feature || rollcon_has_feature(f.feature)) present.push_back(f);
  return present;
}

Flow flow(const std::string& name) {
  for (const Flow& f : flows())
    if (f.name == name) return f;
  throw Unexpected("no flow " + name);
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0);
}

double difference(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) return INFINITY;
  double most = 0, scale = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!std::isfinite(a[i])) return INFINITY;
    most = std::max(most, std::abs(a[i] - b[i]));
    scale = std::max(scale, std::abs(b[i]));
  }
  return scale > 0 ? most / scale : most;
}

const std::string& folder() {
  static const struct Folder {
    std::string name;
    pid_t owner = getpid();
    Folder() {
      // The folder is in memory where there is such a one, because saved bodies wait for the disk.
      const std::filesystem::path memory = "/dev/shm";
      std::string pattern = (access(memory.c_str(), W_OK) == 0 ? memory : std::filesystem::temp_directory_path()) /
                            "rollcon-hosts-XXXXXX";
      if (!mkdtemp(pattern.data())) throw Unexpected("no temporary folder");
      name = pattern;
    }
    ~Folder() {
      std::error_code ignored;
      if (owner == getpid()) std::filesystem::remove_all(name, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
  } made_once;
  return made_once.name;
}

bool Verdict::expect(bool right, const char* format, ...) {
  if (right) return true;
  ++wrong_;
  std::va_list args;
  va_start(args, format);
  std::printf("WRONG: ");
  std::vprintf(format, args);
  std::printf("\n");
  va_end(args);
  std::fflush(stdout);
  return false;
}

}  // namespace hosts
