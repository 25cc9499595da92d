#include "io/whole_file.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <new>
#include <system_error>

#include "io/part_file.hpp"
#include "support/error.hpp"

namespace rollcon {
namespace {

[[noreturn]] void fail_io(const std::string& path, int error) {
  if (error == ENOMEM) throw std::bad_alloc();
  fail(Status::err_io, "cannot write '%s': %s", path.c_str(), std::generic_category().message(error).c_str());
}

}  // namespace

std::string whole_file(const std::string& path, std::uintmax_t most) {
  const auto refuse = [&](const std::string& what) { fail(Status::err_io, "%s: %s", path.c_str(), what.c_str()); };
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) refuse("there is no such file");
  if (!std::filesystem::is_regular_file(status)) refuse("it is no regular file");
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) refuse(error.message());
  if (size > most) refuse("it has more than " + std::to_string(most >> 20U) + " MiB");
  std::ifstream file(path, std::ios::binary);
  std::string text(size, '\0');
  if (!file || (size > 0 && !file.read(text.data(), static_cast<std::streamsize>(size)))) refuse("it cannot be read");
  return text;
}

void write_whole_file(const std::string& name, const std::string& text) {
  std::string path = name, part;
  const int descriptor = open_part(path, part);
  if (descriptor < 0) fail_io(path, errno);
  std::FILE* file = fdopen(descriptor, "wb");
  if (!file) {
    const int error = errno;
    close(descriptor);
    std::remove(part.c_str());
    fail_io(path, error);
  }
  errno = 0;
  bool good = std::fwrite(text.data(), 1, text.size(), file) == text.size();
  int error = errno;
  // Closing writes what is buffered: a full disk may only show here.
  if (std::fclose(file) != 0 && good) good = false, error = errno;
  if (good) {
    std::error_code renamed;
    std::filesystem::rename(part, path, renamed);
    if (!renamed) return;
    error = renamed.default_error_condition().value();
  }
  std::remove(part.c_str());
  fail_io(path, error);
}

}  // namespace rollcon
