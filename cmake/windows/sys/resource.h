/// Holds nothing: posix.hpp has it.
