// Names, units and meanings of what a realisation is stored as: each declared once, for
// writing and reading.  schemas/result.md documents them; a contract test compares.
#pragma once

#include "io/realisation.h"

namespace colloid {

/// Attributes of the root.  R: Realisation, const to write.
template <class Archive, class R>
void declare_outcome(Archive& archive, R& realisation) {
  archive.value("tier", realisation.tier);
  archive.value("tier_reason", realisation.tier_reason);
  archive.value("ending", realisation.ending);
  archive.value("seed_uint64", realisation.seed);
  archive.value("duration_s", realisation.duration);
  archive.value("t1_s", realisation.t1);
  archive.value("tc_s", realisation.tc);
  archive.value("alpha_deg", realisation.alpha_deg);
  archive.value("last_traversal_s", realisation.last_traversal);
  archive.value("blocked_since_s", realisation.blocked_since);
  archive.value("injected", realisation.counts.injected);
  archive.value("delayed", realisation.counts.delayed);
  archive.value("mobile", realisation.counts.mobile);
  archive.value("bonded", realisation.counts.bonded);
  archive.value("retained", realisation.counts.retained);
  archive.value("traversed", realisation.counts.traversed);
}

template <class Table>
void declare_series(Table& table) {
  using Row = SeriesRow;
  table.column("time_s", "s", "instant of the row", &Row::time);
  table.column("critical_diameter_m", "m", "largest sphere that can pass the throat",
               &Row::critical_diameter);
  table.column("permeability_m2", "m+2", "Darcy permeability", &Row::permeability);
  table.column("permeability_ratio", "1", "permeability over that of the clean throat",
               &Row::permeability_ratio);
  table.column("injected", "1", "colloids whose turn to enter has come", &Row::injected);
  table.column("delayed", "1", "colloids waiting for a free place to enter",
               &Row::delayed);
  table.column("mobile", "1", "colloids that move", &Row::mobile);
  table.column("bonded", "1", "of the mobile ones: attached to other colloids",
               &Row::bonded);
  table.column("retained", "1", "colloids of the deposit", &Row::retained);
  table.column("first_layer", "1", "retained on a grain", &Row::first_layer);
  table.column("multilayer", "1", "retained on the deposit", &Row::multilayer);
  table.column("wall_layer", "1", "retained on a side wall", &Row::wall_layer);
  table.column("traversed", "1", "colloids that have left through the outlet",
               &Row::traversed);
}

template <class Table>
void declare_retained(Table& table) {
  using Row = RetainedColloid;
  table.column("order", "1", "order of retention, from 1", &Row::order);
  table.column("colloid", "1", "id of the colloid", &Row::colloid);
  table.column("time_s", "s", "when it came to rest", &Row::time);
  table.column("contact_time_s", "s", "when it first touched what holds it",
               &Row::contact_time);
  table.column("position_m", "m", "where its centre rests", &Row::position);
  table.column("layer", "1",
               "on what it sits: first (a grain), multilayer (the deposit) or wall",
               &Row::layer);
  table.column("mechanism", "1",
               "what holds it: attachment_to_grain, attachment_to_deposit, "
               "attachment_to_wall or straining",
               &Row::mechanism);
  table.column("injection_position_m", "m", "where its centre entered",
               &Row::injection_position);
  table.column("injection_time_s", "s", "when it entered", &Row::injection_time);
  table.column("alpha_deg", "deg", "angle of deposition; NaN where undefined",
               &Row::alpha_deg);
  table.column("partners", "1", "what it touches, separated by a comma and a space",
               &Row::partners);
  table.column("bond_load_N", "N", "largest pull on a bond", &Row::bond_load);
  table.column("bond_overloaded", "1", "whether that is more than the bond could hold",
               &Row::bond_overloaded);
}

template <class Table>
void declare_injections(Table& table) {
  using Row = InjectionRecord;
  table.column("index", "1", "place in the injection sequence, from 0", &Row::index);
  table.column("volume_m3", "m+3", "suspension injected before it", &Row::volume);
  table.column("time_s", "s", "when it entered; NaN: it did not", &Row::time);
  table.column("position_m", "m", "where its centre entered", &Row::position);
}

}  // namespace colloid
