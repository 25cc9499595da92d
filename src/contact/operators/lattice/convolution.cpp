#include "contact/operators/lattice/convolution.hpp"

#include <algorithm>

namespace rollcon {

namespace {

// Returns the largest offset: whole hats belong to inner nodes.
std::int64_t reach_of(std::int64_t nodes, const HatPiece& sources) {
  return nodes - (sources.whole() ? 2 : 1);
}

}  // namespace

Convolution::Convolution(const Lattice& lattice, const LatticeEntries& entries, const HatPiece& sources)
    : lattice_(lattice),
      reach_x_(reach_of(lattice.nx, sources)),
      reach_y_(reach_of(lattice.ny, sources)),
      source_(lattice.node.size(), -1),
      px_(fft_size(2 * reach_x_ + 1)),
      py_(fft_size(2 * reach_y_ + 1)),
      columns_(px_ / 2 + 1),
      mirrored_(entries.mirror(0, 0) != 0),
      kept_(mirrored_ ? py_ / 2 + 1 : py_),
      blocks_((columns_ + block - 1) / block),
      // Columns of a block must not fall on the same lines of a cache.
      column_stride_(AlignedArray<Complex>::stride(py_) + AlignedArray<Complex>::stride(1)),
      kept_stride_(AlignedArray<Complex>::stride(kept_)),
      along_(px_),
      across_(py_),
      products_(spectrum_products(instruction_set())),
      kinds_(entries.kinds()) {
  for (const EntryKinds::Kind& kind : kinds_.kind) {
    mirror_.push_back(entries.mirror(kind.r, kind.c));
    spectrum_.emplace_back(columns_ * kept_stride_);
    std::fill_n(spectrum_.back().data(), spectrum_.back().size(), Complex{});
  }
  for (const std::int32_t place : sources.places) {
    const auto at = static_cast<std::size_t>(place);
    source_[at] = lattice.node[at];
  }
  fill_rows(entries);
  transform_spectra();
}

/// Fills rows of entries, transformed along x; columns of spectrum_ then hold values by offset along y.
void Convolution::fill_rows(const LatticeEntries& entries) {
  const std::int64_t reach_x = reach_x_, reach_y = reach_y_;
  const std::int64_t count = 2 * reach_x + 1;
  const std::size_t kinds = kinds_.kind.size();
  std::vector<std::vector<double>> value(kinds, std::vector<double>(static_cast<std::size_t>(count)));
  double* entry[3][3] = {};
  for (std::size_t k = 0; k < kinds; ++k) entry[kinds_.kind[k].r][kinds_.kind[k].c] = value[k].data();
  AlignedArray<double> row(px_);
  std::fill_n(row.data(), px_, 0.0);
  const auto lines = static_cast<std::int64_t>(kinds) * block;
  const std::int64_t stride = AlignedArray<Complex>::stride(columns_);
  AlignedArray<Complex> half(lines * stride);  // [kind][row of a block][kx]
  LatticeEntries::Workspace w;
  const double scale = 1 / (static_cast<double>(px_) * static_cast<double>(py_));
  std::int64_t first = mirrored_ ? 0 : -reach_y;
  while (first <= reach_y) {
    const std::int64_t last = std::min({first + block - 1, reach_y, first < 0 ? -1 : reach_y});
    for (std::int64_t j = first; j <= last; ++j) {
      entries.row(j, -reach_x, count, entry, w);
      for (std::size_t k = 0; k < kinds; ++k) {
        for (std::int64_t i = 0; i < count; ++i)
          row.data()[i < reach_x ? px_ + i - reach_x : i - reach_x] = scale * value[k][static_cast<std::size_t>(i)];
        along_.forward(row.data(), half.data() + (static_cast<std::int64_t>(k) * block + j - first) * stride);
      }
    }
    for (std::size_t k = 0; k < kinds; ++k) {
      const Complex* from = half.data() + static_cast<std::int64_t>(k) * block * stride;
      Complex* to = spectrum_[k].data() + (first < 0 ? py_ + first : first);
      for (std::int64_t x = 0; x < columns_; ++x)
        for (std::int64_t j = 0; j <= last - first; ++j) to[x * kept_stride_ + j] = from[j * stride + x];
    }
    first = last + 1;
  }
}

void Convolution::transform_spectra() {
  AlignedArray<Complex> line(py_), waves(py_);
  for (std::size_t k = 0; k < spectrum_.size(); ++k)
    for (std::int64_t x = 0; x < columns_; ++x) {
      Complex* column = spectrum_[k].data() + x * kept_stride_;
      std::copy_n(column, kept_, line.data());
      if (mirrored_)
        for (std::int64_t j = 1; j < py_ - kept_ + 1; ++j)
          line.data()[py_ - j] = static_cast<double>(mirror_[k]) * column[j];
      across_.forward(line.data(), waves.data());
      std::copy_n(waves.data(), kept_, column);
    }
}

Convolution::Workspace::Workspace(const Convolution& owner)
    : row(owner.px_),
      waves(owner.blocks_ * block),
      half(owner.tile(3, 0)),
      column(3 * block * owner.column_stride_),
      sum(block * owner.column_stride_),
      line(owner.py_) {
  for (auto& rows : loaded) rows.resize(static_cast<std::size_t>(owner.lattice_.ny));
}

std::size_t Convolution::Workspace::bytes() const {
  return row.bytes() + waves.bytes() + half.bytes() + column.bytes() + sum.bytes() + line.bytes() +
         3 * loaded[0].size();
}

std::size_t Convolution::bytes() const {
  std::size_t sum = sizeof *this + source_.size() * sizeof(std::int32_t);
  for (const auto& s : spectrum_) sum += s.bytes();
  return sum;
}

/// Transforms the rows; returns false where there is nothing but zeros.
bool Convolution::transform_rows(int c, const double* lambda, Workspace& w) const {
  const std::int64_t nx = lattice_.nx, ny = lattice_.ny;
  double* row = w.row.data();
  std::fill_n(row, px_, 0.0);
  std::fill_n(w.waves.data(), w.waves.size(), Complex{});
  bool all = false;
  for (std::int64_t iy = 0; iy < ny; ++iy) {
    std::uint8_t& loaded = w.loaded[c][static_cast<std::size_t>(iy)];
    loaded = 0;
    const std::int32_t* source = source_.data() + iy * nx;
    bool any = false;
    for (std::int64_t ix = 0; ix < nx; ++ix) {
      const double v = source[ix] >= 0 ? lambda[source[ix]] : 0;
      any = any || v != 0;
      row[ix] = v;
    }
    if (!any) continue;
    loaded = 1;
    all = true;
    along_.forward(row, w.waves.data());
    for (std::int64_t k = 0; k < blocks_; ++k)
      std::copy_n(w.waves.data() + k * block, block, w.half.data() + tile(c, k) + iy * block);
  }
  return all;
}

void Convolution::convolve_columns(std::int64_t first, const bool (&source)[3], const bool (&target)[3],
                                   Workspace& w) const {
  const std::int64_t ny = lattice_.ny, count = std::min(block, columns_ - first);
  for (int c = 0; c < 3; ++c) {
    if (!source[c]) continue;
    Complex* column = w.column.data() + c * block * column_stride_;
    Complex* before = w.sum.data();
    const Complex* half = w.half.data() + tile(c, first / block);
    for (std::int64_t iy = 0; iy < ny; ++iy) {
      const bool loaded = w.loaded[c][static_cast<std::size_t>(iy)] != 0;
      for (std::int64_t b = 0; b < count; ++b)
        before[b * column_stride_ + iy] = loaded ? half[iy * block + b] : Complex{};
    }
    for (std::int64_t b = 0; b < count; ++b) {
      std::fill_n(before + b * column_stride_ + ny, py_ - ny, Complex{});
      across_.forward(before + b * column_stride_, column + b * column_stride_);
    }
  }
  for (int r = 0; r < 3; ++r) {
    if (!target[r]) continue;
    Complex* sum = w.sum.data();
    for (std::int64_t b = 0; b < count; ++b) {
      Complex* column = sum + b * column_stride_;
      if (multiply(r, first + b, source, w.column.data() + b * column_stride_, w.line.data()))
        across_.inverse(w.line.data(), column);
      else
        std::fill_n(column, ny, Complex{});
    }
    Complex* half = w.half.data() + tile(r, first / block);
    for (std::int64_t iy = 0; iy < ny; ++iy)
      for (std::int64_t b = 0; b < count; ++b) half[iy * block + b] = sum[b * column_stride_ + iy];
  }
}

/// Finds the spectrum of image r at kx; returns false if it is zero. fields: component c is at c * block columns.
bool Convolution::multiply(int r, std::int64_t kx, const bool (&source)[3], const Complex* fields, Complex* sum) const {
  SpectrumProduct job, mirror;
  for (int c = 0; c < 3; ++c) {
    const EntryKinds::Use& use = kinds_.use[r][c];
    if (!source[c] || use.kind < 0) continue;
    const auto kind = static_cast<std::size_t>(use.kind);
    const Complex* spectrum = spectrum_[kind].data() + kx * kept_stride_;
    const Complex* field = fields + c * block * column_stride_;
    job.spectrum[job.terms] = reinterpret_cast<const double*>(spectrum);
    job.field[job.terms] = reinterpret_cast<const double*>(field);
    job.factor[job.terms] = use.sign;
    mirror.spectrum[job.terms] = reinterpret_cast<const double*>(spectrum + 1);
    mirror.field[job.terms] = reinterpret_cast<const double*>(field + kept_);
    mirror.factor[job.terms] = use.sign * mirror_[kind];
    ++job.terms;
  }
  if (job.terms == 0) return false;
  job.count = kept_;
  job.sum = reinterpret_cast<double*>(sum);
  products_.same(job);
  if (!mirrored_) return true;
  mirror.terms = job.terms;
  mirror.count = py_ - kept_;
  mirror.sum = reinterpret_cast<double*>(sum + kept_);
  products_.reversed(mirror);
  return true;
}

void Convolution::run(const double* const (&lambda)[3], double* const (&image)[3], Workspace& w, bool add) const {
  const std::int64_t nx = lattice_.nx, ny = lattice_.ny;
  bool source[3], target[3];
  for (int c = 0; c < 3; ++c) {
    source[c] = lambda[c] != nullptr && transform_rows(c, lambda[c], w);
    target[c] = image[c] != nullptr;
  }
  for (std::int64_t first = 0; first < columns_; first += block) convolve_columns(first, source, target, w);
  double* row = w.row.data();
  for (int r = 0; r < 3; ++r) {
    if (!target[r]) continue;
    for (std::int64_t iy = 0; iy < ny; ++iy) {
      for (std::int64_t k = 0; k < blocks_; ++k)
        std::copy_n(w.half.data() + tile(r, k) + iy * block, block, w.waves.data() + k * block);
      along_.inverse(w.waves.data(), row);
      const std::int32_t* node = lattice_.node.data() + iy * nx;
      for (std::int64_t ix = 0; ix < nx; ++ix) {
        if (node[ix] < 0) continue;
        double& to = image[r][node[ix]];
        to = add ? to + row[ix] : row[ix];
      }
    }
  }
}

}  // namespace rollcon
