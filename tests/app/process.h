#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace arris::test {

/// What a run of the program left: its exit status (128 + signal where one ended it) and what it said.
struct Outcome {
  int status = 0;
  std::string out;
  std::string err;
};

using Environment = std::map<std::string, std::string>;

/// Runs `arris` with these arguments, without a display, and waits for its end. `environment` adds variables.
[[nodiscard]] Outcome arris(const std::vector<std::string>& arguments, const Environment& environment = {});

/// The same, but ended by SIGINT as soon as `sign` holds.
[[nodiscard]] Outcome interruptedArris(const std::vector<std::string>& arguments, const std::function<bool()>& sign);

/// A pane of the samples: its path without the ending.
[[nodiscard]] std::string sample(const std::string& name);

[[nodiscard]] std::string contentOf(const std::string& file);
void writeTo(const std::string& file, const std::string& content);

} // namespace arris::test
