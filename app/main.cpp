#include "app/command_line.h"
#include "app/messages.h"

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <new>

int main(int argc, char** argv) {
  using namespace arris::app;
  try {
    const ExitStatus status = run(Arguments(argv + 1, argv + argc));
    if (std::fflush(stdout) != 0 && status == ExitStatus::Done) {
      complain("what there is to say cannot be written to standard output");
      return static_cast<int>(ExitStatus::SystemFailure);
    }
    if (status == ExitStatus::Interrupted) {
      complain("interrupted");
    }
    return static_cast<int>(status);
  } catch (const std::bad_alloc&) {
    complain("there is not enough memory for this");
    return static_cast<int>(ExitStatus::SystemFailure);
  } catch (const std::exception& error) {
    complain(fmt::format("internal error: {}", error.what()));
    return static_cast<int>(ExitStatus::InternalError);
  }
}
