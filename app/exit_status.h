#pragma once

namespace arris::app {

/// What the program ends with (contract of the command line).
enum class ExitStatus {
  Done = 0,
  CannotBeGround = 1, ///< the pattern or the job, a malformed pattern file included
  WrongUsage = 2,     ///< or an invalid value, a malformed or newer recipe or machine file
  MachineFaulted = 3, ///< during a run
  SystemFailure = 4,  ///< a file or the display cannot be opened, read or written
  InternalError = 5,
  Interrupted = 130,
};

} // namespace arris::app
