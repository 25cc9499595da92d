#include "contact/lattice/rim.hpp"

#include <algorithm>

namespace rollcon {
namespace {

bool along_x(RimSide side) {
  return side == RimSide::low_y || side == RimSide::high_y;
}

bool high(RimSide side) {
  return side == RimSide::high_x || side == RimSide::high_y;
}

LatticeEntries side_entries(const Lattice& lattice, HalfspaceConstants c, double delta,
                            RimSide side) {
  const Hat half = high(side) ? Hat::before : Hat::after;
  return {lattice, c, delta, along_x(side) ? Hat::whole : half, along_x(side) ? half : Hat::whole};
}

template <class T>
void grow(AlignedArray<T>& array, std::int64_t n) {
  if (array.size() < n) array = AlignedArray<T>(n);
}

}  // namespace

std::size_t RimWorkspace::bytes() const {
  return line.bytes() + source[0].bytes() + source[1].bytes() + source[2].bytes() + sum.bytes();
}

std::int32_t SideColumns::node(std::int64_t p, std::int64_t q) const {
  const std::int64_t away = high(side_) ? depth_ - 1 - p : p;
  const std::int64_t at = along_x(side_) ? away * lattice_.nx + q : q * lattice_.nx + away;
  return lattice_.node[static_cast<std::size_t>(at)];
}

SideColumns::SideColumns(const Lattice& lattice, HalfspaceConstants c, double delta, RimSide side)
    : lattice_(lattice),
      side_(side),
      length_(along_x(side) ? lattice.nx : lattice.ny),
      depth_(along_x(side) ? lattice.ny : lattice.nx),
      padded_(fft_size(2 * length_ - 3)),
      columns_(padded_ / 2 + 1),
      stride_(AlignedArray<Complex>::stride(columns_)),
      fft_(padded_) {
  const LatticeEntries entries = side_entries(lattice, c, delta, side);
  kinds_ = entries.kinds();
  const std::size_t kinds = kinds_.kind.size();
  // Entries along the side, line by line; rows of entries run along x.
  const std::int64_t real_stride = AlignedArray<double>::stride(padded_), reach = length_ - 2;
  std::vector<AlignedArray<double>> table;
  for (std::size_t k = 0; k < kinds; ++k) {
    table.emplace_back(depth_ * real_stride);
    std::fill_n(table[k].data(), table[k].size(), 0.0);
  }
  const auto place = [&](std::int64_t p, std::int64_t offset) {
    return p * real_stride + (offset < 0 ? padded_ + offset : offset);
  };
  const std::int64_t count = along_x(side) ? 2 * reach + 1 : depth_;
  std::vector<std::vector<double>> value(kinds,
                                         std::vector<double>(static_cast<std::size_t>(count)));
  double* entry[3][3] = {};
  for (std::size_t k = 0; k < kinds; ++k)
    entry[kinds_.kind[k].r][kinds_.kind[k].c] = value[k].data();
  LatticeEntries::Workspace w;
  if (along_x(side)) {
    for (std::int64_t p = 0; p < depth_; ++p) {
      entries.row(high(side) ? -p : p, -reach, count, entry, w);
      for (std::size_t k = 0; k < kinds; ++k)
        for (std::int64_t m = 0; m < count; ++m)
          table[k].data()[place(p, m - reach)] = value[k][static_cast<std::size_t>(m)];
    }
  } else {
    for (std::int64_t j = -reach; j <= reach; ++j) {
      entries.row(j, high(side) ? -(depth_ - 1) : 0, count, entry, w);
      for (std::size_t k = 0; k < kinds; ++k)
        for (std::int64_t m = 0; m < count; ++m)
          table[k].data()[place(high(side) ? depth_ - 1 - m : m, j)] =
              value[k][static_cast<std::size_t>(m)];
    }
  }
  const double scale = 1 / static_cast<double>(padded_);
  for (std::size_t k = 0; k < kinds; ++k) {
    spectrum_.emplace_back(depth_ * stride_);
    for (std::int64_t p = 0; p < depth_; ++p) {
      double* line = table[k].data() + p * real_stride;
      for (std::int64_t q = 0; q < padded_; ++q) line[q] *= scale;
      fft_.forward(line, spectrum_[k].data() + p * stride_);
    }
    table[k] = {};
  }
}

void SideColumns::add(const double* const (&lambda)[3], double* const (&image)[3],
                      RimWorkspace& w) const {
  grow(w.line, padded_);
  grow(w.sum, columns_);
  for (int c = 0; c < 3; ++c) {
    if (lambda[c] == nullptr) continue;
    grow(w.source[c], columns_);
    std::fill_n(w.line.data(), padded_, 0.0);
    for (std::int64_t q = 1; q < length_ - 1; ++q) w.line.data()[q] = lambda[c][node(0, q)];
    fft_.forward(w.line.data(), w.source[c].data());
  }
  for (std::int64_t p = 0; p < depth_; ++p)
    for (int r = 0; r < 3; ++r) {
      if (image[r] == nullptr) continue;
      Complex* sum = w.sum.data();
      std::fill_n(sum, columns_, Complex{});
      bool any = false;
      for (int c = 0; c < 3; ++c) {
        const EntryKinds::Use& use = kinds_.use[r][c];
        if (lambda[c] == nullptr || use.kind < 0) continue;
        any = true;
        const Complex* s = spectrum_[static_cast<std::size_t>(use.kind)].data() + p * stride_;
        const Complex* l = w.source[c].data();
        for (std::int64_t k = 0; k < columns_; ++k) {
          const double re = use.sign * s[k].real(), im = use.sign * s[k].imag();
          sum[k] +=
              Complex(re * l[k].real() - im * l[k].imag(), re * l[k].imag() + im * l[k].real());
        }
      }
      if (!any) continue;
      fft_.inverse(sum, w.line.data());
      for (std::int64_t q = 0; q < length_; ++q) image[r][node(p, q)] += w.line.data()[q];
    }
}

std::size_t SideColumns::bytes() const {
  std::size_t sum = sizeof *this;
  for (const auto& s : spectrum_) sum += s.bytes();
  return sum;
}

CornerColumns::CornerColumns(const Lattice& lattice, HalfspaceConstants c, double delta,
                             bool high_x, bool high_y)
    : lattice_(lattice) {
  const std::int64_t nx = lattice.nx, ny = lattice.ny;
  const std::int64_t x = high_x ? nx - 1 : 0, y = high_y ? ny - 1 : 0;
  node_ = lattice.node[static_cast<std::size_t>(y * nx + x)];
  const LatticeEntries entries(lattice, c, delta, high_x ? Hat::before : Hat::after,
                               high_y ? Hat::before : Hat::after);
  kinds_ = entries.kinds();
  value_.assign(kinds_.kind.size(), std::vector<double>(static_cast<std::size_t>(nx * ny)));
  LatticeEntries::Workspace w;
  for (std::int64_t iy = 0; iy < ny; ++iy) {
    double* entry[3][3] = {};
    for (std::size_t k = 0; k < value_.size(); ++k)
      entry[kinds_.kind[k].r][kinds_.kind[k].c] = value_[k].data() + iy * nx;
    entries.row(iy - y, -x, nx, entry, w);
  }
}

void CornerColumns::add(const double* const (&lambda)[3], double* const (&image)[3]) const {
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) {
      const EntryKinds::Use& use = kinds_.use[r][c];
      if (image[r] == nullptr || lambda[c] == nullptr || use.kind < 0) continue;
      const double t = use.sign * lambda[c][node_];
      if (t == 0) continue;
      const double* value = value_[static_cast<std::size_t>(use.kind)].data();
      for (std::size_t k = 0; k < lattice_.node.size(); ++k)
        image[r][lattice_.node[k]] += t * value[k];
    }
}

std::size_t CornerColumns::bytes() const {
  std::size_t sum = sizeof *this;
  for (const auto& v : value_) sum += v.size() * sizeof(double);
  return sum;
}

Rim::Rim(const Lattice& lattice, HalfspaceConstants c, double delta)
    : lattice_(lattice), c_(c), delta_(delta) {
  const std::int64_t nx = lattice.nx, ny = lattice.ny;
  const auto node = [&](std::int64_t x, std::int64_t y) {
    return lattice.node[static_cast<std::size_t>(y * nx + x)];
  };
  for (std::int64_t y = 1; y < ny - 1; ++y) {
    nodes_[0].push_back(node(0, y));
    nodes_[1].push_back(node(nx - 1, y));
  }
  for (std::int64_t x = 1; x < nx - 1; ++x) {
    nodes_[2].push_back(node(x, 0));
    nodes_[3].push_back(node(x, ny - 1));
  }
  for (int k = 0; k < 4; ++k) corner_[k] = node(k % 2 == 0 ? 0 : nx - 1, k < 2 ? 0 : ny - 1);
}

void Rim::add(const double* const (&lambda)[3], double* const (&image)[3], RimWorkspace& w) {
  const auto loaded = [&](std::int32_t k) {
    for (const double* t : lambda)
      if (t != nullptr && t[k] != 0) return true;
    return false;
  };
  for (int s = 0; s < 4; ++s) {
    if (std::none_of(nodes_[s].begin(), nodes_[s].end(), loaded)) continue;
    {
      const std::lock_guard guard(making_);
      if (!side_[s])
        side_[s] = std::make_unique<SideColumns>(lattice_, c_, delta_, static_cast<RimSide>(s));
    }
    side_[s]->add(lambda, image, w);
  }
  for (int k = 0; k < 4; ++k) {
    if (!loaded(corner_[k])) continue;
    {
      const std::lock_guard guard(making_);
      if (!corner_columns_[k])
        corner_columns_[k] =
            std::make_unique<CornerColumns>(lattice_, c_, delta_, k % 2 != 0, k >= 2);
    }
    corner_columns_[k]->add(lambda, image);
  }
}

std::size_t Rim::bytes() {
  const std::lock_guard guard(making_);
  std::size_t sum = sizeof *this;
  for (const auto& nodes : nodes_) sum += nodes.size() * sizeof(std::int32_t);
  for (const auto& side : side_) sum += side ? side->bytes() : 0;
  for (const auto& corner : corner_columns_) sum += corner ? corner->bytes() : 0;
  return sum;
}

}  // namespace rollcon
