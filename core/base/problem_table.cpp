#include "core/base/problem.h"

namespace arris::base {

// The one table of codes. Names are contracts of the report: new ones may be added, none renamed or used again.
const std::vector<CodeInfo>& allCodes() {
  using enum Code;
  using enum Severity;
  static const std::vector<CodeInfo> kTable = {
      {CannotOpen, "cannot-open", Error, "{file} cannot be opened: {reason}."},
      {CannotRead, "cannot-read", Error, "{file} cannot be read: {reason}."},
      {CannotWrite, "cannot-write", Error, "{file} cannot be written: {reason}."},
      {JsonMalformed, "json-malformed", Error, "{file} is not valid JSON: {reason}."},
      {JsonNotThisFormat, "json-not-this-format", Error, "{file} has no \"{key}\": it is not such a file."},
      {VersionNewer, "version-newer", Error,
       "{file} was written by a newer Arris (\"{key}\": {version}); this one reads up to {known}."},
      {UnknownKey, "unknown-key", Warning, "{file} has a key \"{key}\" that Arris does not know; it is ignored."},
      {ValueWrongType, "value-wrong-type", Error, "{name} must be {expected}, not {value}."},
      {ValueNotANumber, "value-not-a-number", Error, "{name} must be a number in {unit}, not \"{value}\"."},
      {ValueOutOfRange, "value-out-of-range", Error,
       "{name} is {value} {unit}; it must be from {least} to {most} {unit}."},
      {ValueAboveMachine, "value-above-machine", Error,
       "{name} is {value} {unit}; the machine allows {most} {unit} at most."},
      {ValueNotAChoice, "value-not-a-choice", Error, "{name} is \"{value}\"; it must be one of: {choices}."},
      {CsvMalformed, "csv-malformed", Error, "{file} is not a profile of Arris: {reason}."},
      {RecordMalformed, "record-malformed", Error, "{file} is not the record of a run: {reason}."},
      {RecordDamaged, "record-damaged", Warning,
       "{file} is not whole: {reason} at byte {byte}. What can be read is used."},
      {FileSetAside, "file-set-aside", Warning, "{file} is damaged and has no effect; it was kept as {aside}."},
      {CountersDamaged, "counters-damaged", Warning,
       "{file} is damaged and was kept as {kept}; hours and metres are counted from zero."},
      {BundleMalformed, "bundle-malformed", Error, "{file} is not a back-up that can be restored: {reason}."},

      {DxfEmpty, "dxf-empty", Error, "The pattern file is empty."},
      {DxfBinary, "dxf-binary", Error, "The binary DXF file is damaged: {reason}."},
      {DxfNotDxf, "dxf-not-dxf", Error, "This is not a DXF file: {reason}."},
      {DxfLineEnds, "dxf-line-ends", Error, "The lines end in carriage returns alone; save the file with LF or CR LF."},
      {DxfGroupCode, "dxf-group-code", Error, "A group code is expected here, not {found}."},
      {DxfNumber, "dxf-number", Error, "Group {group} must hold a finite number, not {found}."},
      {DxfCoordinateAbsurd, "dxf-coordinate-absurd", Error,
       "Group {group} holds {found}, which is absurd for a pane of glass (more than {most})."},
      {DxfTruncated, "dxf-truncated", Error, "The file ends early: {reason}. It was cut off."},
      {DxfSection, "dxf-section", Error, "The sections of the file are broken: {reason}."},
      {DxfVertexCount, "dxf-vertex-count", Error, "{entity} announces {announced} {what} but has {found}."},
      {DxfEntityIncomplete, "dxf-entity-incomplete", Error, "{entity} lacks group {group} ({what})."},
      {DxfEntityValue, "dxf-entity-value", Error, "{entity} has {what} {value}, which cannot be."},
      {BlockTwice, "block-twice", Error,
       "Block {block} is defined twice, first on line {first}; give one of them another name."},

      {UnitsAssumed, "units-assumed", Note, "The file does not say its unit; millimetres are assumed."},
      {UnitsUnknown, "units-unknown", Error,
       "The file gives its unit as number {number}, which is not mm, cm, m, inch or foot; say the unit with --units."},
      {EntityNotSupported, "entity-not-supported", Error,
       "{count} × {entity} not read yet; the contour would lack it."},
      {EntityNotPlanar, "entity-not-planar", Error, "{count} × {entity} not flat in a plane parallel to the XY plane."},
      {BlockUnknown, "block-unknown", Error,
       "{count} × INSERT of block {entity}, which the file does not have; explode it before saving."},
      {BlockInsertsItself, "block-inserts-itself", Error,
       "Block {block} inserts itself here, or blocks are nested more than {most} deep; explode it before saving."},
      {InsertsTooMany, "inserts-too-many", Error,
       "INSERT of block {entity} would make more than {most} pieces of the drawing; draw fewer copies."},
      {SplineFlawed, "spline-flawed", Error, "The SPLINE is no curve: {reason}."},
      {CurvesTooMany, "curves-too-many", Error,
       "From here on the curves of the drawing are too long or too many to follow with arcs ({most} steps)."},
      {PlaceAbsurd, "place-absurd", Error,
       "{entity} lies {distance_mm} mm away, which is absurd for a pane of glass (more than {most_mm} mm)."},
      {EntitiesPassedOver, "entities-passed-over", Note, "{count} × {entity} passed over: {reason}."},
      {MoreNotListed, "more-not-listed", Note, "{count} more of {code} are not listed."},
      {DuplicateRemoved, "duplicate-removed", Note, "A doubled piece of {size_mm} mm was removed."},
      {ZeroLengthRemoved, "zero-length-removed", Note, "A piece without length ({size_mm} mm) was removed."},
      {GapClosed, "gap-closed", Note, "A gap of {size_mm} mm was closed."},
      {OpenChain, "open-chain", Error,
       "The contour is open here: the next free end is {gap_mm} mm away (up to {tolerance_mm} mm are joined)."},
      {StrayPiece, "stray-piece", Error,
       "A single piece, its ends {length_mm} mm apart, belongs to no contour; it may lie on top of another."},
      {BranchingChain, "branching-chain", Error, "{count} pieces meet here; a contour cannot branch."},
      {EndOnPiece, "end-on-piece", Error,
       "A piece ends here on another one, between that one's ends; a contour cannot branch. Remove one of them."},
      {NoContour, "no-contour", Error, "The drawing has no closed contour."},
      {ContourDegenerate, "contour-degenerate", Error, "The contour encloses no area."},
      {ContourCrossesItself, "contour-crosses-itself", Error, "The contour crosses or touches itself here."},
      {ContoursCross, "contours-cross", Error,
       "Contours {first} and {second} cross or touch here; move them apart in the drawing."},
      {ContoursTooDense, "contours-too-dense", Error,
       "From here on so many contours lie over or within each other that they cannot be checked (more than {most} "
       "comparisons); draw fewer."},
      {ChordsTooCoarse, "chords-too-coarse", Note,
       "The {count} joints from here on look like the chords of a curve but stay corners: they are joined from a "
       "smoothing tolerance of {needed_mm} mm on (now {tolerance_mm} mm)."},

      {SpikeInContour, "spike-in-contour", Error,
       "The contour turns back on itself here, in a tip of {angle_deg}°; that is a mistake of the drawing."},
      {Unreached, "unreached", Error,
       "The wheel of {wheel_mm} mm radius does not reach {length_mm} mm of the contour here; up to {left_mm} mm of "
       "glass "
       "would stay. Take a wheel of at most {largest_mm} mm, or accept that this stays unground."},
      {UnreachedAccepted, "unreached-accepted", Warning,
       "The wheel of {wheel_mm} mm radius does not reach {length_mm} mm of the contour here; up to {left_mm} mm of "
       "glass "
       "stay. A wheel of at most {largest_mm} mm would."},
      {ContourNotEntered, "contour-not-entered", Error,
       "The wheel of {wheel_mm} mm radius does not reach this contour of {length_mm} mm at all. Take a wheel of less "
       "than "
       "{largest_mm} mm, or accept that it stays unground."},
      {ContourLeftOut, "contour-left-out", Warning,
       "This contour of {length_mm} mm stays unground: the wheel of {wheel_mm} mm radius does not reach it. A wheel of "
       "less than {largest_mm} mm would."},
      {NothingToGrind, "nothing-to-grind", Error, "The wheel of {wheel_mm} mm radius reaches no contour at all."},
      {ConcaveFillet, "concave-fillet", Warning,
       "Corner {corner} is concave: the wheel leaves {fillet_mm} mm of glass before it, and {unground_mm} mm of its "
       "edges "
       "are not ground."},
      {TransitionBlocked, "transition-blocked", Warning,
       "Corner {corner}: a transition would touch other glass here; the wheel rolls round the corner instead."},
      {SizeCorrectionTooLarge, "size-correction-too-large", Error,
       "A size correction of {correction_mm} mm would change the shape of the contour here."},
      {NoRelief, "no-relief", Warning,
       "Corner {corner}: the wheel lifts by {lift_mm} mm, less than the {depth_mm} mm of glass at the tip."},
      {SlowCorner, "slow-corner", Warning, "Corner {corner} takes {time_s} s."},
      {NoLead, "no-lead", Error,
       "The wheel cannot {what} here: it needs {needed_mm} mm between its centre and the glass and has {distance_mm} "
       "mm. Start on a longer edge away from sharp corners, or change the lead's radius."},
      {NoLeadAccepted, "no-lead-accepted", Warning,
       "The wheel cannot {what} here: it needs {needed_mm} mm between its centre and the glass and has {distance_mm} "
       "mm. What it would grind from here stays unground."},
      {OverlapShortened, "overlap-shortened", Note,
       "The overlap is {used_mm} mm, a quarter of the contour, instead of {wanted_mm} mm."},
      {OutsideTravel, "outside-travel", Error,
       "The wheel path leaves the travel of the machine by {excess_mm} mm: {what}."},
      {WheelBelowTable, "wheel-below-table", Error,
       "The wheel's lower face would be {height_mm} mm above the table while grinding; it must stay {least_mm} mm "
       "above."},
      {ParkTooLow, "park-too-low", Error,
       "At the park position the wheel's lower face would be {height_mm} mm above the table, over or beside the glass; "
       "it must be {least_mm} mm above."},
      {HeightOutsideTravel, "height-outside-travel", Error,
       "The {what} height of {height_mm} mm is outside the travel of 0 to {most_mm} mm."},
      {GrindingAboveClearance, "grinding-above-clearance", Error,
       "The grinding height of {height_mm} mm is above the clearance height of {clearance_mm} mm."},

      {MachineSpeedBinds, "machine-speed-binds", Note,
       "The machine's greatest speed of the {axis} axis is below the feed; it limits the speed on the contour."},
      {NumericalFailure, "numerical-failure", Error, "Internal error: {reason}."},
      {Cancelled, "cancelled", Error, "It was given up before it was done."},

      {JobOfAnotherPattern, "job-of-another-pattern", Error,
       "The job that was broken off is of another pattern or an earlier state of it: {file} had the fingerprint {was}, "
       "now it has {is}."},
      {JobOfAnotherMachine, "job-of-another-machine", Error,
       "The job that was broken off was planned for another machine: {key} was {was}, now it is {is}."},
      {JobPlaceUnknown, "job-place-unknown", Error,
       "The place where the job was broken off (segment {segment}, {lambda_mm} mm) is not on the job as it is planned "
       "now."},
      {DriverNotAvailable, "driver-not-available", Error, "Axes through LinuxCNC are not available: {reason}."},
  };
  return kTable;
}

} // namespace arris::base
