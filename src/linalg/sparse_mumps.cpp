/// Factorises definite matrices by MUMPS, in builds without CHOLMOD or over ranks. MUMPS gives the condensed matrix as
/// a Schur complement, whose Cholesky factor serves solve_condensed.

#include <dmumps_c.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <new>
#include <numeric>
#include <vector>

#include "build_info.hpp"
#include "linalg/condensed_factor.hpp"
#include "linalg/lapack.hpp"
#include "linalg/shared_factor.hpp"
#include "linalg/sparse_checks.hpp"
#include "linalg/sparse_factor.hpp"
#include "linalg/sparse_metis_random.hpp"
#include "linalg/sparse_order.hpp"
#include "support/clock.hpp"
#include "support/error.hpp"
#include "support/index.hpp"
#include "support/memory_limit.hpp"
#include "support/ranks.hpp"

namespace rollcon {
namespace {

/// Parts of what MUMPS is asked to do.
enum Job : MUMPS_INT { begin = -1, end = -2, analyse = 1, factorise = 2, solve_job = 3 };
constexpr MUMPS_INT not_enough_memory[] = {-8, -9, -13, -19};
constexpr std::int64_t block = 32;  ///< right sides solved at a time

/// Calls MUMPS on one matrix, on all ranks. Calls from several threads take turns, since MUMPS has variables of its
/// own.
class Mumps {
 public:
  explicit Mumps(const Ranks& ranks) {
    id_.par = 1;
    id_.sym = 1;  // positive definite
    id_.comm_fortran = ranks.handle();
    run(begin);
    for (const int stream : {1, 2, 3, 4}) control(stream) = 0;
  }
  ~Mumps() { run(end); }
  Mumps(const Mumps&) = delete;
  Mumps& operator=(const Mumps&) = delete;

  /// Numbers are those of MUMPS's manual, from 1 on.
  MUMPS_INT& control(int number) { return id_.icntl[number - 1]; }
  MUMPS_INT found(int number) const { return id_.infog[number - 1]; }
  double real_found(int number) const { return id_.rinfog[number - 1]; }
  MUMPS_INT run(Job job) {
    static std::mutex one_at_a_time;
    const std::lock_guard lock(one_at_a_time);
    id_.job = job;
    dmumps_c(&id_);
    return id_.infog[0];
  }
  DMUMPS_STRUC_C* operator->() { return &id_; }

 private:
  DMUMPS_STRUC_C id_{};
};

class MumpsFactor final : public SparseFactor {
 public:
  /// order: as factor_definite() takes it.
  MumpsFactor(const SparseMatrix& matrix, std::span<const std::int64_t> condensed, const Ranks& ranks,
              std::span<const std::int64_t> order = {})
      : ranks_(std::ssize(condensed) == matrix.columns ? Ranks() : ranks),
        size_(matrix.columns),
        condensed_(condensed.begin(), condensed.end()) {
    check_sparse(matrix, condensed);
    for (std::int64_t j = 0; j < size_; ++j)
      if (!(matrix.value[at(matrix.start[at(j)])] > 0)) throw ZeroPivot(j);
    for (std::size_t k = 0; k < condensed_.size(); ++k) place_.push_back(static_cast<std::int64_t>(k));
    take_order(matrix, order);
    if (size_ > 0) factorise_all(matrix, 0);
    const auto inverse = [this](double* x) { solve(x, 1); };
    statistics_.condition = size_ > 0 ? estimate_condition(matrix, inverse) : 1;
    if (!(statistics_.condition < singular_condition)) throw ZeroPivot(softest(matrix));
  }
  std::int64_t size() const override { return size_; }
  void solve(double* b, std::int64_t count) override {
    for (std::int64_t k = 0; k < count && size_ > 0; k += block) solve_block(b + k * size_, std::min(block, count - k));
  }
  void solve_condensed(double* b, std::int64_t count) override { rollcon::solve_condensed(condensed(), b, count); }
  void keep_condensed() override {
    mumps_.reset();
    for (auto* numbers : {&row_, &column_, &listed_, &turn_}) std::vector<MUMPS_INT>().swap(*numbers);
    for (auto* values : {&value_, &scale_, &reduced_}) std::vector<double>().swap(*values);
  }
  CondensedView condensed() const override {
    return {static_cast<std::int64_t>(condensed_.size()), schur_.get(), place_};
  }
  SparseStatistics statistics() const override {
    SparseStatistics now = statistics_;
    now.bytes = own_bytes() + (mumps_ ? factor_bytes_ : 0);
    return now;
  }

 private:
  std::size_t own_bytes() const {
    return sizeof(double) * (condensed_.size() * condensed_.size() + value_.capacity()) +
           sizeof(MUMPS_INT) * (row_.capacity() + column_.capacity() + turn_.capacity());
  }
  void take_order(const SparseMatrix& matrix, std::span<const std::int64_t> order);
  void take_matrix(const SparseMatrix& matrix, double more);
  /// Returns the bytes that the factorisation will take on this machine, in memory or with the factors on the disk.
  double need(Mumps& m) const { return 1e6 * m.found(m.control(22) != 0 ? 26 : 16) * ranks_.on_machine(); }
  void find_room(Mumps& m) const;
  void factorise_all(const SparseMatrix& matrix, double more);
  void take_whole();
  void take_schur();
  std::int64_t softest(const SparseMatrix& matrix);
  void solve_block(double* b, std::int64_t count);

  const Ranks ranks_;
  std::int64_t size_;
  std::vector<std::int64_t> condensed_, place_;
  std::vector<MUMPS_INT> row_, column_, listed_, turn_;  ///< turn_: when each unknown is eliminated
  std::vector<double> value_, scale_, reduced_;
  std::unique_ptr<double[]> schur_;  ///< Cholesky factor of the condensed matrix, column-major
  std::unique_ptr<Mumps> mumps_;
  std::size_t factor_bytes_ = 0;
  SparseStatistics statistics_;
};

// MUMPS is given an order: with a Schur complement it would take minimum degree, which fills 1.7 times as much as
// nested dissection.
void MumpsFactor::take_order(const SparseMatrix& matrix, std::span<const std::int64_t> order) {
  const Stopwatch watch(statistics_.seconds_order);
  SparseOrder found;
  if (order.empty()) order = (found = order_unknowns(matrix, condensed_)).unknown;
  statistics_.peak_bytes = found.peak_bytes + matrix.bytes();
  turn_.resize(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) turn_[at(order[k])] = static_cast<MUMPS_INT>(k + 1);
  // MUMPS refuses condensed unknowns in another sequence than that of their list.
  for (std::size_t k = 0; k < condensed_.size(); ++k)
    turn_[at(condensed_[k])] = static_cast<MUMPS_INT>(order.size() - condensed_.size() + k + 1);
}

// Takes this rank's columns of the lower triangle scaled to a unit diagonal, with each diagonal entry larger by a part
// of it: MUMPS takes small entries for zero.
void MumpsFactor::take_matrix(const SparseMatrix& matrix, double more) {
  row_.clear(), column_.clear(), value_.clear();
  scale_ = diagonal_scale(matrix);
  for (std::int64_t j = 0; j < size_; ++j) {
    if (!ranks_.mine(j)) continue;
    for (auto k = at(matrix.start[at(j)]); k < at(matrix.start[at(j) + 1]); ++k) {
      const bool diagonal = matrix.row[k] == j;
      row_.push_back(static_cast<MUMPS_INT>(matrix.row[k] + 1));
      column_.push_back(static_cast<MUMPS_INT>(j + 1));
      value_.push_back(scale_[at(matrix.row[k])] * scale_[at(j)] * (diagonal ? 1 + more : 1) * matrix.value[k]);
    }
  }
}

void MumpsFactor::factorise_all(const SparseMatrix& matrix, double more) {
  take_matrix(matrix, more);
  const auto n = static_cast<MUMPS_INT>(condensed_.size());
  try {
    schur_ = std::make_unique<double[]>(condensed_.size() * condensed_.size());
  } catch (const std::bad_alloc&) {
    out_of_memory(size_, 8.0 * static_cast<double>(condensed_.size() * condensed_.size()));
  }
  if (n == size_) return take_whole();
  reduced_.reserve(condensed_.size() * block);
  ranks_.agree(std::ssize(matrix.row));  // from here on all ranks take each step
  mumps_ = std::make_unique<Mumps>(ranks_);
  Mumps& m = *mumps_;
  m->n = static_cast<MUMPS_INT>(size_);
  m->nnz_loc = static_cast<MUMPS_INT8>(value_.size());
  m->irn_loc = row_.data();
  m->jcn_loc = column_.data();
  m->a_loc = value_.data();
  m.control(18) = 3;   // each rank gives its part of the matrix
  m.control(14) = 30;  // per cent of room beyond what the analysis foresees
  m.control(8) = 0;    // the matrix is scaled
  m.control(7) = 1;    // the order is given
  m->perm_in = turn_.data();
  if (n > 0) {
    listed_.clear();
    for (const std::int64_t u : condensed_) listed_.push_back(static_cast<MUMPS_INT>(u + 1));
    m.control(19) = 1;
    m->size_schur = n;
    m->listvar_schur = listed_.data();
    m->schur = schur_.get();
  }
  MUMPS_INT status = 0;
  {
    const Stopwatch watch(statistics_.seconds_order);
    status = m.run(analyse);
  }
  if (status >= 0) {
    find_room(m);
    const Stopwatch watch(statistics_.seconds_factor);
    // MUMPS asks for more room where pivots or orders need it.
    while ((status = m.run(factorise)) == -9 && m.control(14) < 1000) m.control(14) *= 2;
  }
  if (std::find(std::begin(not_enough_memory), std::end(not_enough_memory), status) != std::end(not_enough_memory))
    out_of_memory(size_, need(m));
  const auto entries = [](MUMPS_INT number) { return number < 0 ? -1e6 * number : number; };
  statistics_.nonzeros = static_cast<std::int64_t>(entries(m.found(29)));
  statistics_.flops = m.real_found(3);
  factor_bytes_ = static_cast<std::size_t>(1e6 * m.found(21));
  statistics_.peak_bytes = std::max(statistics_.peak_bytes, factor_bytes_ + own_bytes() + matrix.bytes());
  const bool indefinite = status == -10 || status == -40 || (status >= 0 && m.found(12) > 0);  // a negative pivot
  if (indefinite) {
    if (more > 0) throw ZeroPivot(0);
    throw ZeroPivot(softest(matrix));
  }
  if (status < 0) fail(Status::err_internal, "MUMPS failed with status %d", status);
  if (n == 0) return;
  ranks_.take_from_first(schur_.get(), n * n * std::int64_t{sizeof(double)});
  take_schur();
}

// Lets the factors go to files, in the folder that MUMPS_OOC_TMPDIR names or /tmp, where memory is too small for them.
void MumpsFactor::find_room(Mumps& m) const {
  const MemorySources sources = memory_sources();
  const bool fits = need(m) <= std::min(memory_limit(sources).bytes, allocation_limit(sources).bytes);
  if (ranks_.least(fits) == 0) m.control(22) = 1;
  ranks_.together([&] { require_memory(size_, need(m)); });
}

// Takes the whole matrix as the condensed one.
void MumpsFactor::take_whole() {
  std::vector<std::size_t> at_place(condensed_.size());
  for (std::size_t k = 0; k < condensed_.size(); ++k) at_place[at(condensed_[k])] = k;
  for (std::size_t k = 0; k < value_.size(); ++k) {
    const std::size_t i = at_place[at(row_[k] - 1)], j = at_place[at(column_[k] - 1)];
    schur_[std::max(i, j) * condensed_.size() + std::min(i, j)] = value_[k];
  }
  take_schur();
}

// Factorises the condensed matrix, whose lower triangle is there by rows, and undoes its scale.
void MumpsFactor::take_schur() {
  const std::size_t n = condensed_.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < i; ++j) std::swap(schur_[i * n + j], schur_[j * n + i]);
  const auto size = static_cast<int>(n);
  int info = 0;
  dpotrf_("L", &size, schur_.get(), &size, &info);
  if (info > 0) throw ZeroPivot(condensed_[at(info - 1)]);
  for (std::size_t j = 0; j < n; ++j) {
    std::fill_n(schur_.get() + j * n, j, 0.0);
    for (std::size_t i = j; i < n; ++i) schur_[j * n + i] /= scale_[at(condensed_[i])];
  }
}

// Returns the unknown that moves most under the smallest eigenvalue of the matrix, by inverse iteration.
std::int64_t MumpsFactor::softest(const SparseMatrix& matrix) {
  constexpr double more = 1e-9;
  factorise_all(matrix, more);
  std::vector<double> x(at(size_));
  for (std::size_t k = 0; k < x.size(); ++k) x[k] = 1 + 0.1 * std::sin(static_cast<double>(k));
  const auto largest = [&] {
    return std::max_element(x.begin(), x.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  };
  for (int step = 0; step < 3; ++step) {
    solve(x.data(), 1);
    const double unit = std::abs(*largest());
    for (double& v : x) v /= unit;
  }
  return largest() - x.begin();
}

void MumpsFactor::solve_block(double* b, std::int64_t count) {
  const auto n = static_cast<std::int64_t>(condensed_.size());
  reduced_.resize(at(n * count));
  if (!mumps_) {
    const auto each = [&](auto move) {
      for (std::int64_t r = 0; r < count; ++r)
        for (std::int64_t k = 0; k < n; ++k) move(reduced_[at(r * n + k)], b[r * size_ + condensed_[at(k)]]);
    };
    each([](double& own, double& given) { own = given; });
    rollcon::solve_condensed(condensed(), reduced_.data(), count);
    return each([](double& own, double& given) { given = own; });
  }
  const auto scale = [&](std::span<const std::int64_t> which, double* of, std::int64_t size, bool divide) {
    for (std::int64_t r = 0; r < count; ++r)
      for (std::int64_t k = 0; k < size; ++k) {
        const double s = scale_[which.empty() ? at(k) : at(which[at(k)])];
        of[r * size + k] *= divide ? 1 / s : s;
      }
  };
  Mumps& m = *mumps_;
  m->nrhs = static_cast<MUMPS_INT>(count);
  m->lrhs = static_cast<MUMPS_INT>(size_);
  m->rhs = b;
  const auto solve_part = [&](MUMPS_INT part) {
    m.control(26) = part;
    if (const MUMPS_INT status = m.run(solve_job); status < 0)
      fail(Status::err_internal, "MUMPS failed with status %d", status);
  };
  scale({}, b, size_, false);
  if (n == 0) {
    solve_part(0);
  } else {
    m->redrhs = reduced_.data();
    m->lredrhs = static_cast<MUMPS_INT>(n);
    solve_part(1);
    scale(condensed_, reduced_.data(), n, true);
    rollcon::solve_condensed(condensed(), reduced_.data(), count);
    scale(condensed_, reduced_.data(), n, true);
    solve_part(2);
  }
  scale({}, b, size_, false);
  ranks_.take_from_first(b, size_ * count * std::int64_t{sizeof(double)});
}

}  // namespace

#if ROLLCON_BUILD_MPI
std::unique_ptr<SparseFactor> factor_over_ranks(const SparseMatrix& matrix, std::span<const std::int64_t> condensed,
                                                const Ranks& ranks) {
  return std::make_unique<MumpsFactor>(matrix, condensed, ranks);
}
#endif

#if !ROLLCON_BUILD_CHOLMOD
std::unique_ptr<SparseFactor> factor_definite(const SparseMatrix& matrix, std::span<const std::int64_t> condensed,
                                              std::span<const std::int64_t> order) {
  return std::make_unique<MumpsFactor>(matrix, condensed, Ranks(), order);
}

// Orders by METIS through MUMPS's analysis, which takes another order where it has no METIS.
GraphOrder dissect(const SparseGroups& groups) {
  GraphOrder out;
  out.group.resize(at(groups.count));
  std::iota(out.group.begin(), out.group.end(), 0);
  if (groups.neighbour.empty()) return out;
  std::vector<MUMPS_INT> row, column;
  for (std::int64_t g = 0; g < groups.count; ++g)
    for (std::int64_t k = groups.start[at(g)]; k < groups.start[at(g + 1)]; ++k) {
      if (groups.neighbour[at(k)] < g) continue;
      row.push_back(static_cast<MUMPS_INT>(groups.neighbour[at(k)] + 1));
      column.push_back(static_cast<MUMPS_INT>(g + 1));
    }
  out.peak_bytes = 4 * sizeof(MUMPS_INT) * row.size();
  const MetisRandom random;
  Mumps m{Ranks()};
  m->n = static_cast<MUMPS_INT>(groups.count);
  m->nnz = static_cast<MUMPS_INT8>(row.size());
  m->irn = row.data();
  m->jcn = column.data();
  m.control(7) = 5;
  if (m.run(analyse) < 0) throw std::bad_alloc();
  for (std::size_t g = 0; g < out.group.size(); ++g)
    out.group[static_cast<std::size_t>(m->sym_perm[g] - 1)] = static_cast<std::int64_t>(g);
  return out;
}
#endif

}  // namespace rollcon
