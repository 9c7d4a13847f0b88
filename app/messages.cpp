#include "app/messages.h"

#include <fmt/format.h>

#include <cstdio>

namespace arris::app {

void tell(std::span<const base::Problem> problems, std::string_view frame) {
  for (const base::Problem& problem : problems) {
    fmt::print(stderr, "{}\n", base::describeWithPlace(problem, frame));
  }
}

void complain(std::string_view words) {
  fmt::print(stderr, "arris: {}\n", words);
}

ExitStatus statusFor(const base::Problem& problem) {
  switch (problem.code) {
  case base::Code::CannotOpen:
  case base::Code::CannotRead:
  case base::Code::CannotWrite:
  case base::Code::DriverNotAvailable:
    return ExitStatus::SystemFailure;
  case base::Code::NumericalFailure:
    return ExitStatus::InternalError;
  default:
    return ExitStatus::WrongUsage;
  }
}

ExitStatus tellAndJudge(const base::Problems& problems) {
  tell(problems);
  for (const base::Problem& problem : problems) {
    if (base::severityOf(problem) == base::Severity::Error) {
      return statusFor(problem);
    }
  }
  return ExitStatus::Done;
}

} // namespace arris::app
