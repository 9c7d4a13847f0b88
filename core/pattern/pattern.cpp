#include "core/pattern/pattern.h"

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

Pattern readInventory(const Inventory& inventory, const ImportOptions& options) {
  const FoundUnits units = findUnits(options.units, inventory.insUnits, inventory.measurement);
  const double scale = millimetresPer(units.units);
  Selection selection = selectEntities(inventory, options.layers, scale);
  ReadEntities read = readEntities(selection);
  append(selection.problems, read.problems);

  Pattern pattern = joinPieces(std::move(read.pieces), options.gap, options.smooth);
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

Pattern readDxf(std::string_view text, const ImportOptions& options) {
  try {
    const base::Expected<Inventory> inventory = inspectDxf(text, options.units);
    return inventory ? readInventory(*inventory, options) : onlyWith(inventory.error());
  } catch (const std::exception& e) { // no memory left
    return onlyWith(Problem(Code::NumericalFailure, {{"reason", std::string(e.what())}}));
  }
}

Pattern joinPieces(Pieces pieces, double gap, double smooth) {
  Chains chains = chainPieces(std::move(pieces), gap);
  Pattern pattern;
  pattern.loose = std::move(chains.loose);
  pattern.repairs = std::move(chains.repairs);
  pattern.problems = std::move(chains.problems);
  Problems notes;
  for (std::vector<Curve>& chain : chains.closed) {
    const int number = static_cast<int>(pattern.contours.size()) + 1;
    pattern.contours.push_back(makeContour(number, std::move(chain), smooth, notes));
  }
  takeOutCopies(pattern.contours, pattern.repairs);
  sortContours(pattern.contours, notes);
  if (pattern.contours.empty() && pattern.problems.empty()) {
    pattern.problems.emplace_back(Code::NoContour);
  }
  append(pattern.problems, notes);
  append(pattern.problems, checkContours(pattern.contours));
  sortByPlace(pattern.repairs);
  sortByPlace(pattern.problems);
  base::keepFirstOfEachCode(pattern.problems);
  return pattern;
}

} // namespace arris::pattern
