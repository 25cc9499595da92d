#include "io/whole_file.hpp"

#include <filesystem>
#include <fstream>
#include <system_error>

#include "support/error.hpp"

namespace rollcon {

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

}  // namespace rollcon
