#include "bodies/load_case.hpp"

#include <utility>

#include "bodies/model/imbalance.hpp"

namespace rollcon {
namespace {

class LoadCase final : public SurfaceResponse, public MayMissLoads {
 public:
  LoadCase(std::shared_ptr<BodyModel> base, OwnLoads own) : base_(std::move(base)), own_(std::move(own)) {}

  std::shared_ptr<const SurfaceRows> rows(const LoadedSurface& surface, int threads) override {
    return equal().rows(surface, threads);
  }
  std::shared_ptr<const SurfaceLoads> loads(const LoadedSurface& surface, int threads) override {
    return equal().loads(surface, threads);
  }
  std::shared_ptr<const BodyEquations> equations(int threads) override { return equal().equations(threads); }
  void solve_everywhere(std::span<double> load, SurfaceState& state, int threads) override {
    equal().solve_everywhere(load, state, threads);
  }
  std::unique_ptr<const SurfaceFields> surface_fields(SurfaceState&& state, const OwnLoads& own) override {
    return equal().surface_fields(std::move(state), own);
  }
  const BodyInterior* interior() const override { return equal().interior(); }
  const OwnLoads& own() const override { return own_; }
  OwnLoads solve_loads(const BodyMesh& loaded, int threads) override { return equal().solve_loads(loaded, threads); }
  BodyStatistics statistics() const override { return equal().statistics(); }
  Imbalances imbalances() const override {
    Imbalances all = imbalances_of(&equal());
    all.loads = own_.missed;
    return all;
  }
  std::int64_t solvable() const override { return equal().solvable(); }
  using SurfaceResponse::save;
  void save(SectionWriter& file, const OwnLoads& own) const override { equal().save(file, own); }
  void add_kept(SectionReader& file) override { equal().add_kept(file); }

 private:
  SurfaceResponse& equal() const { return *base_->response; }

  std::shared_ptr<BodyModel> base_;
  OwnLoads own_;
};

}  // namespace

std::unique_ptr<SurfaceResponse> make_load_case(std::shared_ptr<BodyModel> base, const BodyMesh& loaded, int threads) {
  OwnLoads own = base->response->solve_loads(loaded, threads);
  return std::make_unique<LoadCase>(std::move(base), std::move(own));
}

}  // namespace rollcon
