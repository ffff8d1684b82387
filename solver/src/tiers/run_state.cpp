#include "tiers/run_state.h"

namespace colloid {

namespace {

using Reals = std::vector<double>;
using Integers = std::vector<std::int64_t>;

// Writing and reading go through the same list of fields, in the same order.
class Packer {
 public:
  Packer(Reals& reals, Integers& integers) : reals_(reals), integers_(integers) {}

  void operator()(const double& x) { reals_.push_back(x); }
  void operator()(const int& n) { integers_.push_back(n); }
  void operator()(const long& n) { integers_.push_back(n); }
  void operator()(const Vec3& v) {
    (*this)(v.x);
    (*this)(v.y);
    (*this)(v.z);
  }
  template <class T, class Each>
  void list(const std::vector<T>& items, Each each) {
    integers_.push_back(static_cast<std::int64_t>(items.size()));
    for (const T& item : items) {
      each(*this, item);
    }
  }

 private:
  Reals& reals_;
  Integers& integers_;
};

class Unpacker {
 public:
  Unpacker(const Reals& reals, const Integers& integers)
      : reals_(reals), integers_(integers) {}

  void operator()(double& x) { x = reals_.at(real_++); }
  void operator()(int& n) { n = static_cast<int>(integers_.at(integer_++)); }
  void operator()(long& n) { n = static_cast<long>(integers_.at(integer_++)); }
  void operator()(Vec3& v) {
    (*this)(v.x);
    (*this)(v.y);
    (*this)(v.z);
  }
  template <class T, class Each>
  void list(std::vector<T>& items, Each each) {
    items.resize(static_cast<std::size_t>(integers_.at(integer_++)));
    for (T& item : items) {
      each(*this, item);
    }
  }

 private:
  const Reals& reals_;
  const Integers& integers_;
  std::size_t real_ = 0;
  std::size_t integer_ = 0;
};

template <class Visitor, class T>
void visit_value(Visitor& visit, T& item) {
  visit(item);
}

template <class Visitor, class SurfaceIdLike>
void visit_surface(Visitor& visit, SurfaceIdLike& id) {
  int kind = static_cast<int>(id.kind);
  visit(kind);
  if constexpr (!std::is_const_v<SurfaceIdLike>) {
    id.kind = static_cast<SurfaceId::Kind>(kind);
  }
  visit(id.index);
}

template <class Visitor, class BodyLike>
void visit_body(Visitor& visit, BodyLike& body) {
  visit.list(body.members, [](auto& v, auto& m) {
    v(m.id);
    v(m.injection_time);
    v(m.injection_position);
    v(m.contact_time);
    v(m.expected_escapes);
  });
  visit.list(body.arms, [](auto& v, auto& arm) { v(arm); });
  visit.list(body.bonds, [](auto& v, auto& bond) {
    v(bond.member);
    visit_surface(v, bond.fixed);
    v(bond.anchor);
    v(bond.distance);
  });
  visit(body.centre);
  visit(body.velocity);
  visit(body.spin);
  visit(body.slow_since);
  visit(body.slow_at);
}

template <class Visitor, class State>
void visit_state(Visitor& visit, State& s) {
  visit(s.time);
  visit(s.volume);
  visit(s.next_injection);
  visit.list(s.delayed, [](auto& v, auto& index) { visit_value(v, index); });
  visit(s.times_delayed);
  visit(s.next_output);
  visit(s.thermal_steps);
  visit.list(s.bodies, [](auto& v, auto& body) { visit_body(v, body); });
  visit.list(s.deposit, [](auto& v, auto& batch) {
    v.list(batch.ids, [](auto& w, auto& id) { visit_value(w, id); });
    v.list(batch.spheres, [](auto& w, auto& sphere) {
      w(sphere.center);
      w(sphere.radius);
    });
  });
  visit(s.bonds_broken);
  visit(s.next_step);
  visit(s.counts.steps);
  visit(s.counts.rejected);
  visit(s.counts.located);
  visit(s.counts.evaluations);
  visit(s.counts.overlaps);
  visit(s.counts.deepest_overlap);
}

constexpr const char* kName = "run_state";

}  // namespace

void pack(const RunState& state, std::map<std::string, Reals>& reals,
          std::map<std::string, Integers>& integers) {
  Packer packer(reals[kName], integers[kName]);
  visit_state(packer, state);
}

void unpack(const std::map<std::string, Reals>& reals,
            const std::map<std::string, Integers>& integers, RunState& state) {
  Unpacker unpacker(reals.at(kName), integers.at(kName));
  visit_state(unpacker, state);
}

}  // namespace colloid
