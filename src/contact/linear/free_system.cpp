#include "contact/linear/free_system.hpp"

#include <algorithm>
#include <cmath>

#include "linalg/lapack.hpp"

namespace rollcon {
namespace {

// Says whether e (own, slip) = (e, any, 0), so that the row along e has the node's own tractions alone.
bool gives_traction(const TangentialLaw& law, double (&e)[2]) {
  if (!law.sliding) return false;
  constexpr double rounding = 1e-12;
  e[0] = law.direction[0], e[1] = law.direction[1];
  if (e[0] == 0 && e[1] == 0) e[0] = 1;
  for (int c = 0; c < 2; ++c) {
    const double slip = e[0] * law.slip[0][c] + e[1] * law.slip[1][c];
    const double own = e[0] * law.own[0][c] + e[1] * law.own[1][c];
    if (std::abs(slip) > rounding || std::abs(own - e[c]) > rounding) return false;
  }
  return true;
}

}  // namespace

void FreeSystem::take(ReducedSystem& system) {
  system_ = &system;
  na_ = static_cast<std::size_t>(system.active());
  tangential_ = system.part() != Part::normal;
  normal_ = system.part() != Part::tangential;
  whole_.clear();
  if (tangential_) {
    whole_.reserve(na_);
    for (int c = 0; c < 2; ++c)
      for (auto* v : {&across_[c], &along_[c], &slip_[c]}) v->resize(na_);
    for (std::size_t a = 0; a < na_; ++a) {
      const TangentialLaw& law = system.law(static_cast<std::int64_t>(a));
      double e[2];
      if (gives_traction(law, e)) {
        const double ratio = e[0] * law.own[0][2] + e[1] * law.own[1][2];
        across_[0][a] = -e[1], across_[1][a] = e[0];
        for (int c = 0; c < 2; ++c) along_[c][a] = -ratio * e[c], slip_[c][a] = e[c];
        continue;
      }
      whole_.push_back(static_cast<std::int32_t>(a));
      across_[0][a] = 1, across_[1][a] = 0;
      for (int c = 0; c < 2; ++c) along_[c][a] = slip_[c][a] = 0;
    }
  }
  size_ = size(Rows::all);
  const auto full = static_cast<std::size_t>(system.size());
  for (auto* v : {&x_, &y_, &row_, &given_})
    if (v->size() < full) v->resize(with_room(full));
}

std::int64_t FreeSystem::borders(Rows rows) const {
  const int all = system_->borders();
  if (rows == Rows::all) return all;
  int normal = 0;
  while (normal < all && changes_gap(system_->border_motion(all - 1 - normal))) ++normal;
  return rows == Rows::normal ? normal : all - normal;
}

std::int64_t FreeSystem::size(Rows rows) const {
  std::int64_t n = borders(rows);
  if (tangential_ && rows != Rows::normal) n += active() + static_cast<std::int64_t>(whole_.size());
  if (normal_ && rows != Rows::tangential) n += active();
  return n;
}

void FreeSystem::write_across(const double* y, double* x) const {
  for (std::size_t a = 0; a < na_; ++a) {
    x[a] = across_[0][a] * y[a];
    x[na_ + a] = across_[1][a] * y[a];
  }
  for (std::size_t k = 0; k < whole_.size(); ++k) x[na_ + static_cast<std::size_t>(whole_[k])] = y[na_ + k];
}

// Writes free unknowns y in the order of all unknowns.
void FreeSystem::write(const double* y, double* x) const {
  const std::size_t na = na_, nw = whole_.size();
  double* const end = x + system_->size();
  if (tangential_) {
    write_across(y, x);
    y += na + nw;
    if (normal_)
      for (std::size_t a = 0; a < na; ++a) {
        x[a] += along_[0][a] * y[a];
        x[na + a] += along_[1][a] * y[a];
      }
    x += 2 * na;
  }
  std::copy(y, y + (end - x), x);
}

void FreeSystem::select(const double* full, double* free) const {
  const std::size_t na = na_, nw = whole_.size();
  const double* const end = full + system_->size();
  if (tangential_) {
    for (std::size_t a = 0; a < na; ++a) free[a] = across_[0][a] * full[a] + across_[1][a] * full[na + a];
    for (std::size_t k = 0; k < nw; ++k) free[na + k] = full[na + static_cast<std::size_t>(whole_[k])];
    free += na + nw;
    full += 2 * na;
  }
  std::copy(full, end, free);
}

void FreeSystem::reduce(const std::vector<double>& whole, std::vector<double>& b) {
  const std::size_t na = na_;
  const auto full = static_cast<std::size_t>(system_->size());
  if (b.size() < static_cast<std::size_t>(size_)) b.resize(with_room(full));
  any_given_ = false;
  if (tangential_ && whole_.size() < na) {
    std::fill(given_.begin(), given_.begin() + static_cast<std::ptrdiff_t>(full), 0.0);
    for (std::size_t a = 0; a < na; ++a) {
      const double value = slip_[0][a] * whole[a] + slip_[1][a] * whole[na + a];
      any_given_ = any_given_ || value != 0;
      given_[a] = slip_[0][a] * value;
      given_[na + a] = slip_[1][a] * value;
    }
  }
  if (!any_given_) return select(whole.data(), b.data());
  system_->apply(given_.data(), y_.data());
  product_.assign(system_->product().begin(), system_->product().end());
  for (std::size_t i = 0; i < full; ++i) y_[i] = whole[i] - y_[i];
  select(y_.data(), b.data());
}

void FreeSystem::expand(const double* y, double* x) {
  write(y, x);
  if (!any_given_) return;
  for (std::size_t i = 0; i < 2 * na_; ++i) x[i] += given_[i];
  system_->add_to_product(product_);
}

void FreeSystem::apply(const double* y, double* out) {
  write(y, x_.data());
  system_->apply(x_.data(), y_.data());
  select(y_.data(), out);
}

void FreeSystem::subtract_from_normal(const double* y, double* out) {
  const std::size_t na = na_;
  double* x = x_.data();
  write_across(y, x);
  const int columns = static_cast<int>(2 * na), rows = static_cast<int>(na), one = 1;
  const int stride = static_cast<int>(3 * na);
  const double minus = -1, add = 1;
  if (rows > 0)
    dgemv_("T", &columns, &rows, &minus, system_->row(2 * static_cast<std::int64_t>(na)), &stride, x, &one, &add, out,
           &one);
}

// Turns one row over all tractions into one over free unknowns.
template <class T>
void FreeSystem::columns(Rows rows, const double* row, T* out) const {
  const std::size_t na = na_;
  if (tangential_ && rows != Rows::normal) {
    const double *c1 = across_[0].data(), *c2 = across_[1].data();
    for (std::size_t a = 0; a < na; ++a) out[a] = static_cast<T>(c1[a] * row[a] + c2[a] * row[na + a]);
    out += na;
    for (const std::int32_t a : whole_) *out++ = static_cast<T>(row[na + static_cast<std::size_t>(a)]);
  }
  if (!normal_ || rows == Rows::tangential) return;
  const double* normal = row + (tangential_ ? 2 * na : 0);
  if (!tangential_ || rows == Rows::normal) {
    for (std::size_t a = 0; a < na; ++a) out[a] = static_cast<T>(normal[a]);
    return;
  }
  const double *n1 = along_[0].data(), *n2 = along_[1].data();
  for (std::size_t a = 0; a < na; ++a) out[a] = static_cast<T>(normal[a] + n1[a] * row[a] + n2[a] * row[na + a]);
}

template <class T>
void FreeSystem::dense(Rows rows, T* out) {
  const std::size_t na = na_;
  const std::int64_t n = size(rows), last = borders(rows), tractions = n - last;
  const int first_border = rows == Rows::normal ? system_->borders() - static_cast<int>(last) : 0;
  const auto entry = [&](std::span<const double> values, std::size_t a) { return values.empty() ? 0.0 : values[a]; };
  const auto with_tangential = static_cast<std::int64_t>(tangential_ ? 2 * na : 0);
  const std::size_t needed =
      rows == Rows::tangential ? 2 * na : static_cast<std::size_t>(with_tangential) + (normal_ ? na : 0);
  // Rows are q1 (slip row 1) + q2 (slip row 2) + own tractions of node a.
  const auto tangential_row = [&](std::size_t a, const double(&q)[2], const double(&own)[3]) {
    const auto i = static_cast<std::int64_t>(a);
    const double *m1 = system_->row(i), *m2 = system_->row(static_cast<std::int64_t>(na) + i);
    const bool plain = own[0] == 0 && own[1] == 0 && own[2] == 0;
    if (plain && q[0] == 1 && q[1] == 0) {
      columns(rows, m1, out);
    } else if (plain && q[0] == 0 && q[1] == 1) {
      columns(rows, m2, out);
    } else {
      double* row = row_.data();
      for (std::size_t j = 0; j < needed; ++j) row[j] = q[0] * m1[j] + q[1] * m2[j];
      row[a] += own[0];
      row[na + a] += own[1];
      if (needed > 2 * na) row[2 * na + a] += own[2];
      columns(rows, row, out);
    }
    for (int k = 0; k < static_cast<int>(last); ++k)
      out[tractions + k] = static_cast<T>(q[0] * entry(system_->border_column_part(first_border + k, 0), a) +
                                          q[1] * entry(system_->border_column_part(first_border + k, 1), a));
    out += n;
  };
  if (tangential_ && rows != Rows::normal) {
    for (std::size_t a = 0; a < na; ++a) {
      const TangentialLaw& law = system_->law(static_cast<std::int64_t>(a));
      const double c1 = across_[0][a], c2 = across_[1][a];
      tangential_row(a, {c1 * law.slip[0][0] + c2 * law.slip[1][0], c1 * law.slip[0][1] + c2 * law.slip[1][1]},
                     {c1 * law.own[0][0] + c2 * law.own[1][0], c1 * law.own[0][1] + c2 * law.own[1][1],
                      c1 * law.own[0][2] + c2 * law.own[1][2]});
    }
    for (const std::int32_t k : whole_) {
      const TangentialLaw& law = system_->law(k);
      tangential_row(static_cast<std::size_t>(k), {law.slip[1][0], law.slip[1][1]},
                     {law.own[1][0], law.own[1][1], law.own[1][2]});
    }
  }
  if (normal_ && rows != Rows::tangential)
    for (std::size_t a = 0; a < na; ++a, out += n) {
      columns(rows, system_->row(with_tangential + static_cast<std::int64_t>(a)), out);
      for (int k = 0; k < static_cast<int>(last); ++k)
        out[tractions + k] = static_cast<T>(entry(system_->border_column_part(first_border + k, 2), a));
    }
  for (int k = 0; k < static_cast<int>(last); ++k, out += n) {
    double* row = row_.data();
    for (int r = 0; r < system_->components(); ++r) {
      const auto values = system_->border_row_part(first_border + k, system_->component(r));
      for (std::size_t a = 0; a < na; ++a) *row++ = entry(values, a);
    }
    columns(rows, row_.data(), out);
    std::fill(out + tractions, out + n, T{0});
  }
}

template void FreeSystem::dense<double>(Rows, double*);
template void FreeSystem::dense<float>(Rows, float*);

std::size_t FreeSystem::bytes() const {
  std::size_t sum = x_.capacity() + y_.capacity() + row_.capacity() + given_.capacity() + product_.capacity();
  for (int c = 0; c < 2; ++c) sum += across_[c].capacity() + along_[c].capacity() + slip_[c].capacity();
  return sum * sizeof(double) + whole_.capacity() * sizeof(std::int32_t);
}

}  // namespace rollcon
