#pragma once
/// Holds a creep-force table as callers see it: set, made in parts, then frozen.

#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "contact/contact.hpp"
#include "support/context.hpp"
#include "tables/creep_map.hpp"
#include "tables/creep_table.hpp"

namespace rollcon {

class ForceTable {
 public:
  explicit ForceTable(std::shared_ptr<Context> context) : context_(std::move(context)) {}
  Context& context() const { return *context_; }
  static std::unique_ptr<ForceTable> load(std::shared_ptr<Context> context, const std::string& path);
  /// Loads the table that comes with the library. err_io: it is not where the library looks.
  static std::unique_ptr<ForceTable> standard(std::shared_ptr<Context> context);

  // Setters before the first sample; err_state after it.
  void set_ratios(std::int32_t intervals, double least, double greatest);
  void set_resolution(std::int32_t magnitudes, std::int32_t angles, std::int32_t directions);
  void set_frame(std::int32_t along, std::int32_t across);  ///< intervals of the coarser frame
  void set_poissons(std::int64_t n, const double* poisson);
  /// Makes the table one of two bodies; young 0: rigid.
  void set_bodies(const double* young, const double* poisson, std::int64_t n, const double* friction);

  void set_progress(ProgressFunction function, void* user);
  /// Stops make(). Any thread may call it.
  void request_cancel() noexcept { cancel_.store(true); }
  /// Solves part `part` of `parts` of the samples; with the last of them the table is there. Returns ok or cancelled.
  Status make(std::int32_t part, std::int32_t parts);
  /// Returns the count of all samples' numbers, NaN where one is missing; 0 for a table that was loaded.
  std::int64_t samples(std::int64_t capacity, double* sample) const;
  /// Adds those samples that are no NaN.
  void add_samples(std::int64_t n, const double* sample);

  /// Looks n inputs up. Any thread may call it. err_state without a table.
  void evaluate(std::int64_t n, const double* input, double* result, double* derivative) const;
  /// Finds forces and moment about the centre of the Hertzian contact that stands for a contact of two bodies. Where a
  /// table of like bodies is asked about unlike ones, the mean strain under the pressure counts as creepage; where a
  /// table of unlike bodies is asked about others, err_argument.
  void evaluate(const EquivalentEllipse& contact, double* result) const;
  void save(const std::string& path) const;
  /// Returns the map of a pair of profiles, empty at first; key: checksum of all that it depends on.
  std::shared_ptr<CreepMap> map(std::uint64_t key) const;
  /// Throws err_state without a table.
  void require_made() const { table(); }

 private:
  void require_free() const;
  void fit_if_complete();
  const CreepTable& table() const;

  std::shared_ptr<Context> context_;
  TableGrid grid_;
  std::vector<double> sample_;
  std::unique_ptr<const CreepTable> table_;
  std::atomic<const CreepTable*> ready_{nullptr};  ///< table_, for other threads
  std::atomic<bool> cancel_{false};
  ProgressFunction progress_ = nullptr;
  void* progress_user_ = nullptr;
  mutable std::mutex map_mutex_;
  mutable std::map<std::uint64_t, std::shared_ptr<CreepMap>> map_;
};

}  // namespace rollcon
