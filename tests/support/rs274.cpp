#include "tests/support/rs274.h"

#include "core/base/numbers.h"
#include "tests/support/scratch.h"

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace arris::test {
namespace {

std::string textOf(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

// The numbers between the parentheses of a canonical call.
std::vector<double> arguments(const std::string& call) {
  std::vector<double> result;
  std::size_t at = call.find('(');
  while (at != std::string::npos && call[at] != ')') {
    const std::size_t end = call.find_first_of(",)", at + 1);
    const std::size_t start = call.find_first_not_of(' ', at + 1);
    result.push_back(base::parseNumber<double>(call.substr(start, end - start)).value_or(0));
    at = end;
  }
  return result;
}

/// Follows the calls and remembers what holds.
class Machine {
public:
  explicit Machine(Interpretation& result) : m_result(result) {}

  void call(const std::string& line) {
    const auto is = [&line](const char* name) { return line.find(name) != std::string::npos; };
    using Kind = CanonicalMotion::Kind;
    if (is(" STRAIGHT_TRAVERSE(")) {
      move(Kind::Rapid, arguments(line));
    } else if (is(" STRAIGHT_FEED(")) {
      move(Kind::Line, arguments(line));
    } else if (is(" ARC_FEED(")) {
      arc(arguments(line));
    } else if (is(" NURBS_FEED(")) {
      add(Kind::Spline);
    } else if (is(" SET_FEED_RATE(")) {
      m_now.feed = arguments(line).at(0);
    } else if (is("CANON_EXACT_STOP")) {
      m_now.exactStop = true;
    } else if (is("CANON_EXACT_PATH")) {
      m_now.exactStop = false;
    } else if (is("START_SPINDLE_CLOCKWISE")) {
      m_now.spindleOn = true;
    } else if (is("STOP_SPINDLE_TURNING")) {
      m_now.spindleOn = false;
    } else if (is("FLOOD_ON") || is("FLOOD_OFF")) {
      m_now.coolantOn = is("FLOOD_ON");
    } else if (is("PROGRAM_END")) {
      m_result.ended = true;
    }
  }

private:
  void add(CanonicalMotion::Kind kind) {
    m_now.kind = kind;
    m_result.motions.push_back(m_now);
    m_now.from = m_now.to;
  }

  void move(CanonicalMotion::Kind kind, const std::vector<double>& to) {
    m_now.to = {to.at(0), to.at(1), to.at(2)};
    add(kind);
  }

  void arc(const std::vector<double>& values) {
    m_now.to = {values.at(0), values.at(1), values.at(5)};
    m_now.center = {values.at(2), values.at(3)};
    m_now.counterClockwise = values.at(4) > 0;
    add(CanonicalMotion::Kind::Arc);
  }

  Interpretation& m_result;
  CanonicalMotion m_now;
};

} // namespace

Interpretation interpret(const std::string& program) {
  // The interpreter leaves its parameters in the folder where it runs and maps its tool table from a file in the home
  // folder, which it empties first: two at once with one home bring each other down.
  const Scratch scratch;
  std::ofstream(scratch / "program.ngc") << program;
  const std::string command =
      "cd '" + (scratch / ".").string() + "' && HOME=$PWD rs274 -g program.ngc >calls 2>messages </dev/null";
  Interpretation result;
  result.status = std::system(command.c_str());
  result.message = textOf(scratch / "messages");
  std::ifstream calls(scratch / "calls");
  Machine machine(result);
  for (std::string line; std::getline(calls, line);) {
    machine.call(line);
  }
  return result;
}

} // namespace arris::test
