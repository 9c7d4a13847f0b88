#include "core/files/bundle.h"

#include "core/base/utf8.h"
#include "core/files/whole_file.h"

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <memory>
#include <utility>

namespace arris::files {
namespace {

using base::Code;
using base::Expected;
using base::Unexpected;
using std::filesystem::path;

constexpr unsigned kBundleMode = 0644;
constexpr std::size_t kLongestNameShown = 80; // bytes

struct FreeArchive {
  void operator()(archive* opened) const {
    archive_free(opened);
  }
};

struct FreeEntry {
  void operator()(archive_entry* entry) const {
    archive_entry_free(entry);
  }
};

using ArchivePointer = std::unique_ptr<archive, FreeArchive>;
using EntryPointer = std::unique_ptr<archive_entry, FreeEntry>;

la_ssize_t toOutput(archive* /*writer*/, void* output, const void* bytes, std::size_t size) {
  auto* const target = static_cast<Output*>(output);
  target->write({static_cast<const char*>(bytes), size});
  return target->failed() ? -1 : static_cast<la_ssize_t>(size);
}

bool addFile(archive* writer, const BundledFile& file) {
  const EntryPointer entry(archive_entry_new());
  archive_entry_set_pathname(entry.get(), file.name.c_str());
  archive_entry_set_size(entry.get(), static_cast<la_int64_t>(file.bytes.size()));
  archive_entry_set_filetype(entry.get(), AE_IFREG);
  archive_entry_set_perm(entry.get(), kBundleMode);
  archive_entry_set_mtime(entry.get(), std::time(nullptr), 0);
  return archive_write_header(writer, entry.get()) == ARCHIVE_OK &&
         archive_write_data(writer, file.bytes.data(), file.bytes.size()) == static_cast<la_ssize_t>(file.bytes.size());
}

// GNU tar: names are bytes there, whatever the locale of this process.
bool writeAll(Output& output, const BundledFiles& files) {
  const ArchivePointer writer(archive_write_new());
  return archive_write_set_format_gnutar(writer.get()) == ARCHIVE_OK &&
         archive_write_add_filter_gzip(writer.get()) == ARCHIVE_OK &&
         archive_write_open(writer.get(), &output, nullptr, toOutput, nullptr) == ARCHIVE_OK &&
         std::all_of(files.begin(), files.end(),
                     [&](const BundledFile& file) { return addFile(writer.get(), file); }) &&
         archive_write_close(writer.get()) == ARCHIVE_OK;
}

// Of a stranger: short, and no bytes that a terminal or window would take for more than text.
std::string shownName(std::string name) {
  if (!base::isUtf8(name)) {
    return "?";
  }
  std::replace_if(
      name.begin(), name.end(), [](char c) { return (c >= 0 && c < ' ') || c == '\x7f'; }, '?');
  if (name.size() > kLongestNameShown) {
    std::size_t end = kLongestNameShown;
    while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0U) == 0x80U) {
      --end;
    }
    name = name.substr(0, end) + "…";
  }
  return name;
}

/// Takes the files out of an archive one by one and counts what they need.
class BundleReader {
public:
  BundleReader(const path& file, const BundleLimits& limits) : m_file(file), m_limits(limits) {}

  Expected<BundledFiles> read(const std::string& bytes) {
    const ArchivePointer reader(archive_read_new());
    if (archive_read_support_format_tar(reader.get()) != ARCHIVE_OK ||
        archive_read_support_filter_gzip(reader.get()) != ARCHIVE_OK ||
        archive_read_open_memory(reader.get(), bytes.data(), bytes.size()) != ARCHIVE_OK) {
      return malformed("it is no archive of Arris");
    }
    BundledFiles files;
    archive_entry* entry = nullptr;
    int status = archive_read_next_header(reader.get(), &entry);
    for (; status == ARCHIVE_OK; status = archive_read_next_header(reader.get(), &entry)) {
      auto file = take(reader.get(), entry, files);
      if (!file) {
        return Unexpected(file.error());
      }
      files.push_back(*std::move(file));
    }
    if (status != ARCHIVE_EOF) {
      return malformed(files.empty() ? "it is no archive of Arris" : "it is damaged or cut off");
    }
    return files;
  }

private:
  [[nodiscard]] Unexpected malformed(std::string reason) const {
    return Unexpected(malformedBundle(m_file, std::move(reason)));
  }

  Expected<BundledFile> take(archive* reader, archive_entry* entry, const BundledFiles& before) {
    const char* const name = archive_entry_pathname(entry);
    if (name == nullptr || *name == '\0') {
      return malformed("it is damaged or cut off");
    }
    BundledFile file{name, {}};
    const bool isPlain = archive_entry_filetype(entry) == AE_IFREG && archive_entry_hardlink(entry) == nullptr &&
                         archive_entry_symlink(entry) == nullptr;
    if (!isPlain) {
      return malformed(fmt::format("{} is no plain file", shownName(file.name)));
    }
    if (std::any_of(before.begin(), before.end(), [&](const BundledFile& other) { return other.name == file.name; })) {
      return malformed(fmt::format("{} stands there twice", shownName(file.name)));
    }
    if (before.size() >= m_limits.files) {
      return malformed("it is larger than a back-up can be");
    }
    return fill(reader, std::move(file));
  }

  // By what comes out, not by what the archive says of itself.
  Expected<BundledFile> fill(archive* reader, BundledFile file) {
    std::array<char, 65536> piece{};
    while (true) {
      const la_ssize_t count = archive_read_data(reader, piece.data(), piece.size());
      if (count < 0) {
        return malformed("it is damaged or cut off");
      }
      if (count == 0) {
        return file;
      }
      const auto size = static_cast<std::size_t>(count);
      m_all += size;
      if (file.bytes.size() + size > m_limits.file || m_all > m_limits.all) {
        return malformed("it is larger than a back-up can be");
      }
      file.bytes.append(piece.data(), size);
    }
  }

  const path& m_file;
  const BundleLimits& m_limits;
  std::size_t m_all = 0; ///< bytes of all files so far
};

} // namespace

base::Problem malformedBundle(const path& archive, std::string reason) {
  return base::Problem(Code::BundleMalformed, {{"file", archive.string()}, {"reason", std::move(reason)}});
}

Expected<void> writeBundle(const path& archive, const BundledFiles& files) {
  return writeWholeFile(archive, [&](Output& output) {
    if (!writeAll(output, files) && !output.failed()) {
      output.abandon();
    }
  });
}

Expected<BundledFiles> readBundle(const path& archive, const BundleLimits& limits) {
  std::error_code none;
  if (const auto size = std::filesystem::file_size(archive, none); !none && size > limits.archive) {
    return Unexpected(malformedBundle(archive, "it is larger than a back-up can be"));
  }
  return readFile(archive).and_then(
      [&](const std::string& bytes) { return BundleReader(archive, limits).read(bytes); });
}

} // namespace arris::files
