#pragma once
/// Keeps what a body's surface answered: for each set of faces and each layer, the latest used ones
/// up to a number of bytes.

#include <cstddef>
#include <list>
#include <map>
#include <mutex>

#include "bodies/model/surface_response.hpp"

namespace rollcon {

class ResponseCache : public SurfaceResponse {
 public:
  std::shared_ptr<const SurfaceRows> faces(std::span<const std::int64_t> face, int threads) final;
  std::shared_ptr<const SurfaceRows> layer(const SurfaceMesh& layer,
                                           std::span<const std::int32_t> row, int threads) final;
  std::shared_ptr<const SurfaceLoads> loads_of_faces(std::span<const std::int64_t> face,
                                                     int threads) final;
  std::shared_ptr<const SurfaceLoads> loads_of_layer(const SurfaceMesh& layer,
                                                     std::span<const std::int32_t> row,
                                                     int threads) final;
  void add_kept(SectionReader& file) final;

 protected:
  /// The surface must outlive it. most_bytes: beyond them what was not used for longest is dropped,
  /// but never what was used last.
  ResponseCache(const SurfaceMesh& surface, std::int64_t most_bytes)
      : surface_(surface), most_bytes_(static_cast<std::size_t>(most_bytes)) {}
  /// Rows and columns are set; u is to be filled. Called with the mutex held.
  virtual void respond(std::span<const std::int64_t> face, SurfaceRows& rows, int threads) = 0;
  virtual void respond(const SurfaceMesh& layer, SurfaceRows& rows, int threads) = 0;
  /// Likewise: load and unknown are to be filled.
  virtual void load(std::span<const std::int64_t> face, SurfaceLoads& loads, int threads) = 0;
  virtual void load(const SurfaceMesh& layer, SurfaceLoads& loads, int threads) = 0;

  // With the mutex held.
  std::size_t kept_bytes() const;
  /// Counts of what is kept and was dropped.
  void count_kept(BodyStatistics& statistics) const;
  /// Section "kept".
  void save_kept(SectionWriter& file) const;

  const SurfaceMesh& surface_;
  mutable std::mutex mutex_;

 private:
  /// Of tractions on faces, or on a layer.
  struct Kept {
    std::vector<std::int64_t> face;
    SurfaceMesh layer;
    std::shared_ptr<const SurfaceRows> rows;
    std::size_t bytes() const;
  };
  void outline_faces(const std::vector<std::int64_t>& face, SurfaceOutline& outline) const;
  std::shared_ptr<const SurfaceRows> find(std::span<const std::int64_t> face);
  std::shared_ptr<const SurfaceRows> find(const SurfaceMesh& layer,
                                          std::span<const std::int32_t> row);
  std::shared_ptr<const SurfaceRows> touch(std::list<Kept>::iterator entry);
  void keep(Kept&& entry);
  void drop();
  void check(const Kept& entry) const;
  template <class Archive, class Entry>
  void content(Archive& ar, Entry& entry) const;

  std::size_t most_bytes_;
  std::list<Kept> kept_;  ///< latest used first
  std::int64_t dropped_ = 0;
  std::map<std::vector<std::int64_t>, std::weak_ptr<const SurfaceLoads>> loads_;
  SurfaceMesh last_loads_layer_;
  std::weak_ptr<const SurfaceLoads> last_layer_loads_;
};

}  // namespace rollcon
