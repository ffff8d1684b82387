#include "io/result_file.h"

#include <utility>
#include <vector>

#include "io/columns.h"
#include "io/content_hash.h"
#include "io/hdf5.h"
#include "io/realisation_hdf5.h"

namespace colloid {

namespace {

// Of the H5MD specification (nongnu.org/h5md) and of its units module.
const std::vector<std::int64_t> kH5mdVersion{1, 1};
const std::vector<std::int64_t> kUnitsVersion{1, 0};

void write_h5md(const H5Handle& root, const Provenance& provenance) {
  const H5Handle h5md = create_group(root, "h5md");
  put_attribute(h5md, "version", kH5mdVersion);
  put_attribute(create_group(h5md, "author"), "name", provenance.user);
  const H5Handle creator = create_group(h5md, "creator");
  put_attribute(creator, "name", std::string("poreclog"));
  put_attribute(creator, "version", provenance.version);
  const H5Handle units = create_group(h5md, "modules/units");
  put_attribute(units, "version", kUnitsVersion);
  put_attribute(units, "system", std::string("SI"));
}

void write_provenance(const H5Handle& root, const Provenance& provenance,
                      const Scene& scene) {
  const H5Handle group = create_group(root, "provenance");
  put_attribute(group, "version", provenance.version);
  put_attribute(group, "commit", provenance.commit);
  put_attribute(group, "compiler", provenance.compiler);
  put_attribute(group, "compiler_flags", provenance.compiler_flags);
  put_attribute(group, "hdf5_version", provenance.hdf5_version);
  put_attribute(group, "user", provenance.user);
  put_attribute(group, "hostname", provenance.hostname);
  put_attribute(group, "cpu_model", provenance.cpu_model);
  put_attribute(group, "cores", std::int64_t{provenance.cores});
  put_attribute(group, "command_line", provenance.command_line);
  put_attribute(group, "start_time", provenance.start_time);
  put_attribute(group, "scene_hash", scene_hash(scene));
  put_text(group, "scene", {"1", "the scene as JSON, every default spelled out"},
           scene_text(scene));
}

/// The H5MD box of a particles group: the domain, from the origin.
void write_box(const H5Handle& particles, const Box& box) {
  const H5Handle group = create_group(particles, "box");
  std::vector<std::string> boundary;
  boundary.reserve(3);
  for (int axis = 0; axis < 3; ++axis) {
    boundary.emplace_back(box.periodic(axis) ? "periodic" : "none");
  }
  put_attribute(group, "dimension", std::int64_t{3});
  put_attribute(group, "boundary", boundary);
  put_array(group, "edges", {"m", "edge lengths of the domain; it begins at the origin"},
            Shape{3}, std::vector<double>{box.size.x, box.size.y, box.size.z});
}

/// The fixed grains: an H5MD particles group that does not change in time.
void write_grains(const H5Handle& root, const Geometry& geometry) {
  const H5Handle grains = create_group(root, "particles/grains");
  write_box(grains, geometry.box);
  std::vector<Vec3> centers;
  std::vector<double> diameters;
  centers.reserve(geometry.spheres.size());
  diameters.reserve(geometry.spheres.size());
  for (const Sphere& sphere : geometry.spheres) {
    centers.push_back(sphere.center);
    diameters.push_back(2.0 * sphere.radius);
  }
  put_column(grains, "position", {"m", "centres of the grains"}, centers);
  put_column(grains, "diameter", {"m", "of the grains"}, diameters);
}

}  // namespace

ResultFile::ResultFile(const std::string& path, Provenance provenance, Scene scene)
    : provenance_(std::move(provenance)), scene_(std::move(scene)), file_(path) {
  file_.write(image(nullptr));
}

void ResultFile::finish(const Realisation& realisation) {
  file_.write(image(&realisation));
  file_.commit();
}

std::string ResultFile::image(const Realisation* realisation) const {
  const H5Handle root = create_image();
  put_attribute(root, "schema_version", std::int64_t{kSchemaVersion});
  write_provenance(root, provenance_, scene_);
  if (realisation != nullptr) {
    write_h5md(root, provenance_);
    put_attribute(root, "seed", std::to_string(realisation->seed));
    write_realisation(root, *realisation);
    write_box(open_group(root, "particles/colloids"), scene_.geometry.box);
    write_grains(root, scene_.geometry);
  }
  put_attribute(root, "complete", std::int64_t{realisation != nullptr ? 1 : 0});
  return image_bytes(root);
}

}  // namespace colloid
