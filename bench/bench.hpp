#pragma once
/// Defines benchmarks: a case runs scenes and emits one record per solve.

#include <cstdint>
#include <cstdio>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "support/rolling_errors.hpp"

namespace rollcon::bench {

struct Record {
  std::string case_name{}, method{}, model{}, mesh{};
  std::string element{};              ///< kind of element: with method and model it names a curve of a plot
  std::string quantity{}, against{};  ///< quantity that `error` is of, and what it is against
  /// Error, relative and signed unless `quantity` says otherwise; in rolling cases it is that of the force vector,
  /// never negative.
  double value = 0, error = 0;
  /// Error |dMz| / (mu Fn sqrt(a b)) in rolling cases; NaN where a plane problem has no moment.
  std::optional<double> moment_error{};
  std::int64_t nodes = 0, elements = 0, pairs = 0, unknowns = 0;
  std::int32_t status = 0;
  double seconds = 0;  ///< wall seconds, from arrays to results
  std::vector<std::pair<std::string, double>> phase_seconds{};
  std::int64_t peak_bytes = 0;      ///< bytes by the library's own count
  std::int64_t resident_bytes = 0;  ///< VmHWM of the process during the solve
  std::int64_t iterations = 0, linear_iterations = 0;
  int threads = 1;
  std::vector<std::pair<std::string, double>> extra{};
  std::vector<std::pair<std::string, std::vector<double>>> series{};  ///< series by iteration
  std::string note{};                                                 ///< what the library said, if it refused

  void judge(const scenes::RollingErrors& errors) { error = errors.force, moment_error = errors.moment; }
};

class Runner {
 public:
  bool quick = false;
  int threads = 1;
  int scenes = 0;  ///< number of random scenes of the stability suite; 0: its own choice

  Runner() = default;
  Runner(const Runner&) = delete;
  Runner& operator=(const Runner&) = delete;
  void emit(const Record& record);   ///< prints the record and writes it
  void write(const Record& record);  ///< writes the record to the file, if there is one
  bool open_json(const std::string& path);
  ~Runner();

 private:
  std::FILE* json_ = nullptr;
};

struct Case {
  std::string name, summary;
  std::function<void(Runner&)> run;
};

/// Each of these returns the cases of a family; main.cpp strings them together.
std::vector<Case> hertz_cases();
std::vector<Case> carter_cases();
std::vector<Case> kalker_cases();
std::vector<Case> kalker_mesh_cases();
std::vector<Case> steady_rolling_cases();
std::vector<Case> example3_cases();
std::vector<Case> kernel_cases();
std::vector<Case> bem_kernel_cases();  ///< filled where the static library is built
std::vector<Case> linear_solver_cases();
std::vector<Case> friction_law_cases();
std::vector<Case> body_cases();
std::vector<Case> ring_load_cases();
void ring_sections(Runner& runner);  ///< case of ring_load_cases()
std::vector<Case> fem_cases();
std::vector<Case> effectivity_cases();
std::vector<Case> lame_cases();
std::vector<Case> hertz_block_cases();
std::vector<Case> example1_cases();
std::vector<Case> example2_cases();
std::vector<Case> example4_cases();
std::vector<Case> procedure_cases();
std::vector<Case> lattice_cases();
std::vector<Case> saved_body_cases();
std::vector<Case> resolve_cases();
std::vector<Case> guard_cases();
std::vector<Case> automatic_frame_cases();
std::vector<Case> thrift_cases();
std::vector<Case> time_loop_cases();
std::vector<Case> time_step_cases();
std::vector<Case> many_cases();
std::vector<Case> wheel_rail_cases();
std::vector<Case> wheelset_cases();  ///< where the integrator is there
std::vector<Case> creep_table_cases();
std::vector<Case> equivalent_ellipse_cases();
std::vector<Case> stability_cases();
std::vector<Case> stress_cases();
std::vector<Case> slice_cases();

double now();  ///< monotonic seconds

/// Solves, times the solve, and fills status, sizes, phases, memory and iterations of the record. `began` is now()
/// before the caller built the scene; the record's seconds count from there.
scenes::Solution timed_solve(scenes::RollingPair& pair, Record& record, double began);

}  // namespace rollcon::bench
