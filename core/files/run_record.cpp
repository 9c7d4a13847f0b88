#include "core/files/run_record.h"

#include "core/base/window_thread.h"
#include "core/files/json_members.h"
#include "core/files/row_coding.h"

#include <boost/crc.hpp>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <cmath>

namespace arris::files {
namespace {

using base::Code;
using base::Expected;
using base::Problem;
using base::Problems;
using base::Unexpected;
using std::filesystem::path;

// As in PNG: no text begins with it, and a transfer that changes line ends is found out.
constexpr std::string_view kMagic = "\x89"
                                    "ARRISRUN\r\n";
constexpr std::string_view kRecordKey = "arris_record";
constexpr int kRecordVersion = 1;

constexpr char kHeaderBlock = 'H';
constexpr char kRowsBlock = 'R';
constexpr char kEventBlock = 'E';
constexpr char kEndBlock = 'Z';

constexpr std::size_t kNumberSize = 4;
constexpr std::size_t kBlockHead = 1 + 2 * kNumberSize;

/// The longest payload, bytes: more than `kMostRowsOfBlock` rows of full numbers.
constexpr std::size_t kLongestPayload = std::size_t{1} << 20;

std::string bytesOf(std::uint32_t number) {
  constexpr unsigned kBitsOfByte = 8;
  std::string bytes;
  for (std::size_t i = 0; i < kNumberSize; ++i, number >>= kBitsOfByte) {
    bytes += static_cast<char>(number);
  }
  return bytes;
}

std::uint32_t numberFrom(std::string_view bytes) {
  constexpr unsigned kBitsOfByte = 8;
  std::uint32_t number = 0;
  for (std::size_t i = kNumberSize; i-- > 0;) {
    number = (number << kBitsOfByte) | static_cast<unsigned char>(bytes[i]);
  }
  return number;
}

/// `head`: kind and length.
std::uint32_t checksum(std::string_view head, std::string_view payload) {
  boost::crc_32_type crc;
  crc.process_bytes(head.data(), head.size());
  crc.process_bytes(payload.data(), payload.size());
  return crc.checksum();
}

std::string blockOf(char kind, std::string_view payload) {
  assert(payload.size() <= kLongestPayload);
  const std::string head = kind + bytesOf(static_cast<std::uint32_t>(payload.size()));
  return head + bytesOf(checksum(head, payload)) + std::string(payload);
}

std::string headerText(const RecordHeader& header) {
  JsonWriter json;
  json.openObject();
  json.member(kRecordKey, kRecordVersion);
  json.openObject("pattern");
  json.member("file", header.patternFile);
  json.member("hash", header.patternHash);
  json.close();
  json.member("start", header.startTime);
  json.member("pane", header.pane);
  writeSettings(json, header.recipe, header.machine);
  json.close();
  return json.take();
}

Expected<RecordHeader> headerFrom(std::string_view text, const std::string& file) {
  const auto object = parseJson(text, file);
  if (!object) {
    return Unexpected(object.error());
  }
  if (const auto version = checkVersion(*object, kRecordKey, kRecordVersion, file); !version) {
    return Unexpected(version.error());
  }
  Problems problems;
  JsonMembers members(*object, problems);
  JsonMembers pattern(members.object("pattern"), problems);
  RecordHeader header;
  header.patternFile = pattern.text("file");
  header.patternHash = pattern.hash("hash");
  header.startTime = members.text("start");
  header.pane = members.count("pane", 1, kMostPanes);
  readMembers(members.object("recipe"), file, header.recipe, problems);
  readMembers(members.object("machine"), file, header.machine, problems);
  const auto isError = [](const Problem& problem) { return severityOf(problem) == base::Severity::Error; };
  if (const auto error = std::find_if(problems.begin(), problems.end(), isError); error != problems.end()) {
    return Unexpected(*error);
  }
  return header;
}

std::string eventText(const RunEvent& event) {
  Json object;
  object["t_s"] = event.time;
  object["code"] = event.code;
  object["values"] = valuesToJson(event.values);
  return oneLine(object);
}

std::optional<RunEvent> eventFrom(std::string_view text) {
  const auto object = parseJson(text, "");
  if (!object) {
    return std::nullopt;
  }
  Problems problems;
  JsonMembers members(*object, problems);
  RunEvent event;
  event.time = members.number("t_s", -kMostRecorded, kMostRecorded, "s");
  event.code = members.text("code");
  event.values = valuesFromJson(members.object("values"));
  return problems.empty() ? std::optional(std::move(event)) : std::nullopt;
}

enum class Found { Whole, Damaged, BreaksOff, Failed };

struct Block {
  char kind = 0;
  std::string payload;
};

/// The blocks of a file one after the other.
class BlockReader {
public:
  explicit BlockReader(Descriptor descriptor) : m_descriptor(std::move(descriptor)) {}

  Found read(std::size_t count, std::string& bytes) {
    bytes.resize(count);
    std::size_t size = 0;
    while (size < count) {
      const ssize_t more = ::read(m_descriptor.number(), bytes.data() + size, count - size);
      if (more == 0) {
        return Found::BreaksOff;
      }
      if (more < 0 && errno != EINTR) {
        m_error = errno;
        return Found::Failed;
      }
      size += more > 0 ? static_cast<std::size_t>(more) : 0;
    }
    m_place += static_cast<std::int64_t>(count);
    return Found::Whole;
  }

  // Damaged: the next one stands where this one's length says, if it is true.
  Found next(Block& block) {
    std::string head;
    if (const Found found = read(kBlockHead, head); found != Found::Whole) {
      return found;
    }
    const std::string_view checked = std::string_view(head).substr(0, 1 + kNumberSize);
    const std::size_t length = numberFrom(checked.substr(1));
    if (length > kLongestPayload) {
      return Found::Damaged;
    }
    if (const Found found = read(length, block.payload); found != Found::Whole) {
      return found;
    }
    block.kind = head[0];
    return checksum(checked, block.payload) == numberFrom(head.substr(1 + kNumberSize)) ? Found::Whole : Found::Damaged;
  }

  /// Bytes from the beginning of the file.
  [[nodiscard]] std::int64_t place() const {
    return m_place;
  }

  /// errno, where reading failed.
  [[nodiscard]] int error() const {
    return m_error;
  }

private:
  Descriptor m_descriptor;
  std::int64_t m_place = 0;
  int m_error = 0;
};

Descriptor openToRead(const path& file) {
  return Descriptor(open(file.c_str(), O_RDONLY | O_NOCTTY | O_CLOEXEC));
}

Unexpected malformedRecord(const path& file, const char* reason) {
  return Unexpected(Problem(Code::RecordMalformed, {{"file", file.string()}, {"reason", std::string(reason)}}));
}

/// Reads a record from its beginning on.
class RecordReader {
public:
  RecordReader(const path& file, Descriptor descriptor) : m_file(file), m_blocks(std::move(descriptor)) {}

  Expected<RecordHeader> header() {
    std::string magic;
    const Found begin = m_blocks.read(kMagic.size(), magic);
    if (begin == Found::Failed) {
      return Unexpected(systemProblem(Code::CannotRead, m_file, m_blocks.error()));
    }
    if (begin != Found::Whole || magic != kMagic) {
      return malformedRecord(m_file, "it does not begin like one");
    }
    Block block;
    if (m_blocks.next(block) != Found::Whole || block.kind != kHeaderBlock) {
      return malformedRecord(m_file, "its header is damaged");
    }
    return headerFrom(block.payload, m_file.string());
  }

  // Behind a damaged block reading goes on where the next one is whole.
  Expected<void> rest(RunRecord& record, const RecordListener& listener) {
    bool afterDamage = false;
    while (!m_ended && static_cast<std::int64_t>(record.damage.size()) < base::kMostOfOneCode) {
      const std::int64_t place = m_blocks.place();
      const Found found = nextTaken(listener);
      if (found == Found::Failed) {
        return Unexpected(systemProblem(Code::CannotRead, m_file, m_blocks.error()));
      }
      if (found != Found::Whole && !afterDamage) {
        record.damage.push_back(damage(place, found));
      }
      if (found == Found::BreaksOff || (found == Found::Damaged && afterDamage)) {
        return {};
      }
      afterDamage = found == Found::Damaged;
    }
    record.complete = record.damage.empty();
    return {};
  }

private:
  Found nextTaken(const RecordListener& listener) {
    Block block;
    const Found found = m_blocks.next(block);
    return found == Found::Whole && !take(block, listener) ? Found::Damaged : found;
  }

  // False where the payload is not what it should be.
  bool take(const Block& block, const RecordListener& listener) {
    if (block.kind == kRowsBlock) {
      return takeRows(block.payload, listener);
    }
    if (block.kind == kEventBlock) {
      const auto event = eventFrom(block.payload);
      if (event && listener.event) {
        listener.event(*event);
      }
      return event.has_value();
    }
    m_ended = block.kind == kEndBlock;
    return true;
  }

  bool takeRows(std::string_view payload, const RecordListener& listener) {
    const auto rows = decodeRows(payload);
    if (!rows || (!rows->empty() && m_lastTime && recordedTime(rows->front()) <= *m_lastTime)) {
      return false;
    }
    if (!rows->empty()) {
      m_lastTime = recordedTime(rows->back());
    }
    if (listener.row) {
      std::for_each(rows->begin(), rows->end(), listener.row);
    }
    return true;
  }

  [[nodiscard]] Problem damage(std::int64_t place, Found found) const {
    const char* reason = found == Found::BreaksOff ? "it breaks off" : "it is damaged";
    return Problem(Code::RecordDamaged, {{"file", m_file.string()}, {"reason", std::string(reason)}, {"byte", place}});
  }

  const path& m_file;
  BlockReader m_blocks;
  std::optional<std::int64_t> m_lastTime;
  bool m_ended = false;
};

} // namespace

RecordWriter::RecordWriter(path file, Descriptor descriptor, double period)
    : m_file(std::move(file)), m_descriptor(std::move(descriptor)),
      m_rowsOfBlock(
          static_cast<std::size_t>(std::clamp(std::ceil(1 / period), 1.0, static_cast<double>(kMostRowsOfBlock)))) {}

Expected<RecordWriter> RecordWriter::open(const path& file, const RecordHeader& header) {
  constexpr mode_t kAsTheUserMaskAllows = 0666;
  Descriptor descriptor(::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kAsTheUserMaskAllows));
  if (!descriptor.isOpen()) {
    return Unexpected(systemProblem(Code::CannotWrite, file, errno));
  }
  RecordWriter writer(file, std::move(descriptor), header.machine.period);
  const std::string text = headerText(header);
  if (text.size() > kLongestPayload) { // a recipe may name any number of layers
    return Unexpected(systemProblem(Code::CannotWrite, file, EFBIG));
  }
  if (const auto written = writer.write(std::string(kMagic) + blockOf(kHeaderBlock, text)); !written) {
    return Unexpected(written.error());
  }
  return writer;
}

Expected<void> RecordWriter::add(const RunRow& row) {
  if (m_failure) {
    return Unexpected(*m_failure);
  }
  if (auto checked = checkRow(row); !checked) {
    return checked;
  }
  const std::int64_t time = recordedTime(row);
  if (m_lastTime && time <= *m_lastTime) {
    return Unexpected(Problem(Code::NumericalFailure, {{"reason", std::string("the time of the run stands still")}}));
  }
  m_lastTime = time;
  m_rows.push_back(row);
  return m_rows.size() < m_rowsOfBlock ? Expected<void>() : flush();
}

Expected<void> RecordWriter::add(const RunEvent& event) {
  if (m_failure) {
    return Unexpected(*m_failure);
  }
  if (!(std::abs(event.time) <= kMostRecorded)) {
    return Unexpected(
        Problem(Code::NumericalFailure, {{"reason", fmt::format("t_s is {} in an event of the run", event.time)}}));
  }
  const std::string text = eventText(event);
  if (text.size() > kLongestPayload) {
    return Unexpected(Problem(Code::NumericalFailure, {{"reason", std::string("an event of the run is too long")}}));
  }
  m_events += blockOf(kEventBlock, text);
  return {};
}

Expected<void> RecordWriter::flush() {
  std::string bytes;
  if (!m_rows.empty()) {
    bytes = blockOf(kRowsBlock, encodeRows(m_rows));
    m_rows.clear();
  }
  bytes += std::exchange(m_events, {});
  return write(bytes);
}

Expected<void> RecordWriter::close() {
  if (auto flushed = flush(); !flushed) {
    return flushed;
  }
  if (auto written = write(blockOf(kEndBlock, {})); !written) {
    return written;
  }
  return fsync(m_descriptor.number()) == 0 && m_descriptor.close() ? Expected<void>() : fail(errno);
}

Expected<void> RecordWriter::write(std::string_view bytes) {
  if (m_failure) {
    return Unexpected(*m_failure);
  }
  const WriteSignalsBlocked blocked;
  Output output(m_descriptor.number());
  output.write(bytes);
  if (output.failed()) {
    (void)!ftruncate(m_descriptor.number(), m_size); // half a block is of no use
    return fail(output.error());
  }
  m_size += static_cast<std::int64_t>(bytes.size());
  return {};
}

Expected<void> RecordWriter::fail(int error) {
  m_failure = systemProblem(Code::CannotWrite, m_file, error);
  return Unexpected(*m_failure);
}

bool isRecord(const path& file) {
  std::error_code none;
  std::string magic;
  return std::filesystem::is_regular_file(file, none) &&
         BlockReader(openToRead(file)).read(kMagic.size(), magic) == Found::Whole && magic == kMagic;
}

Expected<RunRecord> readRecord(const path& file, const RecordListener& listener) {
  base::takesLong("readRecord");
  Descriptor descriptor = openToRead(file);
  if (!descriptor.isOpen()) {
    return Unexpected(systemProblem(Code::CannotOpen, file, errno));
  }
  RecordReader reader(file, std::move(descriptor));
  auto header = reader.header();
  if (!header) {
    return Unexpected(header.error());
  }
  RunRecord record;
  record.header = *std::move(header);
  return reader.rest(record, listener).map([&] { return std::move(record); });
}

Expected<RunRecord> readRecord(const path& file) {
  std::vector<RunRow> rows;
  std::vector<RunEvent> events;
  auto record = readRecord(
      file, {[&](const RunRow& row) { rows.push_back(row); }, [&](const RunEvent& event) { events.push_back(event); }});
  if (record) {
    record->rows = std::move(rows);
    record->events = std::move(events);
  }
  return record;
}

Expected<RecordHeader> readRecordHeader(const path& file) {
  Descriptor descriptor = openToRead(file);
  if (!descriptor.isOpen()) {
    return Unexpected(systemProblem(Code::CannotOpen, file, errno));
  }
  return RecordReader(file, std::move(descriptor)).header();
}

Expected<RunRecord> writeProfile(const path& record, Output& output) {
  RunProfileWriter writer(output);
  auto read = readRecord(record, {[&](const RunRow& row) { writer.add(row); }, {}});
  writer.flush();
  return read;
}

Expected<void> writeProfileFile(const path& record, const path& file) {
  Expected<void> read;
  auto written = writeWholeFile(file, [&](Output& output) {
    if (const auto result = writeProfile(record, output); !result) {
      read = Unexpected(result.error());
      output.abandon();
    }
  });
  return read ? written : read;
}

} // namespace arris::files
