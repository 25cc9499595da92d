#include "linalg/fft.hpp"

#include <mutex>

#include "build_info.hpp"
#include "support/error.hpp"

#if ROLLCON_BUILD_FFTW
#include <fftw3.h>
#endif

namespace rollcon {

namespace {

/// Returns the relative time of a transform of even length n by FFTW's estimated plans and of the work on its results;
/// 0 if n has a prime factor above 7. Factors of 3 are slow, factors of 16 are fast.
double transform_cost(std::int64_t n) {
  int threes = 0;
  std::int64_t rest = n;
  for (; rest % 3 == 0; rest /= 3) ++threes;
  for (const int prime : {2, 5, 7})
    while (rest % prime == 0) rest /= prime;
  if (rest != 1) return 0;
  constexpr double by_threes[] = {1, 1.45, 1.7, 1.9};
  const double slow = by_threes[threes < 3 ? threes : 3] * (n % 16 == 0 ? 1 : 1.3);
  return static_cast<double>(n) * (1 + 2 * slow);
}

}  // namespace

std::int64_t fft_size(std::int64_t least) {
  if (least < 2) return 2;
  std::int64_t best = 0;
  double lowest = 0;
  for (std::int64_t n = least + least % 2; best == 0 || n <= least + least / 3 + 1; n += 2) {
    const double cost = transform_cost(n);
    if (cost > 0 && (best == 0 || cost < lowest)) best = n, lowest = cost;
  }
  return best;
}

namespace {

// FFTW's planner works on tables of the whole process. Plans are estimated, which takes a millisecond, and not
// measured, which takes longer than whole solves.
std::mutex& planner() {
  static std::mutex lock;
  return lock;
}

/// FFTW's calls in either precision; without FFTW no plan is made, and nothing else is reached.
#if ROLLCON_BUILD_FFTW
template <class T>
struct Calls;
template <>
struct Calls<double> {
  using Plan = fftw_plan;
  using Complex = fftw_complex;
  static Plan plan_real(int n, double* in, Complex* out) {
    return fftw_plan_dft_r2c_1d(n, in, out, FFTW_ESTIMATE | FFTW_PRESERVE_INPUT);
  }
  static Plan plan_real_back(int n, Complex* in, double* out) {
    return fftw_plan_dft_c2r_1d(n, in, out, FFTW_ESTIMATE | FFTW_DESTROY_INPUT);
  }
  static Plan plan(int n, Complex* in, Complex* out, int sign) {
    return fftw_plan_dft_1d(n, in, out, sign, FFTW_ESTIMATE | FFTW_DESTROY_INPUT);
  }
  static void run_real(Plan p, double* in, Complex* out) { fftw_execute_dft_r2c(p, in, out); }
  static void run_back(Plan p, Complex* in, double* out) { fftw_execute_dft_c2r(p, in, out); }
  static void run(Plan p, Complex* in, Complex* out) { fftw_execute_dft(p, in, out); }
  static void destroy(Plan p) { fftw_destroy_plan(p); }
};
template <>
struct Calls<float> {
  using Plan = fftwf_plan;
  using Complex = fftwf_complex;
  static Plan plan_real(int n, float* in, Complex* out) {
    return fftwf_plan_dft_r2c_1d(n, in, out, FFTW_ESTIMATE | FFTW_PRESERVE_INPUT);
  }
  static Plan plan_real_back(int n, Complex* in, float* out) {
    return fftwf_plan_dft_c2r_1d(n, in, out, FFTW_ESTIMATE | FFTW_DESTROY_INPUT);
  }
  static Plan plan(int n, Complex* in, Complex* out, int sign) {
    return fftwf_plan_dft_1d(n, in, out, sign, FFTW_ESTIMATE | FFTW_DESTROY_INPUT);
  }
  static void run_real(Plan p, float* in, Complex* out) { fftwf_execute_dft_r2c(p, in, out); }
  static void run_back(Plan p, Complex* in, float* out) { fftwf_execute_dft_c2r(p, in, out); }
  static void run(Plan p, Complex* in, Complex* out) { fftwf_execute_dft(p, in, out); }
  static void destroy(Plan p) { fftwf_destroy_plan(p); }
};
constexpr int forwards = FFTW_FORWARD, backwards = FFTW_BACKWARD;
#else
template <class T>
struct Calls {
  using Plan = void*;
  using Complex = std::complex<T>;
  static Plan plan_real(int, T*, Complex*) { return nullptr; }
  static Plan plan_real_back(int, Complex*, T*) { return nullptr; }
  static Plan plan(int, Complex*, Complex*, int) { return nullptr; }
  static void run_real(Plan, T*, Complex*) {}
  static void run_back(Plan, Complex*, T*) {}
  static void run(Plan, Complex*, Complex*) {}
  static void destroy(Plan) {}
};
constexpr int forwards = -1, backwards = 1;
#endif

template <class T>
typename Calls<T>::Complex* raw(std::complex<T>* data) {
  return reinterpret_cast<typename Calls<T>::Complex*>(data);
}

template <class T>
typename Calls<T>::Plan plan(void* p) {
  return static_cast<typename Calls<T>::Plan>(p);
}

template <class T>
void destroy(void* p) {
  if (p == nullptr) return;
  const std::lock_guard guard(planner());
  Calls<T>::destroy(plan<T>(p));
}

/// FFTW ends the process where its planner finds no memory, so an allocation of more than it takes is tried before.
void require_room(std::int64_t n) {
  const AlignedArray<char> room((std::int64_t{1} << 19U) + 64 * n);
}

void require(const void* a, const void* b, std::int64_t n) {
  if (!has_fft()) fail(Status::err_unsupported, "this build has no FFTW (ROLLCON_WITH_FFTW=OFF)");
  if (a == nullptr || b == nullptr)
    fail(Status::err_internal, "FFTW has no plan for length %lld", static_cast<long long>(n));
}

}  // namespace

bool has_fft() {
  return ROLLCON_BUILD_FFTW != 0;
}

template <class T>
RealFft<T>::RealFft(std::int64_t n) {
  AlignedArray<T> real(n);
  AlignedArray<std::complex<T>> half(n / 2 + 1);
  require_room(n);
  const std::lock_guard guard(planner());
  forward_ = Calls<T>::plan_real(static_cast<int>(n), real.data(), raw<T>(half.data()));
  inverse_ = Calls<T>::plan_real_back(static_cast<int>(n), raw<T>(half.data()), real.data());
  require(forward_, inverse_, n);
}

template <class T>
RealFft<T>::~RealFft() {
  destroy<T>(forward_);
  destroy<T>(inverse_);
}

template <class T>
void RealFft<T>::forward(const T* in, std::complex<T>* out) const {
  Calls<T>::run_real(plan<T>(forward_), const_cast<T*>(in), raw<T>(out));
}

template <class T>
void RealFft<T>::inverse(std::complex<T>* in, T* out) const {
  Calls<T>::run_back(plan<T>(inverse_), raw<T>(in), out);
}

template <class T>
ComplexFft<T>::ComplexFft(std::int64_t n) {
  AlignedArray<std::complex<T>> in(n), out(n);
  require_room(n);
  const std::lock_guard guard(planner());
  forward_ = Calls<T>::plan(static_cast<int>(n), raw<T>(in.data()), raw<T>(out.data()), forwards);
  inverse_ = Calls<T>::plan(static_cast<int>(n), raw<T>(in.data()), raw<T>(out.data()), backwards);
  require(forward_, inverse_, n);
}

template <class T>
ComplexFft<T>::~ComplexFft() {
  destroy<T>(forward_);
  destroy<T>(inverse_);
}

template <class T>
void ComplexFft<T>::forward(std::complex<T>* in, std::complex<T>* out) const {
  Calls<T>::run(plan<T>(forward_), raw<T>(in), raw<T>(out));
}

template <class T>
void ComplexFft<T>::inverse(std::complex<T>* in, std::complex<T>* out) const {
  Calls<T>::run(plan<T>(inverse_), raw<T>(in), raw<T>(out));
}

template class RealFft<double>;
template class RealFft<float>;
template class ComplexFft<double>;
template class ComplexFft<float>;

}  // namespace rollcon
