#include "log.hpp"

#include <cstdarg>
#include <cstdio>
#include <mutex>

namespace cntc {
namespace {

std::mutex lock;
std::FILE* file = nullptr;
bool on_screen = false;

std::string vprint(const char* format, std::va_list arguments) {
  char text[4096];
  const int n = std::vsnprintf(text, sizeof text, format, arguments);
  return n < 0 ? std::string() : std::string(text);
}

}  // namespace

std::string print(const char* format, ...) {
  std::va_list arguments;
  va_start(arguments, format);
  std::string text = vprint(format, arguments);
  va_end(arguments);
  return text;
}

void log_open(const std::string& path, bool screen) {
  const std::lock_guard guard(lock);
  if (file) std::fclose(file);
  on_screen = screen;
  file = std::fopen(path.c_str(), "w");
  if (!file) std::fprintf(stderr, "rollcon: %s cannot be written; messages are lost\n", path.c_str());
}

void log_close() {
  const std::lock_guard guard(lock);
  if (file) std::fclose(file);
  file = nullptr;
}

void log_write(const std::string& text) {
  const std::lock_guard guard(lock);
  if (file) {
    std::fputs(text.c_str(), file);
    std::fflush(file);
  }
  if (on_screen) std::fputs(text.c_str(), stdout);
}

void log_line(const char* name, int ire, int icp, const char* format, ...) {
  std::va_list arguments;
  va_start(arguments, format);
  const std::string text = vprint(format, arguments);
  va_end(arguments);
  log_write(print(" ** %-30s(%3d.%2d): %s\n", name, ire, icp, text.c_str()));
}

}  // namespace cntc
