#include "scene/fields.h"

#include <fmt/format.h>

namespace colloid {

namespace {

// Ranges are wide: they stop typing errors and what the arithmetic cannot carry, not
// unusual physics.  [SI]
constexpr double kLargestLength = 100.0;
constexpr double kLargestVelocity = 100.0;

const char* const kOnlyThroat = "\"preset\": \"throat\"";
const char* const kOnlyBox = "a geometry without a preset";

Measure length() {
  return {"m", positive(kLargestLength)};
}
Measure position() {
  return {"m", magnitude(kLargestLength)};
}
Measure velocity() {
  return {"m/s", magnitude(kLargestVelocity)};
}
Measure zeta() {
  return {"V", magnitude(1.0)};
}
Measure minimum() {
  return {"J", between(-1e-12, 0.0)};
}

}  // namespace

Key required(Key key) {
  key.required = true;
  return key;
}

Key only_if(bool applies, const char* condition, Key key) {
  key.applies = applies;
  key.only_with = condition;
  return key;
}

std::string Range::text() const {
  return fmt::format("{}{:g}, {:g}]", above_low ? '(' : '[', low, high);
}

void declare(Fields& f, Sphere& sphere) {
  double diameter = 2.0 * sphere.radius;
  f.vector(required({"center", "position of the centre"}), position(), sphere.center);
  f.quantity(required({"diameter", "diameter"}), length(), diameter);
  sphere.radius = 0.5 * diameter;
}

void declare(Fields& f, Body& body) {
  declare(f, body.sphere);
  f.vector({"force", "external force on the body"}, {"N", magnitude(1e6)}, body.force);
  f.vector({"torque", "external torque about the centre"}, {"N m", magnitude(1e6)},
           body.torque);
  Key key{"velocity", "prescribed velocity; null: the body is free"};
  key.nullable = true;
  key.if_absent = "free";
  f.vector(key, velocity(), body.velocity);
}

void declare(Fields& f, Box& box) {
  for (int face = 0; face < kFaces; ++face) {
    f.choice({face_name(face), "condition on this face of the box"},
             box.faces[static_cast<std::size_t>(face)]);
  }
}

void declare(Fields& f, Geometry& g) {
  f.choice({"preset", "ready-made geometry: throat is the hole between four collectors"},
           g.preset);
  const bool throat = g.preset == Preset::throat;
  f.quantity(only_if(throat, kOnlyThroat,
                     {"collector_diameter",
                      "diameter of the four collectors and width of the box"}),
             length(), g.collector_diameter);
  Key height{"height",
             "height of the box; the outlet is the collectors' lower tangent "
             "plane"};
  height.if_absent = "1.5 collector diameters";
  f.quantity_or(only_if(throat, kOnlyThroat, height), "", length(), g.height);

  f.vector(only_if(!throat, kOnlyBox, required({"box", "edge lengths of the domain"})),
           length(), g.box.size);
  f.section(only_if(!throat, kOnlyBox, {"faces", "what holds on the six faces"}), g.box);
  f.list(only_if(!throat, kOnlyBox, {"spheres", "fixed grains"}), g.spheres);
  f.text(
      only_if(!throat, kOnlyBox,
              {"spheres_file",
               "CSV table of more fixed grains (x_m, y_m, z_m, diameter_m), relative to "
               "the scene file"}),
      g.spheres_file);
  f.list(
      {"bodies",
       "rigid balls that move: measured, or colloids that are there when a run begins"},
      g.bodies);
}

void declare(Fields& f, Fluid& fluid) {
  f.quantity({"temperature", "temperature; it gives kT its size everywhere in the scene"},
             {"K", between(1.0, 1000.0)}, fluid.temperature);
  f.temperature(fluid.temperature);
  f.quantity({"viscosity", "dynamic viscosity"}, {"Pa s", positive(1e6)},
             fluid.viscosity);
  f.quantity({"density", "density"}, {"kg/m^3", positive(1e5)}, fluid.density);
  f.number({"relative_permittivity", "relative permittivity"}, between(1.0, 1000.0),
           fluid.relative_permittivity);
}

void declare(Fields& f, Drive& drive) {
  f.exactly_one(
      {"inlet_velocity", "pressure_drop", "body_force", "mean_velocity", "shear_rate"});
  f.quantity_or({"inlet_velocity", "uniform velocity through the inlet, into the box"},
                "", {"m/s", positive(kLargestVelocity)}, drive.inlet_velocity);
  f.quantity_or({"pressure_drop", "pressure at the inlet minus that at the outlet"}, "",
                {"Pa", positive(1e12)}, drive.pressure_drop);
  f.vector({"body_force", "force on the fluid per volume"}, {"N/m^3", magnitude(1e12)},
           drive.body_force);
  f.vector({"mean_velocity", "superficial velocity that is held, along periodic axes"},
           velocity(), drive.mean_velocity);
  f.quantity_or(
      {"shear_rate", "wall z+ moves along x at this rate times the box's height"}, "",
      {"1/s", magnitude(1e9)}, drive.shear_rate);
}

void declare(Fields& f, Injection& injection) {
  f.choice(
      {"release_velocity",
       "velocity of a colloid that enters: the fluid's at its place, or the inlet's"},
      injection.release_velocity);
  f.choice({"sequence", "law of the injections in injected volume"}, injection.sequence);
}

void declare(Fields& f, Colloids& colloids) {
  f.quantity(required({"diameter", "diameter"}), {"m", positive(1.0)}, colloids.diameter);
  f.quantity({"density", "density"}, {"kg/m^3", positive(1e5)}, colloids.density);
  f.number({"volume_fraction", "volume of colloids per volume of injected suspension"},
           between(0.0, 0.5), colloids.volume_fraction);
  f.quantity({"young_modulus", "Young's modulus"}, {"Pa", positive(1e13)},
             colloids.young_modulus);
  f.number({"poisson_ratio", "Poisson's ratio"}, between(0.0, 0.5),
           colloids.poisson_ratio);
  f.number({"restitution", "coefficient of normal restitution, dry"}, positive(1.0),
           colloids.restitution);
  f.number({"friction", "Coulomb's friction coefficient of all contacts"},
           between(0.0, 10.0), colloids.friction);
  f.section({"injection", "how colloids enter"}, colloids.injection);
}

void declare(Fields& f, Grains& grains) {
  f.quantity({"young_modulus", "Young's modulus"}, {"Pa", positive(1e13)},
             grains.young_modulus);
  f.number({"poisson_ratio", "Poisson's ratio"}, between(0.0, 0.5), grains.poisson_ratio);
}

void declare(Fields& f, SurfaceChemistry& s) {
  f.quantity({"ionic_strength", "of a 1:1 electrolyte"}, {"mol/m^3", positive(2e4)},
             s.ionic_strength);
  f.quantity({"zeta_colloid", "zeta potential of the colloids"}, zeta(), s.zeta_colloid);
  f.quantity_per_pair(
      {"zeta_grain",
       "zeta potential of what a colloid meets: the grains, the side walls"},
      zeta(), {{"colloid_grain", &s.zeta_grain}, {"colloid_wall", &s.zeta_wall}});
  f.quantity_per_pair({"hamaker", "Hamaker constant across the liquid"},
                      {"J", between(0.0, 1e-16)},
                      {{"colloid_grain", &s.hamaker_colloid_grain},
                       {"colloid_wall", &s.hamaker_colloid_wall},
                       {"colloid_colloid", &s.hamaker_colloid_colloid}});
  f.quantity({"born_diameter", "collision parameter of the Born repulsion"},
             {"m", positive(1e-7)}, s.born_diameter);
  f.quantity_or({"primary_minimum", "energy of a colloid attached to a grain"},
                "computed", minimum(), s.primary_minimum);
  f.quantity_or({"colloid_colloid_minimum", "energy of two attached colloids"},
                "computed", minimum(), s.colloid_colloid_minimum);
  f.choice({"double_layer", "form of the double-layer interaction of two colloids"},
           s.double_layer);
  f.choice({"van_der_waals", "with retardation (Gregory) or without"}, s.van_der_waals);
}

void declare(Fields& f, Fidelity& fidelity) {
  f.choice({"tier", "solver; auto takes the cheapest that is valid for the scene"},
           fidelity.tier);
  f.number({"cells_per_colloid", "grid cells per colloid diameter"}, between(1.0, 200.0),
           fidelity.cells_per_colloid);
  f.choice({"hindrance", "surfaces that slow a mobile colloid down"}, fidelity.hindrance);
  f.quantity_or({"capture_gap", "gap at which a colloid is caught"}, "computed",
                {"m", positive(1e-3)}, fidelity.capture_gap);
  f.number({"tolerance",
            "residual, relative to the drive or the pressure, at which the flow has "
            "converged"},
           between(1e-14, 0.1), fidelity.tolerance);
  f.choice({"lubrication", "correction of gaps below the grid's resolution"},
           fidelity.lubrication);
  f.number({"courant", "largest Courant number (tier transient)"}, positive(1.0),
           fidelity.courant);
  f.choice({"coupling", "of fluid and colloids (tier transient)"}, fidelity.coupling);
  f.integer({"refinement", "times the cell is halved at colloids (tier transient)"},
            between(0.0, 6.0), fidelity.refinement);
  f.integer({"subiterations",
             "passes of momentum and pressure in a flow step (tier transient)"},
            between(1.0, 20.0), fidelity.subiterations);
  f.integer({"wall_refinement",
             "times the cell is halved at surfaces of grains (tier transient)"},
            between(0.0, 1.0), fidelity.wall_refinement);
  f.quantity({"dem_step", "step of the colloids' motion and contacts (tier transient)"},
             {"s", positive(1e-3)}, fidelity.dem_step);
}

void declare(Fields& f, Scene& scene) {
  f.text({"description", "a remark; it changes nothing"}, scene.description);
  f.temperature(scene.fluid.temperature);  // the default, if there is no section
  f.section({"fluid", "the carrier fluid"}, scene.fluid);
  f.section(required({"geometry", "the domain and the grains in it"}), scene.geometry);
  f.section({"drive", "what moves the fluid; left out if only bodies do"}, scene.drive,
            scene.drive.given());
  f.section({"colloids", "what is injected; left out if only flow is measured"},
            scene.colloids);
  f.section({"grains", "mechanics of grains and walls"}, scene.grains);
  f.section({"surface", "interaction of surfaces (DLVO)"}, scene.surface);
  f.vector({"gravity", "acceleration of gravity"}, {"m/s^2", magnitude(1e6)},
           scene.gravity);
  f.choice({"walls", "whether a colloid that touches a side wall stays there"},
           scene.walls);
  f.choice({"bonds", "whether a bond may break"}, scene.bonds);
  f.flag({"aggregates", "mobile colloids that touch bond and move as one"},
         scene.aggregates);
  f.quantity({"duration", "simulated time"}, {"s", positive(1e7)}, scene.duration);
  f.choice({"stop_when", "end at the duration, or already when clogged"},
           scene.stop_when);
  f.section({"fidelity", "how accurately, and by which tier"}, scene.fidelity);
}

}  // namespace colloid
