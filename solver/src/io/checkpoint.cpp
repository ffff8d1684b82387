#include "io/checkpoint.h"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "core/error.h"
#include "core/text.h"
#include "core/version.h"
#include "io/atomic_file.h"
#include "io/columns.h"
#include "io/content_hash.h"
#include "io/hdf5.h"
#include "io/realisation_hdf5.h"

namespace colloid {

namespace {

constexpr std::size_t kHeaderSize = 512;  // the smallest user block HDF5 knows
constexpr std::string_view kMagic = "poreclog checkpoint, format ";
constexpr int kFormat = 1;

/// The user block in front of `image`.
std::string header_of(std::string_view image) {
  std::string header = fmt::format("{}{}\nbytes {}\nsha256 {}\n", kMagic, kFormat,
                                   image.size(), sha256(image));
  header.resize(kHeaderSize, '\0');
  return header;
}

std::string file_content(const std::string& path) {
  std::error_code ignored;
  require(std::filesystem::exists(path, ignored), path, "there is no such checkpoint");
  require(std::filesystem::is_regular_file(path, ignored), path,
          "is a folder or device, expected a checkpoint");
  std::ifstream file(path, std::ios::binary);
  require(file.is_open(), path,
          [] { return "cannot be opened: " + std::generic_category().message(errno); });
  std::string content(std::filesystem::file_size(path), '\0');
  file.read(content.data(), static_cast<std::streamsize>(content.size()));
  require(file.good() || content.empty(), path, "cannot be read");
  return content;
}

/// The HDF5 file inside `content`, of which every bit is as it was written.
std::string_view checked_image(const std::string& path, std::string_view content) {
  const std::string_view start = content.substr(0, kMagic.size());
  require(start == kMagic.substr(0, start.size()), path,
          "is not a checkpoint of poreclog");
  require(content.size() > kHeaderSize, path, [&] {
    return fmt::format("is cut short: {} bytes, not even its header", content.size());
  });
  const std::string_view format =
      content.substr(kMagic.size(), content.find('\n') - kMagic.size());
  require(format == std::to_string(kFormat), path, [&] {
    return fmt::format("is a checkpoint of format {}, expected {}",
                       printable(format.substr(0, 16)), kFormat);
  });
  const std::string_view image = content.substr(kHeaderSize);
  require(content.substr(0, kHeaderSize) == header_of(image), path, [&] {
    return fmt::format(
        "is damaged: its {} bytes are not those that were written (size or SHA-256)",
        content.size());
  });
  return image;
}

/// Identity: like declare_outcome of layout.h.
template <class Archive, class I>
void declare_identity(Archive& archive, I& identity) {
  archive.value("scene_hash", identity.scene_hash);
  archive.value("seed", identity.seed);
  archive.value("tier", identity.tier);
  archive.value("version", identity.version);
  archive.value("commit", identity.commit);
}

void require_same(const std::string& path, const char* what, const std::string& found,
                  const std::string& expected) {
  require(found == expected, path, [&] {
    return fmt::format("is a checkpoint of another {}: {}, expected {}", what,
                       printable(found), printable(expected));
  });
}

void require_identity(const std::string& path, const RunIdentity& found,
                      const RunIdentity& expected) {
  require_same(path, "program version", found.version, expected.version);
  require_same(path, "program build (commit)", found.commit, expected.commit);
  require_same(path, "scene (SHA-256)", found.scene_hash, expected.scene_hash);
  require_same(path, "tier", found.tier, expected.tier);
  require_same(path, "seed", std::to_string(found.seed), std::to_string(expected.seed));
}

template <class T>
void write_arrays(const H5Handle& group,
                  const std::map<std::string, std::vector<T>>& arrays) {
  for (const auto& [name, values] : arrays) {
    put_array(group, name, {"SI", "state of the tier"}, {values.size()}, values);
  }
}

template <class T>
void read_arrays(const H5Handle& group, std::map<std::string, std::vector<T>>& arrays) {
  for (const std::string& name : member_names(group)) {
    get_array(group, name, arrays[name]);
  }
}

std::string image_of(const Checkpoint& checkpoint) {
  const H5Handle root = create_image();
  AttributeWriter identity(root);
  declare_identity(identity, checkpoint.identity);
  write_realisation(create_group(root, "realisation"), checkpoint.realisation);
  write_arrays(create_group(root, "reals"), checkpoint.reals);
  write_arrays(create_group(root, "integers"), checkpoint.integers);
  return image_bytes(root);
}

}  // namespace

RunIdentity run_identity(const Scene& scene, std::uint64_t seed,
                         const std::string& tier) {
  return {scene_hash(scene), seed, tier, project_version(), git_commit()};
}

void write_checkpoint(const std::string& path, const Checkpoint& checkpoint) {
  AtomicFile file(path);
  const std::string image = image_of(checkpoint);
  file.write(header_of(image) + image);
  file.commit();
}

Checkpoint read_checkpoint(const std::string& path, const RunIdentity& expected) {
  const std::string content = file_content(path);
  const H5Handle root = open_image(checked_image(path, content));
  Checkpoint checkpoint;
  AttributeReader identity(root);
  declare_identity(identity, checkpoint.identity);
  require_identity(path, checkpoint.identity, expected);
  checkpoint.realisation = read_realisation(open_group(root, "realisation"));
  read_arrays(open_group(root, "reals"), checkpoint.reals);
  read_arrays(open_group(root, "integers"), checkpoint.integers);
  return checkpoint;
}

}  // namespace colloid
