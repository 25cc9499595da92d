/// Entries of the core of the monolithic system, column by column.

#include <algorithm>

#include "procedures/monolithic_core.hpp"
#include "support/index.hpp"

namespace rollcon {
namespace {

struct SparseSink {
  SparseMatrix& out;
  void operator()(std::int64_t row, double value) const {
    out.row.push_back(row);
    out.value.push_back(value);
  }
  void next() const { out.start.push_back(static_cast<std::int64_t>(out.row.size())); }
};

struct DenseSink {
  double* column;
  std::int64_t n;
  void operator()(std::int64_t row, double value) const { column[row] += value; }
  void next() { column += n; }
};

/// Adds up what falls on the same row.
class Merger {
 public:
  explicit Merger(std::int64_t rows) : sum_(at(rows)), seen_(at(rows), 0) {}
  void add(std::int64_t row, double value) {
    if (!seen_[at(row)]) {
      seen_[at(row)] = 1;
      rows_.push_back(row);
    }
    sum_[at(row)] += value;
  }
  template <class Sink>
  void flush(Sink& sink) {
    std::sort(rows_.begin(), rows_.end());
    for (const std::int64_t row : rows_) {
      sink(row, sum_[at(row)]);
      sum_[at(row)] = 0;
      seen_[at(row)] = 0;
    }
    rows_.clear();
  }

 private:
  std::vector<double> sum_;
  std::vector<char> seen_;
  std::vector<std::int64_t> rows_;
};

}  // namespace

template <class Sink>
void MonolithicCore::columns(Sink& sink) const {
  const MonolithicBodies& bodies = matrix_->bodies();
  Merger merger(size());
  for (const MonolithicBodies::Body& body : bodies.bodies()) {
    const BodyEquations& e = *body.equations;
    for (std::int64_t j = 0; j < e.unknowns; ++j) {
      const double scale = body.column[at(j)];
      if (e.dense.empty()) {
        for (std::int64_t i = e.matrix.start[at(j)]; i < e.matrix.start[at(j + 1)]; ++i) {
          const std::int64_t row = e.matrix.row[at(i)];
          sink(body.first + row, body.row[at(row)] * e.matrix.value[at(i)] * scale);
        }
      } else {
        const double* column = e.dense.data() + j * e.unknowns;
        for (std::int64_t i = 0; i < e.unknowns; ++i)
          sink(body.first + i, body.row[at(i)] * column[i] * scale);
      }
      for (std::int64_t i = body.unknown.start[at(j)]; i < body.unknown.start[at(j + 1)]; ++i) {
        const std::size_t place = at(body.unknown.row[at(i)]);
        for (std::size_t u = user_start_[place]; u < user_start_[place + 1]; ++u)
          merger.add(first() + static_cast<std::int64_t>(user_[u].first),
                     user_[u].second * body.unknown.value[at(i)] * scale);
      }
      merger.flush(sink);
      sink.next();
    }
  }
  const double* direct = bodies.direct();
  std::vector<double> u(direct ? at(bodies.places()) : 0);
  for (std::size_t b = 0; b < unknown_.size(); ++b) {
    const Unknown& unknown = unknown_[b];
    const std::int64_t k = unknown.node;
    std::fill(u.begin(), u.end(), 0.0);
    for (int c = 0; c < 3; ++c) {
      const double t = unknown.traction[at(c)];
      if (t == 0) continue;
      for (const MonolithicBodies::Body& body : bodies.bodies())
        for (std::int64_t i = body.load.start[at(3 * k + c)];
             i < body.load.start[at(3 * k + c + 1)]; ++i) {
          const std::int64_t row = body.load.row[at(i)];
          merger.add(body.first + row, -t * body.row[at(row)] * body.load.value[at(i)]);
        }
      if (direct) axpy(t, direct + (3 * k + c) * bodies.places(), u.data(), bodies.places());
    }
    merger.flush(sink);
    const std::size_t from = of_node_[at(k)], to = of_node_[at(k + 1)];
    for (std::size_t a = direct ? 0 : from; a < (direct ? unknown_.size() : to); ++a) {
      double value = unknown_[a].node == k ? own(a, b) : 0;
      if (direct) row(a, [&](std::int64_t place, double w) { value += w * u[at(place)]; });
      if (value != 0 || unknown_[a].node == k) sink(first() + static_cast<std::int64_t>(a), value);
    }
    for (std::size_t m = 0; m < borders(); ++m)
      if (const double v = load(m, b); v != 0) sink(motion_ + static_cast<std::int64_t>(m), v);
    sink.next();
  }
  for (std::size_t m = 0; m < borders(); ++m) {
    for (std::size_t a = 0; a < unknown_.size(); ++a)
      if (const double v = border(a, m); v != 0) sink(first() + static_cast<std::int64_t>(a), v);
    sink.next();
  }
}

void MonolithicCore::assemble(SparseMatrix& out) const {
  out.rows = out.columns = size();
  out.start.assign(1, 0);
  out.row.clear();
  out.value.clear();
  SparseSink sink{out};
  columns(sink);
}

void MonolithicCore::assemble(double* dense) const {
  std::fill_n(dense, size() * size(), 0.0);
  DenseSink sink{dense, size()};
  columns(sink);
}

}  // namespace rollcon
