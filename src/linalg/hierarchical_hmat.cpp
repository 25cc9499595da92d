/// Factorises by hmat-oss (GPL-2.0-or-later). Exceptions of callbacks are not thrown through it while it
/// assembles: the first is kept, blocks that follow are left empty, and it is thrown again once hmat-oss returns.

#include <hmat/hmat.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <exception>
#include <limits>
#include <mutex>
#include <new>
#include <utility>

#include "linalg/dense.hpp"
#include "linalg/hierarchical_factor.hpp"
#include "linalg/skeleton.hpp"
#include "support/checksum.hpp"
#include "support/error.hpp"
#include "support/index.hpp"
#include "support/interrupt.hpp"

namespace rollcon {
namespace {

constexpr int leaf = 200;         ///< most unknowns of a cluster that is not divided
constexpr double admissible = 4;  ///< largest size of a cluster over its distance from another at which ranks are low
/// Fraction of the accuracy to which blocks are assembled. ACA+ stops by the size of its last cross, which tells too
/// little of the rest: errors of its blocks, not those of the factorisation, decide how wrong solutions are.
constexpr double assembled_finer = 0.1;
constexpr std::int64_t whole = 1'000'000;  ///< entries up to which blocks are computed in full

std::mutex& one_at_a_time() {
  static std::mutex mutex;
  return mutex;
}

const hmat_interface_t& library() {
  static const hmat_interface_t calls = [] {
    hmat_interface_t made{};
    hmat_init_default_interface(&made, HMAT_DOUBLE_PRECISION);
    made.init();
    hmat_settings_t settings{};
    hmat_get_parameters(&settings);
    settings.maxLeafSize = leaf;
    hmat_set_parameters(&settings);
    return made;
  }();
  return calls;
}

/// Holds what the callbacks of one assembly share.
struct Assembly {
  const BlockMatrix& matrix;
  const std::vector<std::int32_t>& row;  ///< row by place
  const std::vector<std::int32_t>& column;
  double accuracy;
  std::exception_ptr failure;

  template <class Work>
  void guarded(Work work) noexcept {
    if (failure) return;
    try {
      check_interrupt();
      work();
    } catch (...) {
      failure = std::current_exception();
    }
  }
};

struct Block {
  Skeleton skeleton;
  bool known = false;  ///< false after a failure: then all entries are zero
};

void prepare_block(int row, int rows, int column, int columns, int* row_place, int* /*row_back*/, int* column_place,
                   int* /*column_back*/, void* context, hmat_block_info_t* info) {
  auto& assembly = *static_cast<Assembly*>(context);
  // hmat-oss asserts that there are data, and may ask for them.
  static Block none;
  info->user_data = &none;
  info->release_user_data = [](void* data) {
    if (data != &none) delete static_cast<Block*>(data);
  };
  assembly.guarded([&] {
    auto* const block = new Block{};
    info->user_data = block;
    std::vector<std::int32_t> named_rows, named_columns;
    for (int k = 0; k < rows; ++k) named_rows.push_back(assembly.row[at(row_place[row + k])]);
    for (int k = 0; k < columns; ++k) named_columns.push_back(assembly.column[at(column_place[column + k])]);
    block->skeleton = skeleton_of(assembly.matrix, named_rows, named_columns, assembly.accuracy, whole);
    block->known = true;
  });
}

void compute_block(void* data, int row, int rows, int column, int columns, void* to) {
  const auto& block = *static_cast<const Block*>(data);
  if (block.known)
    block.skeleton.write(row, rows, column, columns, static_cast<double*>(to));
  else
    std::fill_n(static_cast<double*>(to), at(rows) * at(columns), 0.0);
}

using Write = std::function<void(const void*, std::size_t)>;
using Read = std::function<void(void*, std::size_t)>;

class HmatFactor final : public SystemFactor {
 public:
  HmatFactor(const BlockMatrix& matrix, std::span<const Pivot> pivots, double accuracy);
  HmatFactor(std::span<const Pivot> pivots, double condition, const Read& read);
  ~HmatFactor() override {
    const std::lock_guard lock(one_at_a_time());
    if (matrix_) library().destroy(matrix_);
  }
  HmatFactor(const HmatFactor&) = delete;
  HmatFactor& operator=(const HmatFactor&) = delete;

  std::int64_t size() const override { return static_cast<std::int64_t>(row_.size()); }
  void solve(double* b, std::int64_t count) const override;
  void eliminate(double* b, std::int64_t count) const override { solve(b, count); }
  void substitute(double* /*b*/, std::int64_t /*count*/, std::int64_t /*first*/) const override {}
  double condition() const override { return condition_; }
  std::size_t bytes() const override { return bytes_; }
  void write(const Write& write) const;

 private:
  /// Makes a matrix without entries; the caller has the lock.
  void make_empty(std::span<const Pivot> pivots);
  /// Lets it be one of factors, all of whose blocks vanish.
  void make_zero_factors();
  void count_bytes();
  std::uint64_t order() const;
  void assemble(const BlockMatrix& matrix, double accuracy);
  void factorise();
  void estimate_condition(double norm);

  std::vector<std::int32_t> row_, column_;  ///< by place
  hmat_matrix_t* matrix_ = nullptr;
  std::vector<int> order_;  ///< places in the order of the clusters
  double condition_ = 0;
  std::size_t bytes_ = 0;
};

void HmatFactor::make_empty(std::span<const Pivot> pivots) {
  std::vector<double> place;
  for (const Pivot& p : pivots) {
    row_.push_back(p.row);
    column_.push_back(p.column);
    place.insert(place.end(), p.place.begin(), p.place.end());
  }
  const hmat_interface_t& call = library();
  hmat_clustering_algorithm_t* const halves = hmat_create_clustering_median();
  hmat_clustering_algorithm_t* const clustering = hmat_create_clustering_max_dof(halves, leaf);
  hmat_cluster_tree_t* const tree =
      hmat_create_cluster_tree(place.data(), 3, static_cast<int>(row_.size()), clustering);
  hmat_admissibility_t* const admissibility = hmat_create_admissibility_standard(admissible);
  matrix_ = call.create_empty_hmatrix_admissibility(tree, hmat_copy_cluster_tree(tree), 0, admissibility);
  hmat_delete_admissibility(admissibility);
  hmat_delete_clustering(clustering);
  hmat_delete_clustering(halves);
  if (!matrix_) throw std::bad_alloc();
  order_.assign(hmat_cluster_get_indices(tree), hmat_cluster_get_indices(tree) + row_.size());
  call.own_cluster_trees(matrix_, 1, 1);
}

HmatFactor::HmatFactor(const BlockMatrix& matrix, std::span<const Pivot> pivots, double accuracy) {
  double norm = 0;
  {
    const std::lock_guard lock(one_at_a_time());
    const hmat_interface_t& call = library();
    try {
      make_empty(pivots);
      call.set_low_rank_epsilon(matrix_, accuracy);
      assemble(matrix, assembled_finer * accuracy);
      norm = call.norm(matrix_);
      factorise();
    } catch (...) {
      if (matrix_) call.destroy(std::exchange(matrix_, nullptr));
      throw;
    }
    count_bytes();
  }
  estimate_condition(norm);
}

void HmatFactor::count_bytes() {
  hmat_info_t info{};
  library().get_info(matrix_, &info);
  bytes_ = info.compressed_size * sizeof(double);
}

void HmatFactor::assemble(const BlockMatrix& matrix, double accuracy) {
  Assembly assembly{matrix, row_, column_, accuracy, nullptr};
  hmat_assemble_context_t context{};
  hmat_assemble_context_init(&context);
  const hmat_compression_algorithm_t* const compression = hmat_create_compression_aca_plus(accuracy);
  context.compression = compression;
  context.user_context = &assembly;
  context.prepare = prepare_block;
  context.block_compute = compute_block;
  context.progress = nullptr;
  const int status = library().assemble_generic(matrix_, &context);
  hmat_delete_compression(compression);
  if (assembly.failure) std::rethrow_exception(assembly.failure);
  if (status != 0) fail(Status::err_internal, "hmat-oss did not assemble the matrix (status %d)", status);
}

void HmatFactor::factorise() {
  hmat_progress_t progress{};
  progress.update = [](hmat_progress_t*) { check_interrupt(); };
  hmat_factorization_context_t context{};
  hmat_factorization_context_init(&context);
  context.factorization = hmat_factorization_lu;
  context.progress = &progress;
  const int status = library().factorize_generic(matrix_, &context);
  library().set_progressbar(matrix_, nullptr);
  if (status != 0) fail(Status::err_singular, "a block of the hierarchical matrix is singular");
}

void HmatFactor::solve(double* b, std::int64_t count) const {
  constexpr std::int64_t slab = 64;
  const std::size_t n = row_.size();
  std::vector<double> part(n * at(std::min(slab, count)));
  for (std::int64_t first = 0; first < count; first += slab) {
    check_interrupt();
    const std::int64_t columns = std::min(slab, count - first);
    double* const own = b + at(first) * n;
    for (std::size_t j = 0; j < at(columns); ++j)
      for (std::size_t k = 0; k < n; ++k) part[j * n + k] = own[j * n + at(row_[k])];
    {
      const std::lock_guard lock(one_at_a_time());
      if (library().solve_systems(matrix_, part.data(), static_cast<int>(columns)) != 0)
        fail(Status::err_internal, "hmat-oss did not solve");
    }
    for (std::size_t j = 0; j < at(columns); ++j)
      for (std::size_t k = 0; k < n; ++k) own[j * n + at(column_[k])] = part[j * n + k];
  }
}

// Estimates as FactoredMatrix does, by one right side of random signs and two steps of inverse iteration.
void HmatFactor::estimate_condition(double norm) {
  std::vector<double> x(row_.size());
  std::uint64_t state = 1;
  for (double& value : x) {
    state = state * 6364136223846793005U + 1442695040888963407U;
    value = state >> 63 != 0 ? norm : -norm;
  }
  for (int step = 0; step < 2; ++step) {
    solve(x.data(), 1);
    const double growth = norm2(x.data(), size());
    if (!std::isfinite(growth)) {
      condition_ = std::numeric_limits<double>::infinity();
      return;
    }
    condition_ = std::max(condition_, growth);
    for (double& value : x) value *= norm / growth;
  }
}

// The order of the clusters, which the blocks belong to, comes first. Each part of the data follows its size.

std::uint64_t HmatFactor::order() const {
  Checksum sum;
  sum.add(order_.data(), order_.size() * sizeof order_[0]);
  return sum.value();
}

void HmatFactor::write(const Write& write) const {
  const std::uint64_t clusters = order();
  write(&clusters, sizeof clusters);
  const auto write_part = [](void* data, std::size_t bytes, void* to) {
    if (bytes == 0) return;
    const std::uint64_t size = bytes;
    const Write& whole = *static_cast<const Write*>(to);
    whole(&size, sizeof size);
    whole(data, bytes);
  };
  const std::lock_guard lock(one_at_a_time());
  library().write_data(matrix_, write_part, const_cast<Write*>(&write));
}

void HmatFactor::make_zero_factors() {
  const hmat_interface_t& call = library();
  hmat_assemble_context_t context{};
  hmat_assemble_context_init(&context);
  const hmat_compression_algorithm_t* const compression = hmat_create_compression_aca_plus(0.1);
  context.compression = compression;
  context.prepare = [](int, int, int, int, int*, int*, int*, int*, void*, hmat_block_info_t* info) {
    static Block none;
    info->user_data = &none;
    info->release_user_data = [](void*) {};
    info->block_type = hmat_block_null;
  };
  context.block_compute = [](void*, int, int, int, int, void*) {};
  context.progress = nullptr;
  const int status = call.assemble_generic(matrix_, &context);
  hmat_delete_compression(compression);
  if (status != 0) fail(Status::err_internal, "hmat-oss did not make the blocks (status %d)", status);
  // The second number of a matrix's description is the kind of its factors: it is changed to LU and the matrix is read
  // back. For each block the rank is the second number after its one byte of flags. Blocks of rank 0 would not be
  // filled with data, so they get rank 1.
  struct Text {
    std::vector<char> bytes;
    std::size_t read = 0;
    int since_flags = 0;
  } text;
  call.write_struct(
      matrix_,
      [](void* data, std::size_t bytes, void* to) {
        Text& all = *static_cast<Text*>(to);
        all.since_flags = bytes == 1 ? 0 : all.since_flags + 1;
        all.bytes.insert(all.bytes.end(), static_cast<char*>(data), static_cast<char*>(data) + bytes);
        const int some = 1;
        int rank = 1;
        if (all.since_flags == 2 && bytes == sizeof rank) std::memcpy(&rank, data, sizeof rank);
        if (rank == 0) std::memcpy(all.bytes.data() + all.bytes.size() - sizeof rank, &some, sizeof some);
      },
      &text);
  const hmat_factorization_t kind = hmat_factorization_lu;
  std::memcpy(text.bytes.data() + sizeof(int), &kind, sizeof kind);
  call.destroy(std::exchange(matrix_, nullptr));
  matrix_ = call.read_struct(
      [](void* data, std::size_t bytes, void* from) {
        auto& all = *static_cast<Text*>(from);
        std::memcpy(data, all.bytes.data() + all.read, bytes);
        all.read += bytes;
      },
      &text);
  if (!matrix_) throw std::bad_alloc();
}

/// Reads the parts of a file and checks that each has the size that hmat-oss asks for. The pivots of a diagonal block
/// follow its square of entries: that tells which parts they are. Failures wait until hmat-oss, which is not made for
/// exceptions, has returned: the parts left are zeros.
struct Parts {
  const Read& read;
  int unknowns = 0;
  std::size_t before = 0;
  std::exception_ptr failure{};

  void take_if_sound(void* data, std::size_t bytes) noexcept {
    if (!failure) try {
        return take(data, bytes);
      } catch (...) {
        failure = std::current_exception();
      }
    std::memset(data, 0, bytes);
  }
  void take(void* data, std::size_t bytes) {
    if (bytes == 0) return;
    std::uint64_t size = 0;
    read(&size, sizeof size);
    if (size != bytes) fail(Status::err_io, "a block of hierarchical factors has another size");
    read(data, bytes);
    const std::size_t rows = bytes / sizeof(int);
    if (bytes == sizeof(int) && (*static_cast<int*>(data) < 0 || *static_cast<int*>(data) > unknowns))
      fail(Status::err_io, "a rank of the hierarchical factors is out of range");
    if (before == rows * rows * sizeof(double))
      for (std::size_t k = 0; k < rows; ++k)
        if (const int pivot = static_cast<int*>(data)[k]; pivot < 1 || at(pivot) > rows)
          fail(Status::err_io, "a pivot of the hierarchical factors is out of range");
    before = bytes;
  }
};

HmatFactor::HmatFactor(std::span<const Pivot> pivots, double condition, const Read& read) : condition_(condition) {
  const std::lock_guard lock(one_at_a_time());
  try {
    make_empty(pivots);
    std::uint64_t clusters = 0;
    read(&clusters, sizeof clusters);
    if (clusters != order())
      fail(Status::err_io, "hierarchical factors were written for other places or by another hmat-oss");
    make_zero_factors();
    Parts parts{read, static_cast<int>(row_.size())};
    library().read_data(
        matrix_,
        [](void* data, std::size_t bytes, void* from) { static_cast<Parts*>(from)->take_if_sound(data, bytes); },
        &parts);
    if (parts.failure) std::rethrow_exception(parts.failure);
  } catch (...) {
    if (matrix_) library().destroy(std::exchange(matrix_, nullptr));
    throw;
  }
  count_bytes();
}

}  // namespace

bool has_hierarchical_factor() {
  return true;
}

// Dense blocks take about 12 kB an unknown; the others grow with the number of digits and of levels. Measured on quad8
// surfaces of 5,800 and 29,200 unknowns, with 30 % on top for what assembly and factorisation hold besides.
double hierarchical_bytes(std::int64_t unknowns, double accuracy) {
  const double n = static_cast<double>(unknowns), levels = std::max(0.0, std::log2(n) - 10.6);
  const double digits = std::max(1.0, -std::log10(accuracy) - 2);
  return std::min(1.3 * n * (12e3 + 1660 * digits * levels), 16 * n * n);
}

std::unique_ptr<SystemFactor> factor_hierarchically(const BlockMatrix& matrix, std::span<const Pivot> pivots,
                                                    double accuracy) {
  return std::make_unique<HmatFactor>(matrix, pivots, accuracy);
}

void write_hierarchical(const SystemFactor& factor, const Write& write) {
  dynamic_cast<const HmatFactor&>(factor).write(write);
}

std::unique_ptr<SystemFactor> read_hierarchical(std::span<const Pivot> pivots, double condition, const Read& read) {
  return std::make_unique<HmatFactor>(pivots, condition, read);
}

}  // namespace rollcon
