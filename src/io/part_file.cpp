#include "io/part_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <filesystem>

#include "support/error.hpp"

namespace rollcon {
namespace {

// Returns where a path leads by symbolic links, also where nothing is there yet, so that the links stay.
std::string behind_links(const std::string& path) {
  constexpr int most_links = 40;
  std::filesystem::path place = path;
  std::error_code error;
  for (int k = 0; k < most_links && std::filesystem::is_symlink(place, error); ++k) {
    const std::filesystem::path to = std::filesystem::read_symlink(place, error);
    if (error) break;
    place = to.is_absolute() ? to : place.parent_path() / to;
  }
  return place.string();
}

}  // namespace

int open_part(std::string& path, std::string& part) {
  path = behind_links(path);
  // Renaming would put a file in the place of a device or a pipe.
  struct stat old {};
  const bool there = stat(path.c_str(), &old) == 0;
  if (!there && errno == ELOOP) return -1;
  if (there && !S_ISREG(old.st_mode))
    fail(Status::err_io, "cannot write '%s': there is something that is no regular file", path.c_str());
  static std::atomic<unsigned> count{0};
  // Names that a killed process of the same number left are passed over.
  constexpr int most_names = 1000;
  int file = -1;
  for (int attempt = 0; attempt < most_names; ++attempt) {
    part = path + "." + std::to_string(getpid()) + "-" + std::to_string(count++) + ".part";
    file = open(part.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, there ? 0600 : 0666);
    if (file >= 0 || errno != EEXIST) break;
  }
  // The new file may be read and written by those who may do so with the file that is replaced.
  constexpr mode_t permissions = S_IRWXU | S_IRWXG | S_IRWXO;
  if (file >= 0 && there && fchmod(file, old.st_mode & permissions) != 0) {
    const int error = errno;
    close(file);
    unlink(part.c_str());
    errno = error;
    return -1;
  }
  return file;
}

}  // namespace rollcon
