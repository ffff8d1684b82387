#include "io/realisation_hdf5.h"

#include <algorithm>

#include "io/columns.h"
#include "io/layout.h"

namespace colloid {

namespace {

/// The frames as arrays of equal rows, [frame][colloid]: as many places in each as the
/// fullest frame needs; free places come last and have id -1 (as H5MD suggests).
struct Trajectories {
  std::vector<std::int64_t> step;
  std::vector<double> time;      ///< [s]
  std::vector<double> position;  ///< [frame][colloid][3], m
  std::vector<double> velocity;  ///< [frame][colloid][3], m/s
  std::vector<std::int64_t> id;
  std::vector<double> diameter;  ///< [m]
  std::vector<std::int8_t> state;
};

constexpr std::int64_t kFreePlace = -1;

std::size_t places(const std::vector<Frame>& frames) {
  std::size_t count = 0;
  for (const Frame& frame : frames) {
    count = std::max(count, frame.colloids.size());
  }
  return count;
}

Trajectories to_arrays(const std::vector<Frame>& frames) {
  const std::size_t width = places(frames);
  const std::size_t count = width * frames.size();
  Trajectories arrays{{},
                      {},
                      std::vector<double>(3 * count, kNotYet),
                      std::vector<double>(3 * count, kNotYet),
                      std::vector<std::int64_t>(count, kFreePlace),
                      std::vector<double>(count, kNotYet),
                      std::vector<std::int8_t>(count, 0)};
  static_assert(static_cast<int>(ColloidState::absent) == 0);
  arrays.step.reserve(frames.size());
  arrays.time.reserve(frames.size());
  for (const Frame& frame : frames) {
    std::size_t place = width * arrays.step.size();
    for (const ColloidRecord& colloid : frame.colloids) {
      for (int axis = 0; axis < 3; ++axis) {
        const std::size_t at = 3 * place + static_cast<std::size_t>(axis);
        arrays.position[at] = colloid.position[axis];
        arrays.velocity[at] = colloid.velocity[axis];
      }
      arrays.id[place] = colloid.id;
      arrays.diameter[place] = colloid.diameter;
      arrays.state[place] = static_cast<std::int8_t>(colloid.state);
      ++place;
    }
    arrays.step.push_back(frame.step);
    arrays.time.push_back(frame.time);
  }
  return arrays;
}

std::vector<Frame> to_frames(const Trajectories& arrays) {
  std::vector<Frame> frames(arrays.step.size());
  const std::size_t width = frames.empty() ? 0 : arrays.id.size() / frames.size();
  for (std::size_t f = 0; f < frames.size(); ++f) {
    frames[f].step = arrays.step[f];
    frames[f].time = arrays.time[f];
    for (std::size_t i = f * width; i < (f + 1) * width && arrays.id[i] >= 0; ++i) {
      const double* x = &arrays.position[3 * i];
      const double* u = &arrays.velocity[3 * i];
      frames[f].colloids.push_back({static_cast<int>(arrays.id[i]),
                                    {x[0], x[1], x[2]},
                                    {u[0], u[1], u[2]},
                                    static_cast<ColloidState>(arrays.state[i]),
                                    arrays.diameter[i]});
    }
  }
  return frames;
}

/// The H5MD elements position, velocity, id, diameter and state; one step and one time
/// for all of them.
void write_frames(const H5Handle& colloids, const std::vector<Frame>& frames) {
  const Trajectories arrays = to_arrays(frames);
  const Shape shape{frames.size(), places(frames)};
  const Shape vectors{shape[0], shape[1], 3};
  const H5Handle position = create_group(colloids, "position");
  put_array(position, "value", {"m", "centres; NaN where the place is free"}, vectors,
            arrays.position);
  put_array(position, "step", {"1", "time step of the frame"}, {shape[0]}, arrays.step);
  put_array(position, "time", {"s", "instant of the frame"}, {shape[0]}, arrays.time);

  const H5Handle velocity = create_group(colloids, "velocity");
  put_array(velocity, "value", {"m s-1", "of the centres; NaN where the place is free"},
            vectors, arrays.velocity);
  const H5Handle id = create_group(colloids, "id");
  put_array(id, "value", {"1", "who is at this place of the row; -1: nobody"}, shape,
            arrays.id);
  const H5Handle diameter = create_group(colloids, "diameter");
  put_array(diameter, "value", {"m", "of the colloid; NaN where the place is free"},
            shape, arrays.diameter);
  const H5Handle state = create_group(colloids, "state");
  put_words(state, "value", {"1", "what the colloid does"}, shape, arrays.state,
            words_of<ColloidState>());
  for (const H5Handle* element : {&velocity, &id, &diameter, &state}) {
    link_dataset(position, *element, "step");
    link_dataset(position, *element, "time");
  }
}

std::vector<Frame> read_frames(const H5Handle& colloids) {
  Trajectories arrays;
  const H5Handle position = open_group(colloids, "position");
  get_array(position, "value", arrays.position);
  get_array(position, "step", arrays.step);
  get_array(position, "time", arrays.time);
  get_array(open_group(colloids, "velocity"), "value", arrays.velocity);
  get_array(open_group(colloids, "id"), "value", arrays.id);
  get_array(open_group(colloids, "diameter"), "value", arrays.diameter);
  get_array(open_group(colloids, "state"), "value", arrays.state);
  return to_frames(arrays);
}

void write_numbers(const H5Handle& group, const NamedNumbers& numbers) {
  for (const auto& [name, value] : numbers) {
    put_attribute(group, name, value);
  }
}

}  // namespace

void write_realisation(const H5Handle& root, const Realisation& realisation) {
  AttributeWriter outcome(root);
  declare_outcome(outcome, realisation);
  write_frames(create_group(root, "particles/colloids"), realisation.frames);

  const H5Handle series_group = create_group(root, "series");
  ColumnWriter<SeriesRow> series(series_group, realisation.series);
  declare_series(series);
  const H5Handle retained_group = create_group(root, "retained");
  ColumnWriter<RetainedColloid> retained(retained_group, realisation.retained);
  declare_retained(retained);
  const H5Handle injection_group = create_group(root, "injections");
  ColumnWriter<InjectionRecord> injections(injection_group, realisation.injections);
  declare_injections(injections);

  write_numbers(create_group(root, "solver"), realisation.deterministic);
  write_numbers(create_group(root, "solver/cost"), realisation.cost);
}

Realisation read_realisation(const H5Handle& root) {
  Realisation realisation;
  AttributeReader outcome(root);
  declare_outcome(outcome, realisation);
  realisation.frames = read_frames(open_group(root, "particles/colloids"));

  const H5Handle series_group = open_group(root, "series");
  ColumnReader<SeriesRow> series(series_group, realisation.series);
  declare_series(series);
  const H5Handle retained_group = open_group(root, "retained");
  ColumnReader<RetainedColloid> retained(retained_group, realisation.retained);
  declare_retained(retained);
  const H5Handle injection_group = open_group(root, "injections");
  ColumnReader<InjectionRecord> injections(injection_group, realisation.injections);
  declare_injections(injections);

  realisation.deterministic = get_numbers(open_group(root, "solver"));
  realisation.cost = get_numbers(open_group(root, "solver/cost"));
  return realisation;
}

}  // namespace colloid
