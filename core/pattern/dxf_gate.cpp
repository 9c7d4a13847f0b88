#include "core/pattern/dxf_gate.h"

#include "core/pattern/binary_dxf.h"
#include "core/pattern/units.h"

#include <algorithm>
#include <cmath>

namespace arris::pattern {
namespace {

using base::Code;
using base::Problem;
using base::Unexpected;

Problem sectionProblem(std::string reason, std::int64_t line) {
  return Problem(Code::DxfSection, {{"reason", std::move(reason)}}).onLine(line);
}

bool isTypeName(std::string_view text) {
  return std::any_of(text.begin(), text.end(), [](char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); });
}

/// One walk over the groups of a text, section by section.
class Gate {
public:
  Gate(std::string_view text, std::optional<recipe::Units> units, std::stop_token stop)
      : m_text(text), m_cursor(text), m_units(units), m_stop(std::move(stop)) {}

  base::Expected<Inventory> inspect();

private:
  enum class Section { None, Unnamed, Header, Tables, Blocks, Entities, Other };

  // Each step returns what is wrong, if anything.
  using Step = std::optional<Problem>;

  Step takeType(const Group& group);
  Step takeGroup(const Group& group);
  Step beginSection(const Group& group);
  Step endSection(const Group& group);
  Step nameSection(const Group& group);
  Step takeVariable(const Group& group);
  void takeLayerGroup(const Group& group);
  void finishLayer();
  Step takeTypeInBlocks(const Group& group);
  Step endBlock(const Group& group);
  void keepBlock();
  void takeBlockGroup(const Group& group);
  Step takeEntityGroup(const Group& group);
  [[nodiscard]] std::vector<Entity>& entities();
  Step beginEntity(const Group& group);
  Step finishEntity();
  void keep(const Entity& entity);
  [[nodiscard]] Step checkSequence(const Group& group) const;
  [[nodiscard]] Problem atTheEnd() const;

  std::string_view m_text;
  GroupCursor m_cursor;
  std::optional<recipe::Units> m_units;
  std::stop_token m_stop;
  Inventory m_found;

  Section m_section = Section::None;
  std::string_view m_sectionName;
  std::string_view m_variable;
  std::optional<EntityCheck> m_entity;
  std::size_t m_beforeGroup = 0; ///< byte at which the current group begins
  std::size_t m_entityBegin = 0; ///< byte after the current entity's name
  std::size_t m_bodyBegin = 0;   ///< the same of the last entity kept, its vertices included
  double m_mostCoordinate = kMostCoordinate;

  enum class Sequence { None, Polyline, Attributes };
  Sequence m_sequence = Sequence::None;
  std::int64_t m_sequenceLine = 0;

  struct LayerRecord {
    std::string_view name;
    bool off = false;
    bool frozen = false;
  };

  std::optional<LayerRecord> m_layer;
  std::optional<Block> m_block;
  bool m_ended = false;
};

base::Expected<Inventory> Gate::inspect() {
  Group group;
  m_beforeGroup = m_cursor.offset();
  while (!m_ended && m_cursor.next(group)) {
    if (m_stop.stop_requested()) {
      return Unexpected(Problem(Code::Cancelled));
    }
    const Step problem = group.code == 0 ? takeType(group) : takeGroup(group);
    if (problem) {
      return Unexpected(problem->line ? *problem : Problem(*problem).onLine(group.line));
    }
    m_beforeGroup = m_cursor.offset();
  }
  if (m_cursor.problem()) {
    return Unexpected(*m_cursor.problem());
  }
  if (!m_ended) {
    return Unexpected(atTheEnd());
  }
  const std::size_t nul = m_text.substr(0, m_cursor.offset()).find('\0');
  if (nul != std::string_view::npos) {
    const auto line = 1 + std::count(m_text.begin(), m_text.begin() + static_cast<std::ptrdiff_t>(nul), '\n');
    return Unexpected(Problem(Code::DxfNotDxf, {{"reason", "it holds NUL bytes"}}).onLine(line));
  }
  return std::move(m_found);
}

Problem Gate::atTheEnd() const {
  std::string reason = "there is no EOF";
  if (m_sequence == Sequence::Polyline) {
    reason += "; the last POLYLINE has no SEQEND";
  } else if (m_section != Section::None) {
    reason += ", and section " + readable(m_sectionName) + " has no ENDSEC";
  }
  return Problem(Code::DxfTruncated, {{"reason", reason}}).onLine(m_cursor.line());
}

Gate::Step Gate::takeType(const Group& group) {
  finishLayer();
  if (Step problem = finishEntity()) {
    return problem;
  }
  if (group.value == "SECTION") {
    return beginSection(group);
  }
  if (group.value == "ENDSEC" || group.value == "EOF") {
    return endSection(group);
  }
  if (m_section == Section::None || m_section == Section::Unnamed) {
    return sectionProblem(quoted(group.value) + " stands outside of any section", group.line);
  }
  if (m_section == Section::Tables && group.value == "LAYER") {
    m_layer = LayerRecord{};
  }
  if (m_section == Section::Blocks) {
    return takeTypeInBlocks(group);
  }
  return m_section == Section::Entities ? beginEntity(group) : std::nullopt;
}

Gate::Step Gate::takeTypeInBlocks(const Group& group) {
  if (group.value == "BLOCK") {
    if (m_block) {
      return sectionProblem("block " + quoted(m_block->name) + " has no ENDBLK", group.line);
    }
    m_block.emplace().line = group.line;
    return std::nullopt;
  }
  if (group.value == "ENDBLK") {
    return endBlock(group);
  }
  if (!m_block) {
    return sectionProblem(quoted(group.value) + " stands outside of any block", group.line);
  }
  return beginEntity(group);
}

Gate::Step Gate::endBlock(const Group& group) {
  if (!m_block) {
    return sectionProblem("ENDBLK without a BLOCK", group.line);
  }
  if (m_sequence == Sequence::Polyline) {
    return sectionProblem("the POLYLINE of line " + std::to_string(m_sequenceLine) + " has no SEQEND", group.line);
  }
  m_sequence = Sequence::None;
  keepBlock();
  return std::nullopt;
}

void Gate::keepBlock() {
  const std::int64_t line = m_block->line;
  const auto [known, isNew] = m_found.blocks.try_emplace(layerKey(m_block->name), std::move(*m_block));
  if (!isNew && !known->second.problem) {
    known->second.problem =
        Problem(Code::BlockTwice, {{"block", quoted(known->second.name)}, {"first", known->second.line}}).onLine(line);
  }
  m_block.reset();
}

void Gate::takeBlockGroup(const Group& group) {
  if (group.code == 2) {
    m_block->name = group.value;
  } else if (group.code == 70) {
    m_block->flags = wholeNumber(group.value).value_or(0);
  } else if (group.code == 10 || group.code == 20) {
    const std::optional<double> number = finiteNumber(group.value);
    if (number && std::abs(*number) <= m_mostCoordinate) {
      m_block->base.at(group.code == 10 ? 0 : 1) = *number;
    } else if (!m_block->problem) {
      m_block->problem = Problem(Code::DxfNumber, {{"group", std::int64_t{group.code}}, {"found", quoted(group.value)}})
                             .onLine(group.line);
    }
  }
}

std::vector<Entity>& Gate::entities() {
  return m_block ? m_block->entities : m_found.entities;
}

Gate::Step Gate::beginSection(const Group& group) {
  if (m_section != Section::None) {
    return sectionProblem("section " + readable(m_sectionName) + " has no ENDSEC before the next SECTION", group.line);
  }
  m_section = Section::Unnamed;
  m_sectionName = {};
  return std::nullopt;
}

Gate::Step Gate::endSection(const Group& group) {
  if (m_sequence == Sequence::Polyline) {
    return sectionProblem("the POLYLINE of line " + std::to_string(m_sequenceLine) + " has no SEQEND", group.line);
  }
  if (m_block) {
    return sectionProblem("block " + quoted(m_block->name) + " has no ENDBLK", group.line);
  }
  m_sequence = Sequence::None;
  m_ended = group.value == "EOF";
  if (m_ended && m_section != Section::None) {
    return sectionProblem("section " + readable(m_sectionName) + " has no ENDSEC before EOF", group.line);
  }
  if (!m_ended && (m_section == Section::None || m_section == Section::Unnamed)) {
    return sectionProblem("ENDSEC without a SECTION", group.line);
  }
  m_section = Section::None;
  return std::nullopt;
}

Gate::Step Gate::takeGroup(const Group& group) {
  constexpr int kComment = 999;
  if (group.code == kComment) {
    return std::nullopt;
  }
  switch (m_section) {
  case Section::None:
    return sectionProblem("group " + std::to_string(group.code) + " stands outside of any section", group.line);
  case Section::Unnamed:
    return nameSection(group);
  case Section::Header:
    return takeVariable(group);
  case Section::Tables:
    takeLayerGroup(group);
    return std::nullopt;
  case Section::Entities:
    if (!m_entity) {
      return sectionProblem("group " + std::to_string(group.code) + " belongs to no entity", group.line);
    }
    return m_entity->take(group);
  case Section::Blocks:
    if (m_entity) {
      return takeEntityGroup(group);
    }
    if (m_block) {
      takeBlockGroup(group);
    }
    return std::nullopt;
  case Section::Other:
    return std::nullopt;
  }
  return std::nullopt;
}

// Within a block what is wrong does not matter yet.
Gate::Step Gate::takeEntityGroup(const Group& group) {
  const Step problem = m_entity->take(group);
  if (problem && !m_block->problem) {
    m_block->problem = problem->line ? *problem : Problem(*problem).onLine(group.line);
  }
  return std::nullopt;
}

Gate::Step Gate::nameSection(const Group& group) {
  if (group.code != 2) {
    return sectionProblem("the section has no name", group.line);
  }
  m_sectionName = group.value;
  m_section = group.value == "HEADER"     ? Section::Header
              : group.value == "TABLES"   ? Section::Tables
              : group.value == "BLOCKS"   ? Section::Blocks
              : group.value == "ENTITIES" ? Section::Entities
                                          : Section::Other;
  if (m_section == Section::Entities || m_section == Section::Blocks) {
    const FoundUnits units = findUnits(m_units, m_found.insUnits, m_found.measurement);
    m_mostCoordinate = kMostCoordinate / millimetresPer(units.units);
  }
  return std::nullopt;
}

Gate::Step Gate::takeVariable(const Group& group) {
  if (group.code == 9) {
    m_variable = group.value;
    return std::nullopt;
  }
  if (group.code != 70 || (m_variable != "$INSUNITS" && m_variable != "$MEASUREMENT")) {
    return std::nullopt;
  }
  const std::optional<std::int64_t> number = wholeNumber(group.value);
  if (!number) {
    return Problem(Code::DxfNumber, {{"group", std::int64_t{group.code}}, {"found", quoted(group.value)}});
  }
  (m_variable == "$INSUNITS" ? m_found.insUnits : m_found.measurement) = number;
  return std::nullopt;
}

// What the layer table says decides only about visibility; a number that is none there leaves the layer visible.
void Gate::takeLayerGroup(const Group& group) {
  constexpr std::int64_t kFrozen = 1;
  if (!m_layer) {
    return;
  }
  if (group.code == 2) {
    m_layer->name = group.value;
  } else if (group.code == 62) { // the colour of a layer that is off is negative
    m_layer->off = wholeNumber(group.value).value_or(0) < 0;
  } else if (group.code == 70) {
    m_layer->frozen = (wholeNumber(group.value).value_or(0) & kFrozen) != 0;
  }
}

void Gate::finishLayer() {
  if (m_layer && m_layer->frozen) {
    m_found.frozenLayers.insert(layerKey(m_layer->name));
  } else if (m_layer && m_layer->off) {
    m_found.offLayers.insert(layerKey(m_layer->name));
  }
  m_layer.reset();
}

Gate::Step Gate::beginEntity(const Group& group) {
  if (!isTypeName(group.value)) {
    return sectionProblem(quoted(group.value) + " is not the name of an entity", group.line);
  }
  m_entity.emplace(group, m_mostCoordinate);
  m_entityBegin = m_cursor.offset();
  return checkSequence(group);
}

Gate::Step Gate::checkSequence(const Group& group) const {
  const EntityKind kind = m_entity->entity().kind;
  if (m_sequence == Sequence::Polyline && kind != EntityKind::Vertex && kind != EntityKind::SequenceEnd) {
    return sectionProblem("the POLYLINE of line " + std::to_string(m_sequenceLine) + " has no SEQEND before " +
                              readable(group.value),
                          group.line);
  }
  if ((kind == EntityKind::Vertex && m_sequence != Sequence::Polyline) ||
      (kind == EntityKind::SequenceEnd && m_sequence == Sequence::None)) {
    return sectionProblem(readable(group.value) + " without a POLYLINE before it", group.line);
  }
  return std::nullopt;
}

Gate::Step Gate::finishEntity() {
  if (!m_entity) {
    return std::nullopt;
  }
  Step problem = m_entity->finish();
  if (!problem && m_sequence == Sequence::Polyline && m_entity->entity().kind == EntityKind::SequenceEnd &&
      entities().back().vertices == 0) {
    problem =
        Problem(Code::DxfEntityIncomplete, {{"entity", "POLYLINE"}, {"group", std::int64_t{0}}, {"what", "VERTEX"}})
            .onLine(m_sequenceLine);
  }
  if (problem && m_block) {
    m_block->problem = m_block->problem ? m_block->problem : problem;
    problem.reset();
  }
  if (!problem) {
    keep(m_entity->entity());
  }
  m_entity.reset();
  return problem;
}

// A polyline takes its vertices in; an insert may be followed by attributes and their end.
void Gate::keep(const Entity& entity) {
  if (entity.kind == EntityKind::Vertex) {
    Entity& polyline = entities().back();
    const auto [lowest, highest] = polyline.heights;
    polyline.heights = polyline.vertices == 0
                           ? entity.heights
                           : std::array{std::min(lowest, entity.heights[0]), std::max(highest, entity.heights[0])};
    ++polyline.vertices;
  } else if (entity.kind != EntityKind::SequenceEnd) {
    entities().push_back(entity);
    m_bodyBegin = m_entityBegin;
    m_sequenceLine = entity.line;
    m_sequence = entity.kind == EntityKind::Polyline                            ? Sequence::Polyline
                 : entity.kind == EntityKind::Insert || entity.type == "ATTRIB" ? Sequence::Attributes
                                                                                : Sequence::None;
  } else {
    m_sequence = Sequence::None;
  }
  entities().back().body = m_text.substr(m_bodyBegin, m_beforeGroup - m_bodyBegin);
}

/// What the text is instead of an ASCII DXF file, where its first bytes tell.
std::optional<Problem> notEvenText(std::string_view text) {
  const auto notDxf = [](std::string reason) { return Problem(Code::DxfNotDxf, {{"reason", std::move(reason)}}); };
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
    return Problem(Code::DxfEmpty);
  }
  if (text.starts_with("AC10")) {
    return notDxf("it is a DWG drawing; save it as DXF");
  }
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
    return notDxf("it is UTF-16 text; save it as ASCII DXF");
  }
  if (text.find('\n') == std::string_view::npos && text.find('\r') != std::string_view::npos) {
    return Problem(Code::DxfLineEnds).onLine(1);
  }
  Group first;
  GroupCursor cursor(text);
  const std::string_view line = text.substr(0, text.find_first_of("\r\n"));
  if (!cursor.next(first) && cursor.problem()->code == Code::DxfGroupCode && !line.empty()) {
    return notDxf("it begins with " + quoted(line) + " and not with a group code").onLine(1);
  }
  return std::nullopt;
}

} // namespace

base::Expected<Inventory> inspectDxf(std::string_view text, std::optional<recipe::Units> units,
                                     const std::stop_token& stop) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (isBinaryDxf(text)) {
    base::Expected<std::string> converted = textOfBinaryDxf(text);
    if (!converted) {
      return Unexpected(converted.error());
    }
    auto kept = std::make_unique<const std::string>(*std::move(converted));
    base::Expected<Inventory> found = Gate(*kept, units, stop).inspect();
    if (found) {
      found->converted = std::move(kept);
    }
    return found;
  }
  if (text.starts_with(kByteOrderMark)) {
    text.remove_prefix(kByteOrderMark.size());
  }
  if (std::optional<Problem> problem = notEvenText(text)) {
    return Unexpected(*std::move(problem));
  }
  return Gate(text, units, stop).inspect();
}

std::string layerKey(std::string_view name) {
  std::string key(name);
  std::transform(key.begin(), key.end(), key.begin(), [](char c) { return c >= 'a' && c <= 'z' ? char(c - 32) : c; });
  return key;
}

} // namespace arris::pattern
