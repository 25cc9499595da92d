#pragma once
/// Makes work-precision studies: solves over element sizes whose records are emitted once the answer for vanishing size
/// is known.

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "bench.hpp"

namespace rollcon::bench {

struct Limit {
  double value = 0, uncertainty = 0;  ///< in the unit of value
};

struct Sample {
  double across = 0, value = 0;  ///< elements or nodes across the contact
};

/// Returns the limit of one curve: value + c / across^p through its finer half (three at least, if there are), with the
/// p of 1, 1.5, 2, 3 that leaves the least residual. It is uncertain by half of what is extrapolated and by twice the
/// residual.
Limit extrapolate(std::vector<Sample> curve);

/// Returns the mean weighted with 1 / uncertainty^2. It is uncertain by what the weights say or by how far the limits
/// lie apart, whichever is more.
Limit combine(std::span<const Limit> limits);

/// Holds the limit of the force vector, or what stands for it, relative, and of the moment over mu Fn sqrt(a b).
struct RollingLimit {
  scenes::RollingAnswer answer{};
  double uncertainty = 0, moment_uncertainty = 0;
};
RollingLimit rolling_limit(const Limit& longitudinal, const Limit& lateral, const Limit& moment);
/// Returns a limit whose lateral force and moment vanish by symmetry.
RollingLimit symmetric_limit(const Limit& longitudinal);

/// Holds quantities of a pair on frames of its own that grow finer, laid on bodies of fixed meshes: for each, the
/// limits on the kinds of bodies that were asked for.
using FrameLimits = std::vector<std::vector<Limit>>;
/// Appends what frames of lines/2, 3 lines/4 and `lines` extrapolate to on bodies of `parts`. Bodies of `coarse` parts
/// tell how much the bodies' meshes may add; solve(pair, lines) reads the quantities.
void add_frame_limits(FrameLimits& limits, int parts, int coarse, int lines,
                      const std::function<std::unique_ptr<scenes::RollingPair>(int parts)>& make,
                      const std::function<std::vector<double>(scenes::RollingPair&, int lines)>& solve);

class Study {
 public:
  /// Adds a record; if `trusted`, its curve (method, model, element) counts for the limit.
  void add(Record record, double across, bool trusted = true);
  /// Adds a record of a rolling contact, whose value is its longitudinal force, or what stands for it.
  void add(Record record, const scenes::RollingAnswer& found, double across, bool trusted = true);
  /// Returns the limit from the trusted curves, of the records' values or of one of their extras.
  Limit limit(const std::string& extra = "") const;
  /// Compares a second quantity, an extra `name`: gives every record its `error_name` relative to `limit`, and
  /// `uncertainty_name`.
  void compare(const std::string& name, const Limit& limit);
  /// Emits records with errors relative to `limit`; `against` says where it is from.
  void emit(Runner& runner, const Limit& limit, const std::string& against);
  /// Emits records of rolling contacts.
  void emit(Runner& runner, const RollingLimit& limit, const std::string& against);
  /// Emits records that `judge` gives their errors; the number counts them in the order of adding.
  void emit(Runner& runner, const std::function<void(Record&, std::size_t number)>& judge, double uncertainty,
            const std::string& against);

 private:
  struct Entry {
    Record record;
    scenes::RollingAnswer found;
    double across;
    bool trusted;
  };
  std::vector<Entry> entries_;
};

/// Sets size and uncertainty of a record: extras `across` and `uncertainty`.
void add_size(Record& record, double across, double uncertainty);

using MakePair = std::function<std::unique_ptr<scenes::RollingPair>()>;

/// Holds a solved scene.
struct Solved {
  std::unique_ptr<scenes::RollingPair> pair{};
  scenes::Solution solution{};
};

/// Solves from nothing (arrays to tractions). A short solve is repeated, five times at most while it takes less than a
/// quarter of a second; the fastest counts.
Solved cold_solve(const Runner& runner, Record& record, const MakePair& make);

/// Returns the seconds of a solve with creepages given, after 1 % more of them and back; it is repeated and the fastest
/// taken, like a cold one.
double warm_solve(const Runner& runner, scenes::RollingPair& pair, const std::array<double, 3>& creep);

/// Calls cold_solve by each scheme of convection. Bodies are prepared once and the frame's compliance is assembled
/// once; their seconds count for each scheme.
void solve_by_schemes(const Runner& runner, const Record& blank, const MakePair& make,
                      const std::function<void(Record&, const Solved&)>& finish);

/// Adds seconds by phase, bytes and unknowns of the bodies that have a mesh.
void add_bodies(Record& record, const scenes::RollingPair& pair);

}  // namespace rollcon::bench
