#pragma once
/// Files are written beside what they become and renamed when they are whole.

#include <string>

namespace rollcon {

/// Creates PATH.<process>-<number>.part, a name that no other thread or process uses, for writing.
/// Returns its descriptor and puts its name in `part`; negative: could not, errno says why. Throws
/// Error(err_io) if PATH is there and is no regular file.
int open_part(const std::string& path, std::string& part);

}  // namespace rollcon
