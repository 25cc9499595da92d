#pragma once
/// Does what bodies with equations have in common. It keeps responses for each set of faces and each layer, the latest
/// used ones up to a number of bytes; these and the factors go to and from files.

#include <cstddef>
#include <list>
#include <mutex>

#include "bodies/model/surface_response.hpp"

namespace rollcon {

class ResponseCache : public Condensed, public AsEquations, public Saved {
 public:
  std::shared_ptr<const SurfaceRows> rows(const LoadedSurface& surface, int threads) final;
  std::shared_ptr<const SurfaceLoads> loads(const LoadedSurface& surface, int threads) final;
  const OwnLoads& own() const final { return own_; }
  AsEquations* as_equations() override { return this; }
  Saved* saved() final { return this; }
  std::int64_t solvable() const final;
  void save(SectionWriter& file, const OwnLoads& own) const final;
  void add_kept(SectionReader& file) final;

 protected:
  /// Takes a surface, which must outlive it, and the bytes beyond which what was not used for longest is dropped, but
  /// never what was used last.
  ResponseCache(const SurfaceMesh& surface, std::int64_t most_bytes)
      : surface_(surface), most_bytes_(static_cast<std::size_t>(most_bytes)) {}

  // These functions are called with the mutex held.

  /// Fills u; rows and columns are set.
  virtual void respond(const LoadedSurface& surface, SurfaceRows& rows, int threads) = 0;
  /// Fills load and unknown.
  virtual void load(const LoadedSurface& surface, SurfaceLoads& loads, int threads) = 0;
  /// Returns a checksum of the order of unknowns and equations, which factors belong to.
  virtual std::uint64_t numbering() const = 0;
  /// Returns how many unknowns the factors solve for; 0: there are no factors.
  virtual std::int64_t factored() const = 0;
  /// Writes section "factors", its beginning and end apart.
  virtual void write_factors(SectionWriter& file) const = 0;
  virtual void read_factors(SectionReader& file) = 0;

  std::size_t kept_bytes() const;
  /// Returns statistics with the counts of what is kept and was dropped; `bytes` are added to those of what is kept.
  BodyStatistics statistics_with(std::size_t bytes) const;
  void count_peak(std::size_t bytes);
  /// Throws err_argument where displacements under own loads are not finite.
  static void require_no_overflow(std::span<const double> u);
  /// Takes what save() wrote. displacements, tractions: counts of numbers that own loads have, if there are any.
  void restore(SectionReader& file, std::size_t displacements, std::size_t tractions);

  const SurfaceMesh& surface_;
  mutable std::mutex mutex_;
  OwnLoads own_;
  BodyStatistics statistics_;
  std::weak_ptr<const BodyEquations> equations_;

 private:
  struct Kept {
    LoadedSurface surface;
    std::shared_ptr<const SurfaceRows> rows;
    std::size_t bytes() const;
  };
  struct Lent {
    LoadedSurface surface;
    std::weak_ptr<const SurfaceLoads> loads;
  };
  void set_outline(const LoadedSurface& surface, SurfaceOutline& outline) const;
  std::shared_ptr<const SurfaceRows> find(const LoadedSurface& surface);
  void drop();

  std::size_t most_bytes_;
  std::list<Kept> kept_;  ///< responses, the latest used first
  std::int64_t dropped_ = 0;
  std::vector<Lent> lent_;
};

}  // namespace rollcon
