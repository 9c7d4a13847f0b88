#pragma once

#include <Eigen/Core>
#include <tl/expected.hpp>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace arris::base {

enum class Severity { Error, Warning, Note };

/// What can be wrong with a file, a value, a pattern or a job. Names and texts stand in one table (problem_table.cpp).
enum class Code {
  // Files and values at the border
  CannotOpen,
  CannotRead,
  CannotWrite,
  JsonMalformed,
  JsonNotThisFormat,
  VersionNewer,
  UnknownKey,
  ValueWrongType,
  ValueNotANumber,
  ValueOutOfRange,
  ValueAboveMachine,
  ValueNotAChoice,
  CsvMalformed,
  RecordMalformed,
  RecordDamaged,
  FileSetAside,
  CountersDamaged,
  BundleMalformed,
  // The gate in front of the DXF reader
  DxfEmpty,
  DxfBinary,
  DxfNotDxf,
  DxfLineEnds,
  DxfGroupCode,
  DxfNumber,
  DxfCoordinateAbsurd,
  DxfTruncated,
  DxfSection,
  DxfVertexCount,
  DxfEntityIncomplete,
  DxfEntityValue,
  BlockTwice,
  // Drawing to contours
  UnitsAssumed,
  UnitsUnknown,
  EntityNotSupported,
  EntityNotPlanar,
  BlockUnknown,
  BlockInsertsItself,
  InsertsTooMany,
  SplineFlawed,
  CurvesTooMany,
  PlaceAbsurd,
  EntitiesPassedOver,
  MoreNotListed,
  DuplicateRemoved,
  ZeroLengthRemoved,
  GapClosed,
  OpenChain,
  StrayPiece,
  BranchingChain,
  EndOnPiece,
  NoContour,
  ContourDegenerate,
  ContourCrossesItself,
  ContoursCross,
  ContoursTooDense,
  ChordsTooCoarse,
  // Wheel path
  SpikeInContour,
  Unreached,
  UnreachedAccepted,
  ContourNotEntered,
  ContourLeftOut,
  NothingToGrind,
  ConcaveFillet,
  TransitionBlocked,
  SizeCorrectionTooLarge,
  NoRelief,
  SlowCorner,
  NoLead,
  NoLeadAccepted,
  OverlapShortened,
  OutsideTravel,
  WheelBelowTable,
  ParkTooLow,
  HeightOutsideTravel,
  GrindingAboveClearance,
  // Speed
  MachineSpeedBinds,
  NumericalFailure,
  Cancelled,
  // A job that was broken off
  JobOfAnotherPattern,
  JobOfAnotherMachine,
  JobPlaceUnknown,
  // The machine
  DriverNotAvailable,
};

/// A named figure or word of a problem; the unit stands at the end of the name (`gap_mm`).
struct Value {
  std::string name;
  std::variant<double, std::int64_t, std::string> value;
  bool operator==(const Value&) const = default;
};

/// One thing to tell the user: what (code and values) and where. Core reports codes and numbers; `describe` makes
/// English.
struct Problem {
  Code code = Code::NumericalFailure;
  std::vector<Value> values;
  std::optional<Eigen::Vector2d> where; ///< place, mm; in the drawing until placed, then on the table
  std::optional<std::int64_t> line;     ///< line of the pattern file, from 1
  std::optional<int> contour;           ///< number of the contour, from 1
  std::optional<int> corner;            ///< number of the corner in the order of machining, from 1
  std::optional<double> largestWheel;   ///< radius of the largest wheel that could, mm

  Problem() = default;

  bool operator==(const Problem&) const = default;

  explicit Problem(Code c, std::vector<Value> v = {}) : code(c), values(std::move(v)) {}

  // Builders, so that a problem with its place is one expression.
  Problem at(const Eigen::Vector2d& place) && {
    where = place;
    return std::move(*this);
  }

  Problem onLine(std::int64_t number) && {
    line = number;
    return std::move(*this);
  }

  Problem ofContour(int number) && {
    contour = number;
    return std::move(*this);
  }

  Problem ofCorner(int number) && {
    corner = number;
    return std::move(*this);
  }
};

using Problems = std::vector<Problem>;

/// One type everywhere for failures that are expected; what cannot happen is an assertion.
template <typename T> using Expected = tl::expected<T, Problem>;

using Unexpected = tl::unexpected<Problem>;

/// The row of the table for a code: its name in reports (kebab-case), its severity and the English text with `{names}`.
struct CodeInfo {
  Code code;
  std::string_view name;
  Severity severity;
  std::string_view text;
};

[[nodiscard]] const CodeInfo& info(Code code);

/// Every row, in the order of the enumeration.
[[nodiscard]] const std::vector<CodeInfo>& allCodes();

[[nodiscard]] std::string_view name(Severity severity);

/// `text` with every `{name}` replaced by the problem's value of that name; numbers in the shortest form up to six
/// significant digits, always with a decimal point. A name without a value stays as it stands.
[[nodiscard]] std::string fillIn(std::string_view text, const Problem& problem);

/// The English sentence, without severity and place.
[[nodiscard]] std::string describe(const Problem& problem);

/// One line for a terminal: `error: line 12: at (10.500, 20.000) mm in the drawing: sentence [code]`; `frame` says
/// which coordinates the place has.
[[nodiscard]] std::string describeWithPlace(const Problem& problem, std::string_view frame = "in the drawing");

/// As many problems of one code are told: the drawing is read again after the first are mended.
inline constexpr std::int64_t kMostOfOneCode = 20;

/// Of each code only the first `kMostOfOneCode` stay; a note with the count stands for the others.
void keepFirstOfEachCode(Problems& problems);

[[nodiscard]] inline Severity severityOf(const Problem& problem) {
  return info(problem.code).severity;
}

[[nodiscard]] inline bool hasErrors(const Problems& problems) {
  return std::any_of(problems.begin(), problems.end(),
                     [](const Problem& p) { return severityOf(p) == Severity::Error; });
}

} // namespace arris::base
