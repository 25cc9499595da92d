#include "io/part_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>

#include "support/error.hpp"

namespace rollcon {

int open_part(const std::string& path, std::string& part) {
  // Renaming would put a file in the place of a device or a pipe.
  struct stat old {};
  if (stat(path.c_str(), &old) == 0 && !S_ISREG(old.st_mode))
    fail(Status::err_io, "cannot write '%s': there is something that is no regular file",
         path.c_str());
  static std::atomic<unsigned> count{0};
  // Names left by a process of the same number that was killed are passed over.
  constexpr int most_names = 1000;
  int file = -1;
  for (int attempt = 0; attempt < most_names; ++attempt) {
    part = path + "." + std::to_string(getpid()) + "-" + std::to_string(count++) + ".part";
    file = open(part.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
    if (file >= 0 || errno != EEXIST) break;
  }
  return file;
}

}  // namespace rollcon
