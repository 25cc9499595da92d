#pragma once
/// Keeps what a body's surface answered: for each set of faces, and for the last layer.

#include <map>
#include <mutex>

#include "bodies/surface_response.hpp"

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

 protected:
  /// The surface must outlive it.
  explicit ResponseCache(const SurfaceMesh& surface) : surface_(surface) {}
  /// Rows and columns are set; u is to be filled. Called with the mutex held.
  virtual void respond(std::span<const std::int64_t> face, SurfaceRows& rows, int threads) = 0;
  virtual void respond(const SurfaceMesh& layer, SurfaceRows& rows, int threads) = 0;
  /// Likewise: load and unknown are to be filled.
  virtual void load(std::span<const std::int64_t> face, SurfaceLoads& loads, int threads) = 0;
  virtual void load(const SurfaceMesh& layer, SurfaceLoads& loads, int threads) = 0;
  /// With the mutex held.
  std::size_t kept_bytes() const;

  const SurfaceMesh& surface_;
  mutable std::mutex mutex_;

 private:
  void outline_faces(const std::vector<std::int64_t>& face, SurfaceOutline& outline) const;

  std::map<std::vector<std::int64_t>, std::shared_ptr<const SurfaceRows>> kept_;
  SurfaceMesh last_layer_;
  std::shared_ptr<const SurfaceRows> last_layer_rows_;
  std::map<std::vector<std::int64_t>, std::weak_ptr<const SurfaceLoads>> loads_;
  SurfaceMesh last_loads_layer_;
  std::weak_ptr<const SurfaceLoads> last_layer_loads_;
};

}  // namespace rollcon
