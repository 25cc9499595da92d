#include "bench.hpp"

#include <chrono>
#include <cmath>
#include <cstdio>

#include "json.hpp"
#include "memory.hpp"

namespace rollcon::bench {

double now() {
  using clock = std::chrono::steady_clock;
  return std::chrono::duration<double>(clock::now().time_since_epoch()).count();
}

scenes::Solution timed_solve(scenes::RollingPair& pair, Record& record, double began) {
  reset_peak_resident();
  record.status = pair.solve();
  scenes::Solution solution = pair.solution();
  record.seconds = now() - began;
  record.resident_bytes = peak_resident_bytes();
  rollcon_contact_get_size(pair.handle(), &record.nodes, &record.elements);
  auto count = [&](const char* name) { return std::llround(pair.stat(name)); };
  record.pairs = count("nodes_contact");
  record.unknowns = count("unknowns");
  record.peak_bytes = count("peak_bytes");
  record.iterations = count("iterations");
  record.linear_iterations = count("linear_iterations");
  for (const char* phase : {"compliance", "convection", "newton", "linear", "total"})
    record.phase_seconds.emplace_back(phase, pair.stat((std::string("seconds_") + phase).c_str()));
  return solution;
}

bool Runner::open_json(const std::string& path) {
  json_ = std::fopen(path.c_str(), "w");
  return json_ != nullptr;
}

Runner::~Runner() {
  if (json_) std::fclose(json_);
}

namespace {
/// The strip scenes mean to have contact at the frame's rim.
bool trustworthy(std::int32_t status) {
  return status == ROLLCON_OK || status == ROLLCON_RIM_CONTACT;
}
}  // namespace

void Runner::emit(const Record& r) {
  std::printf("%-12s %-15s %-12s %-26s %6lld nodes  %s = %.6g, error %+.3e", r.case_name.c_str(), r.method.c_str(),
              r.element.c_str(), r.mesh.c_str(), static_cast<long long>(r.nodes), r.quantity.c_str(), r.value, r.error);
  if (r.moment_error) std::printf(", moment %.3e", *r.moment_error);
  std::printf("  %.4f s  %lld it%s\n", r.seconds, static_cast<long long>(r.iterations),
              trustworthy(r.status) ? "" : "  (not converged)");
  for (const auto& [name, value] : r.extra) std::printf("    %s = %.6g\n", name.c_str(), value);
  std::fflush(stdout);
  write(r);
}

void Runner::write(const Record& r) {
  if (!json_) return;
  JsonObject seconds, extra;
  seconds.add("wall", r.seconds);
  for (const auto& [name, value] : r.phase_seconds) seconds.add(name, value);
  for (const auto& [name, value] : r.extra) extra.add(name, value);
  JsonObject object;
  object.add("case", r.case_name).add("method", r.method).add("model", r.model).add("mesh", r.mesh);
  object.add("element", r.element);
  object.add("nodes", r.nodes).add("elements", r.elements).add("pairs", r.pairs);
  object.add("unknowns", r.unknowns).add("status", static_cast<std::int64_t>(r.status));
  object.add("quantity", r.quantity).add("value", r.value).add("error", r.error);
  if (r.moment_error) object.add("moment_error", *r.moment_error);
  object.add("against", r.against).add("seconds", seconds).add("peak_bytes", r.peak_bytes);
  object.add("resident_bytes", r.resident_bytes).add("iterations", r.iterations);
  object.add("linear_iterations", r.linear_iterations);
  object.add("threads", static_cast<std::int64_t>(r.threads)).add("extra", extra);
  for (const auto& [name, values] : r.series) object.add(name, values);
  if (!r.note.empty()) object.add("note", r.note);
  std::fprintf(json_, "%s\n", object.text().c_str());
  std::fflush(json_);
}

}  // namespace rollcon::bench
