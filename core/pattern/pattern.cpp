#include "core/pattern/pattern.h"

#include "core/base/window_thread.h"
#include "core/pattern/contour.h"
#include "core/pattern/dxf_gate.h"
#include "core/pattern/dxf_reader.h"
#include "core/pattern/dxf_selection.h"
#include "core/pattern/join.h"
#include "core/pattern/units.h"

#include <algorithm>
#include <exception>
#include <tuple>

namespace arris::pattern {
namespace {

using base::Code;
using base::Problem;
using base::Problems;
using geometry::Curve;

void append(Problems& problems, const Problems& more) {
  problems.insert(problems.end(), more.begin(), more.end());
}

// From below upwards, whatever the order of the pieces was.
void sortByPlace(Problems& problems) {
  const auto place = [](const Problem& p) {
    const geometry::Point where = p.where.value_or(geometry::Point::Zero());
    return std::tuple(p.code, where.y(), where.x());
  };
  std::sort(problems.begin(), problems.end(), [&](const Problem& a, const Problem& b) { return place(a) < place(b); });
}

bool isOneOf(const Problem& problem, std::initializer_list<Code> codes) {
  return std::find(codes.begin(), codes.end(), problem.code) != codes.end();
}

// What is missing leaves the rest open; telling that too would lead away from the cause.
void dropConsequencesOfMissing(Problems& problems, const Problems& ofEntities) {
  if (base::hasErrors(ofEntities)) {
    const auto isConsequence = [](const Problem& p) { return isOneOf(p, {Code::OpenChain, Code::NoContour}); };
    problems.erase(std::remove_if(problems.begin(), problems.end(), isConsequence), problems.end());
  }
}

Pattern readInventory(const Inventory& inventory, const ImportOptions& options, const base::Monitor& monitor) {
  const FoundUnits units = findUnits(options.units, inventory.insUnits, inventory.measurement);
  const double scale = millimetresPer(units.units);
  Selection selection = selectEntities(inventory, options.layers, scale);
  ReadEntities read = readEntities(selection, monitor.stop);
  append(selection.problems, read.problems);

  Pattern pattern = joinPieces(std::move(read.pieces), options.gap, options.smooth, monitor);
  append(pattern.repairs, read.repairs);
  sortByPlace(pattern.repairs);
  pattern.units = units.units;
  pattern.unitsFrom = units.from;
  pattern.entities = std::move(selection.counts);
  pattern.layers = std::move(selection.layers);
  dropConsequencesOfMissing(pattern.problems, selection.problems);
  pattern.problems.insert(pattern.problems.begin(), selection.problems.begin(), selection.problems.end());
  if (units.problem) {
    pattern.problems.insert(pattern.problems.begin(), *units.problem);
  }
  base::keepFirstOfEachCode(pattern.problems);
  return pattern;
}

Pattern onlyWith(Problem problem) {
  Pattern pattern;
  pattern.problems.push_back(std::move(problem));
  return pattern;
}

} // namespace

ImportOptions importOptions(const recipe::Recipe& recipe) {
  return {.units = recipe.units, .gap = recipe.gap, .smooth = recipe.smooth, .layers = recipe.layers};
}

Pattern readDxf(std::string_view text, const ImportOptions& options, const base::Monitor& monitor) {
  base::takesLong("readDxf");
  monitor.begin(base::Stage::Reading);
  try {
    const base::Expected<Inventory> inventory = inspectDxf(text, options.units, monitor.stop);
    Pattern pattern = inventory ? readInventory(*inventory, options, monitor) : onlyWith(inventory.error());
    return monitor.stop.stop_requested() ? onlyWith(Problem(Code::Cancelled)) : pattern;
  } catch (const std::exception& e) { // no memory left
    return onlyWith(Problem(Code::NumericalFailure, {{"reason", std::string(e.what())}}));
  }
}

Pattern joinPieces(Pieces pieces, double gap, double smooth, const base::Monitor& monitor) {
  monitor.begin(base::Stage::Joining);
  const std::stop_token& stop = monitor.stop;
  if (stop.stop_requested()) {
    return onlyWith(Problem(Code::Cancelled));
  }
  Chains chains = chainPieces(std::move(pieces), gap, stop);
  Pattern pattern;
  pattern.loose = std::move(chains.loose);
  pattern.repairs = std::move(chains.repairs);
  pattern.problems = std::move(chains.problems);
  Problems notes;
  for (std::vector<Curve>& chain : chains.closed) {
    if (stop.stop_requested()) {
      return onlyWith(Problem(Code::Cancelled));
    }
    const int number = static_cast<int>(pattern.contours.size()) + 1;
    pattern.contours.push_back(makeContour(number, std::move(chain), smooth, notes, stop));
  }
  takeOutCopies(pattern.contours, pattern.repairs, stop);
  if (stop.stop_requested()) {
    return onlyWith(Problem(Code::Cancelled));
  }
  sortContours(pattern.contours, notes, stop);
  if (pattern.contours.empty() && pattern.problems.empty()) {
    pattern.problems.emplace_back(Code::NoContour);
  }
  append(pattern.problems, notes);
  append(pattern.problems, checkContours(pattern.contours, stop));
  sortByPlace(pattern.repairs);
  sortByPlace(pattern.problems);
  base::keepFirstOfEachCode(pattern.problems);
  return pattern;
}

} // namespace arris::pattern
