#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace arris::test {

/// The folders of core in the order in which the data flows, as core/CMakeLists.txt lists them.
[[nodiscard]] std::vector<std::string> flowOf(std::string_view cmakeLists);

/// What in a source breaks a rule, each as `path:line: words`:
/// core includes nothing of Qt, ui or app, and a folder of core nothing of those after it in the flow; ui includes
/// nothing of app; only ui translates. `path` is relative to the root of the project.
[[nodiscard]] std::vector<std::string> brokenRules(const std::string& path, std::string_view text,
                                                   const std::vector<std::string>& flow);

} // namespace arris::test
