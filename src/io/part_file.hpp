#pragma once
/// Writes files beside what they become and renames them when they are whole.

#include <string>

namespace rollcon {

/// Creates PATH.<process>-<number>.part, a name that no other thread or process uses, for writing. Returns its
/// descriptor and puts its name in `part`; negative: could not, errno says why. A PATH that is a symbolic link becomes
/// what it leads to; the new file has the permissions of the one it replaces. Throws Error(err_io) if PATH is there and
/// is no regular file.
int open_part(std::string& path, std::string& part);

}  // namespace rollcon
