#pragma once
/// Keeps what a body's surface answered: for each set of faces and each layer, the latest used ones up to a number of
/// bytes.

#include <cstddef>
#include <list>
#include <mutex>

#include "bodies/model/surface_response.hpp"

namespace rollcon {

class ResponseCache : public SurfaceResponse {
 public:
  std::shared_ptr<const SurfaceRows> rows(const LoadedSurface& surface, int threads) final;
  std::shared_ptr<const SurfaceLoads> loads(const LoadedSurface& surface, int threads) final;
  void add_kept(SectionReader& file) final;

 protected:
  /// The surface must outlive it. most_bytes: beyond them what was not used for longest is dropped, but never what was
  /// used last.
  ResponseCache(const SurfaceMesh& surface, std::int64_t most_bytes)
      : surface_(surface), most_bytes_(static_cast<std::size_t>(most_bytes)) {}
  /// Rows and columns are set; u is to be filled. Called with the mutex held.
  virtual void respond(const LoadedSurface& surface, SurfaceRows& rows, int threads) = 0;
  /// Likewise: load and unknown are to be filled.
  virtual void load(const LoadedSurface& surface, SurfaceLoads& loads, int threads) = 0;

  // With the mutex held.
  std::size_t kept_bytes() const;
  /// Counts of what is kept and was dropped.
  void count_kept(BodyStatistics& statistics) const;
  /// Section "kept".
  void save_kept(SectionWriter& file) const;

  const SurfaceMesh& surface_;
  mutable std::mutex mutex_;

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
  template <class Archive, class Rows>
  void content(Archive& ar, auto& surface, Rows& rows) const;

  std::size_t most_bytes_;
  std::list<Kept> kept_;  ///< latest used first
  std::int64_t dropped_ = 0;
  std::vector<Lent> lent_;
};

}  // namespace rollcon
