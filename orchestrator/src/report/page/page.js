// Builds the report from its content.  Every text of the campaign is set as text, never
// as HTML.
"use strict";

const content = JSON.parse(document.getElementById("content").textContent);
const errors = [];
const report = document.getElementById("report");
let figureCount = 0;

function noteError(error) {
  errors.push(String(error && error.stack || error));
  document.documentElement.dataset.errors = JSON.stringify(errors);
}
window.addEventListener("error", e => noteError(e.error ?? e.message));

// --- Text ---------------------------------------------------------------------------

/// h("p.lead", {title: ""}, "text", node): an element; strings become text.
function h(name, attributes, ...children) {
  const [tag, ...classes] = name.split(".");
  const node = document.createElement(tag);
  if (classes.length) node.className = classes.join(" ");
  for (const [key, value] of Object.entries(attributes ?? {})) {
    if (value != null) node.setAttribute(key, value);
  }
  node.append(...children.flat().filter(c => c != null));
  return node;
}

/// Our own words with symbols: "mean t_c" sets t in italics with a subscript.
function rich(text) {
  const parts = text.split(/(\b[tlkn]_[a-z0-9]+\b|\bS\(t\)|\bR²)/);
  return parts.map((part, i) => {
    if (i % 2 === 0) return part;
    const [symbol, index] = part.split("_");
    return index ? h("span", {}, h("i", {}, symbol), h("sub", {}, index)) : h("i", {}, part);
  });
}

function general(value, digits = 3) {
  if (value == null) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size < 1e-3 || size >= 1e5) {
    const [mantissa, power] = value.toExponential(digits - 1).split("e");
    return `${mantissa} × 10${[...String(Number(power))].map(c => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["-0123456789".indexOf(c)]).join("")}`;
  }
  return minus(String(Number(value.toPrecision(digits))));
}

const minus = text => text.replaceAll("-", "\u2212");

/// Decimals that an interval's half-width calls for: two significant digits of it.
function decimals(low, high, value) {
  const width = low != null && high != null ? (high - low) / 2
    : low != null ? Math.abs(value - low) : high != null ? Math.abs(high - value) : 0;
  if (!(width > 0)) return null;
  return Math.max(0, Math.min(8, 1 - Math.floor(Math.log10(width))));
}

/// ["1.24", "1.10 to 1.37"]
function withInterval(value, low, high) {
  if (value == null) return ["–", ""];
  const n = decimals(low, high, value);
  if (n == null) return [general(value), ""];
  const limit = v => v == null ? "open" : minus(v.toFixed(n));
  return [minus(value.toFixed(n)), `${limit(low)} to ${limit(high)}`];
}

const percent = level => `${Number((100 * level).toPrecision(4))} %`;

const kUnits = {
  "m": [[1e-9, "nm"], [1e-6, "µm"], [1e-3, "mm"], [1, "m"]],
  "s": [[1e-3, "ms"], [1, "s"]],
  "m/s": [[1e-6, "µm/s"], [1e-3, "mm/s"], [1, "m/s"]],
  "V": [[1e-3, "mV"], [1, "V"]],
  "Pa s": [[1e-3, "mPa s"], [1, "Pa s"]],
  "Pa": [[1, "Pa"], [1e3, "kPa"], [1e6, "MPa"], [1e9, "GPa"]],
  "mol/m^3": [[1, "mM"]],
};

/// "1.33e-05 m" -> {number: 13.3, unit: "µm"}; none if it is no quantity.
function quantity(text, like) {
  const match = typeof text === "string" && text.match(/^(-?[\d.]+(?:e[-+]?\d+)?) ?(.*)$/);
  if (!match) return typeof text === "number" ? {number: text, unit: ""} : null;
  const value = Number(match[1]);
  const choices = kUnits[match[2]];
  if (!choices) return {number: value, unit: match[2]};
  const size = Math.abs(like ?? value);
  const [factor, unit] = [...choices].reverse()
    .find(([f]) => size >= f * 0.999) ?? (size === 0 ? choices[choices.length - 1] : choices[0]);
  return {number: Number((value / factor).toPrecision(12)), unit};
}

function pretty(value) {
  if (Array.isArray(value)) {
    const all = value.map(v => typeof v === "object" ? JSON.stringify(v) : pretty(v));
    return `(${all.join(", ")})`;
  }
  const q = quantity(value);
  if (!q) return String(value);
  const number = general(q.number, 6);
  return q.unit ? `${number} ${q.unit.replace("^3", "³").replace("^2", "²")}` : number;
}

function table(columns, body) {
  const kind = c => c.words ? "words" : null;
  return h("div.scroll", {}, h("table", {},
    h("thead", {}, h("tr", {}, columns.map(c => h("th", {class: kind(c)}, rich(c.name))))),
    h("tbody", {}, body.map(row => h("tr", {}, row.map((cell, i) =>
      h("td", {class: kind(columns[i])}, cell ?? "–")))))));
}

function warnings(list) {
  return list.length ? h("div.warnings", {}, list.map(w => h("p", {}, w))) : null;
}

// --- Figures ------------------------------------------------------------------------

function saveSvg(figure, name) {
  figure.querySelectorAll(".panels svg:not(.legend svg)").forEach((svg, i, all) => {
    const copy = svg.cloneNode(true);
    copy.setAttribute("xmlns", "http://www.w3.org/2000/svg");
    const url = URL.createObjectURL(new Blob([copy.outerHTML], {type: "image/svg+xml"}));
    h("a", {href: url, download: `${name}${all.length > 1 ? "-" + (i + 1) : ""}.svg`}).click();
    setTimeout(() => URL.revokeObjectURL(url), 1000);
  });
}

/// A numbered figure.  `draw` returns panels, or a text that says why there is nothing.
function figure(id, title, caption, draw, options = {}) {
  const number = ++figureCount;
  const panels = h("div.panels", {style: `--columns: ${options.columns ?? 1}`});
  const node = h("figure", {id, "data-figure": id, "data-state": "failed"});
  try {
    const drawn = draw();
    if (typeof drawn === "string") {
      panels.append(h("div.none", {}, drawn));
      node.dataset.state = "empty";
    } else {
      panels.append(...drawn);
      node.dataset.state = "drawn";
    }
  } catch (error) {
    noteError(error);
    panels.append(h("div.none", {}, "This figure could not be drawn."));
  }
  const save = h("a", {href: "#" + id}, "save as SVG");
  save.addEventListener("click", e => { e.preventDefault(); saveSvg(node, id); });
  node.append(...(options.legend ? [legend(options.legend)] : []), panels,
              h("figcaption", {}, h("b", {}, `Figure ${number}. `, rich(title)), " ",
                rich(caption), node.dataset.state === "drawn" ? save : null));
  return node;
}

const titled = (title, node) => h("div", {}, h("div.panel-title", {}, rich(title)), node);

// --- What was varied ----------------------------------------------------------------

const variedKeys = [...new Set(content.points.flatMap(p =>
  Object.keys(p.statistics.varied ?? {})))];
const keyName = pointer => pointer.replace(/^\//, "").replaceAll("/", " ").replaceAll("_", " ");
const label = p => {
  const words = variedKeys.filter(k => k in p.statistics.varied)
    .map(k => `${keyName(k)} ${pretty(p.statistics.varied[k])}`);
  const tiers = new Set(content.points.map(q => q.statistics.tier));
  if (tiers.size > 1 || !words.length) words.push(p.statistics.tier);
  return words.join(", ");
};
const diameterOf = p => {
  const text = p.scene?.colloids?.diameter;
  return text == null ? null : Number.parseFloat(text) * kMicro;
};
const inletOf = p => {
  const g = p.scene?.geometry ?? {};
  if (g.preset === "throat") return [g.collector_diameter, g.collector_diameter].map(parseFloat);
  return g.box ? g.box.slice(0, 2).map(parseFloat) : null;
};
for (const p of content.points) {
  p.finished = p.statistics.n;
}

// --- Sections -----------------------------------------------------------------------

function headlineCards(s) {
  const c = s.clogging;
  const tau = c.restricted_mean_tau_s;
  const tauText = tau == null ? "" : `${general(tau)} s`;
  const items = [
    ["mean time of first retention, t_1", s.t1.mean, s.t1.ci_low, s.t1.ci_high, "s",
     s.t1.mean == null ? s.t1.note : s.t1.method],
    ["mean clogging time, t_c", s.tc.mean, s.tc.ci_low, s.tc.ci_high, "s",
     s.tc.mean == null ? s.tc.note : s.tc.method],
    ["median clogging time", c.median_s, c.median_ci?.[0], c.median_ci?.[1], "s",
     c.median_s == null ? "not reached; " + c.median_method : c.median_method],
    [`clogged by ${tauText}`, c.probability_by_end, c.probability_ci?.[0],
     c.probability_ci?.[1], "", c.probability_method],
    [`mean of t_c, counted up to ${tauText}`, c.restricted_mean_s, c.restricted_mean_ci?.[0],
     c.restricted_mean_ci?.[1], "s", c.restricted_mean_method],
    ["mean of t_c less t_1", s.tc_minus_t1.mean, s.tc_minus_t1.ci_low, s.tc_minus_t1.ci_high,
     "s", s.tc_minus_t1.mean == null ? s.tc_minus_t1.note : s.tc_minus_t1.method],
  ];
  return h("div.cards", {}, items.map(([name, value, low, high, unit, method]) => {
    const [number, interval] = withInterval(value, low, high);
    return h("div.card", {}, h("div.name", {}, rich(name)),
             h("div.value", {}, value == null ? "–" : `${number} ${unit}`),
             h("div.interval", {}, interval ? `${percent(s.confidence)}: ${interval}` : ""),
             h("div.method", {}, method ?? ""));
  }));
}

function countsLine(s) {
  const parts = [`${s.n} of ${s.n_asked} realisations`,
                 `${s.n - s.n_censored} clogged, ${s.n_censored} had not when they ended (censored)`];
  const line = h("p", {}, parts.join("; ") + (s.n_failed ? "; " : "."));
  if (s.n_failed) line.append(h("span.ink-failed", {}, `${s.n_failed} failed.`));
  if (s.target) line.append(h("span.target", {}, ` ${s.target.text[0].toUpperCase()}${s.target.text.slice(1)}.`));
  if (s.interim) line.append(h("b", {}, ` ${s.rule} (${s.n_running} running, ${s.n_pending} pending).`));
  return line;
}

function headlineTable() {
  const columns = [{name: "design point", words: true}, {name: "n"}, {name: "clogged"},
                   {name: "failed"}, {name: "mean t_1 (s)"}, {name: "mean t_c, restricted (s)"},
                   {name: "median t_c (s)"}, {name: "P(clogged by the end)"}];
  const cell = (value, low, high) => {
    const [number, interval] = withInterval(value, low, high);
    return interval ? `${number} (${interval})` : number;
  };
  return table(columns, content.points.map(p => {
    const s = p.statistics;
    const c = s.clogging;
    return [label(p), String(s.n), String(s.n - s.n_censored), String(s.n_failed),
            cell(s.t1.mean, s.t1.ci_low, s.t1.ci_high),
            cell(c.restricted_mean_s, c.restricted_mean_ci?.[0], c.restricted_mean_ci?.[1]),
            cell(c.median_s, c.median_ci?.[0], c.median_ci?.[1]),
            cell(c.probability_by_end, c.probability_ci?.[0], c.probability_ci?.[1])];
  }));
}

function pairedTable() {
  if (!content.paired_differences?.length) return null;
  const byNumber = new Map(content.points.map(p => [`${p.statistics.point} ${p.statistics.tier}`, p]));
  const of = (n, tier) => byNumber.has(`${n} ${tier}`) ? label(byNumber.get(`${n} ${tier}`)) : `point ${n}`;
  const cell = d => {
    if (!d || d.mean == null) return "–";
    const [number, interval] = withInterval(d.mean, d.ci_low, d.ci_high);
    return `${number} (${interval})`;
  };
  const spread = d => d?.sd == null || !d.sd_if_independent ? "–"
    : general(d.sd / d.sd_if_independent, 2);
  return h("section", {},
    h("h3", {}, "Differences, seed by seed"),
    h("p", {}, rich(`All design points draw from the same seeds: the same injections, unless what is varied changes them. So differences are taken realisation by realisation: mean (${percent(content.points[0].statistics.confidence)} interval by Student's t). The last column is the standard deviation of the differences of t_c over that of independent seeds: below 1 the pairing sharpens the answer.`)),
    table([{name: "design point", words: true}, {name: "less", words: true}, {name: "n"},
           {name: "change of mean t_1 (s)"}, {name: "change of restricted mean t_c (s)"},
           {name: "sd, paired / independent"}],
          content.paired_differences.map(d => [
            of(d.point, d.tier), of(d.from_point, d.tier),
            String(d.restricted_tc?.n ?? d.t1.n), cell(d.t1), cell(d.restricted_tc),
            spread(d.restricted_tc)])));
}

function flattened(value, path = "") {
  if (Array.isArray(value) && value.some(v => typeof v === "object")) {
    return [[path, `${value.length} given`]];
  }
  if (value && typeof value === "object" && !Array.isArray(value)) {
    return Object.entries(value).flatMap(([k, v]) => flattened(v, path ? `${path} ${k}` : k));
  }
  return [[path, pretty(value)]];
}

const kRegimeNames = [
  ["reynolds_throat", "Reynolds number of the throat"],
  ["reynolds_particle", "Reynolds number of a colloid"],
  ["stokes_largest", "Stokes number, largest"], ["peclet", "Péclet number"],
  ["gravity_number", "settling speed over inlet speed"],
  ["debye_length_m", "Debye length"], ["capture_gap_m", "capture gap"],
  ["energy_barrier_kT", "energy barrier (kT)"], ["primary_minimum_kT", "primary minimum (kT)"],
];

const kModelNames = {brownian: "Brownian motion", gravity: "gravity",
                     inertia: "inertia of the liquid and of colloids",
                     long_range_dlvo: "long-range DLVO forces", lubrication: "lubrication"};

function regimeSection(p) {
  const r = p.regime ?? {};
  if (!r.models) return h("p.meta", {}, `Regime: ${r.note ?? "not known"}.`);
  const numbers = kRegimeNames.filter(([k]) => r[k] != null).map(([k, name]) =>
    [name, k.endsWith("_m") ? pretty(`${Number(r[k]).toPrecision(3)} m`) : general(r[k])]);
  const models = Object.entries(r.models).map(([k, v]) =>
    [kModelNames[k] ?? k.replaceAll("_", " "), v ? "on" : "off", r.reasons?.[k] ?? ""]);
  return h("div", {},
    table([{name: "number", words: true}, {name: "value"}], numbers),
    table([{name: "model", words: true}, {name: "called for", words: true},
           {name: "because", words: true}], models));
}

function askedSection() {
  const first = content.points[0];
  const keep = new Set(variedKeys.map(k => k.slice(1).replaceAll("/", " ")));
  const scene = flattened(first.scene).filter(([k, v]) => v !== "" && !keep.has(k));
  const half = Math.ceil(scene.length / 2);
  const columns = [{name: "key of the scene", words: true}, {name: "value"}];
  const tiers = [...new Set(content.points.map(p => p.statistics.tier))];
  return h("section", {},
    h("h2", {}, "What was asked"),
    h("p", {}, `${content.realisations} realisations`
      + (content.points.length > 1 ? ` of each of ${content.points.length} ensembles (design points and tiers)` : "")
      + `, master seed ${content.master_seed}, tier ${tiers.join(", ")}.`
      + (content.points.length < 2 ? "" : content.independent_points
        ? " Design points have seeds of their own." : " All design points draw from the same seeds.")),
    variedKeys.length ? h("p", {}, "Varied: ", variedKeys.map((k, i) =>
      `${i ? "; " : ""}${keyName(k)} = ` + [...new Set(content.points.map(p =>
        pretty(p.statistics.varied[k])))].join(", ")).join(""), ".") : null,
    h("h3", {}, "Regime and models", variedKeys.length ? ` (${label(first)})` : ""),
    regimeSection(first),
    h("details", {}, h("summary", {}, "The whole scene, with every default"),
      h("div", {style: "display:flex;gap:2rem;flex-wrap:wrap"},
        table(columns, scene.slice(0, half)), table(columns, scene.slice(half)))));
}

// --- Comparison of design points ------------------------------------------------------

/// Which varied key is the axis, and which words tell the series apart.
function sweepAxis() {
  const distinct = k => new Set(content.points.map(p => JSON.stringify(p.statistics.varied[k]))).size;
  const key = [...variedKeys].sort((a, b) => distinct(b) - distinct(a))[0];
  if (!key) return null;
  const values = content.points.map(p => p.statistics.varied[key]);
  const raw = values.map(v => quantity(v));
  const numeric = raw.every(q => q) && new Set(raw.map(q => q.number + q.unit)).size > 1;
  const typical = numeric ? d3.median(values, v => Math.abs(Number.parseFloat(v))) : null;
  const shared = values.map(v => quantity(v, typical));
  const seriesOf = p => {
    const words = variedKeys.filter(k => k !== key).map(k =>
      `${keyName(k)} ${pretty(p.statistics.varied[k])}`);
    if (new Set(content.points.map(q => q.statistics.tier)).size > 1) words.push(p.statistics.tier);
    return words.join(", ");
  };
  return {key, numeric, unit: numeric ? shared[0].unit : "",
          x: numeric ? shared.map(q => q.number) : values.map(v => pretty(v)),
          series: content.points.map(seriesOf)};
}

function comparison() {
  if (content.points.length < 2) return [];
  const axis = sweepAxis();
  const names = axis ? [...new Set(axis.series)] : [];
  const seriesColour = name => kSeries[Math.max(0, names.indexOf(name)) % kSeries.length];
  const level = percent(content.points[0].statistics.confidence);
  const collect = get => content.points.map((p, i) => {
    const [v, low, high] = get(p.statistics);
    return {x: axis.x[i], series: axis.series[i], v, low, high};
  });
  const xLabel = axis ? keyName(axis.key) + (axis.unit ? ` (${axis.unit})` : "") : "";
  const panel = (title, yLabel, get, domain) => titled(title,
    sweepPanel(collect(get), xLabel, axis.numeric, yLabel, seriesColour, domain));
  const out = [];
  if (axis) {
    out.push(figure("sweep", "Headline numbers against what was varied.",
      `Dots: estimates of each design point; bars: ${level} intervals (Student's t for t_1; normal with Greenwood's variance for the restricted mean of t_c, where a realisation that did not clog counts as its duration; Clopper-Pearson or Kaplan-Meier for the probability).`,
      () => [
        panel("first retention", "mean t1 (s)", s => [s.t1.mean, s.t1.ci_low, s.t1.ci_high]),
        panel("clogging time, restricted mean", "mean of min(tc, duration) (s)",
              s => [s.clogging.restricted_mean_s, ...(s.clogging.restricted_mean_ci ?? [null, null])]),
        panel("clogged by the end", "probability",
              s => [s.clogging.probability_by_end, ...(s.clogging.probability_ci ?? [null, null])], [0, 1]),
      ],
      {columns: 3, legend: names.length > 1 ? names.map(n => [n, seriesColour(n), "dot"]) : null}));
  }
  const shown = content.points.slice(0, 8);
  const colour = i => kSeries[i % kSeries.length];
  const more = content.points.length > shown.length ? ` The first ${shown.length} of ${content.points.length} ensembles.` : "";
  out.push(figure("comparison", "Survival and mean critical diameter of the design points.",
    `Left: fraction not clogged, S(t), Kaplan-Meier with pointwise log-log ${level} intervals. Right: mean critical diameter with pointwise ${level} t-intervals.${more}`,
    () => {
      const survival = shown.map((p, i) => {
        const km = p.statistics.clogging.kaplan_meier;
        return {colour: colour(i), d: rows(km.time_s.length, k => ({
          t: km.time_s[k], v: km.survival[k], low: km.ci_low[k], high: km.ci_high[k]}))};
      }).filter(c => c.d.length);
      const diameters = shown.map((p, i) => {
        const c = p.statistics.curves;
        return {colour: colour(i), d: rows(c.time_s.length, k => ({
          t: c.time_s[k], v: c.critical_diameter.mean[k] * kMicro,
          low: c.critical_diameter.ci_low.length ? c.critical_diameter.ci_low[k] * kMicro : null,
          high: c.critical_diameter.ci_high.length ? c.critical_diameter.ci_high[k] * kMicro : null}))};
      }).filter(c => c.d.length);
      const panels = [];
      if (survival.length) panels.push(overlay(survival, "time (s)", "fraction not clogged", true));
      if (diameters.length) panels.push(overlay(diameters, "time (s)", "mean critical diameter (µm)", false));
      return panels.length ? panels : "No realisation has finished.";
    }, {columns: 2, legend: shown.map((p, i) => [label(p), colour(i), "line"])}));
  return out;
}

// --- One design point -----------------------------------------------------------------

function curvesFigure(p, id) {
  const s = p.statistics;
  const level = percent(s.confidence);
  const stages = s.stages;
  const stage = (name, t) => t == null ? `${name}: not reached` : `${name}: ${general(t)} s`;
  const point = s.tc.mean != null ? "mean clogging time"
    : "restricted mean clogging time (some realisations did not clog)";
  return figure(`curves-${id}`, "How the throat closes.",
    `Mean of ${s.curves.critical_diameter.n} realisations (line); pointwise ${level} t-interval (dark); ${level} simultaneous bootstrap band for the whole curve (light); mean ± one standard deviation between realisations (dashed). Star: the ${point} on the mean curve. Dotted: ends of the stages (${stage("I", stages.end_of_first_s)}, median t_1; ${stage("II", stages.end_of_second_s)}, mean l_c reaches the colloid diameter; ${stage("III", stages.end_of_third_s)}, the spread has settled).`
    + (s.curves.critical_diameter.note ? ` ${s.curves.critical_diameter.note}.` : ""),
    () => !s.curves.time_s.length ? "No realisation of the complete prefix has a curve." : [
      meanCurvePanel(s, "critical_diameter", kMicro, "critical diameter (µm)", kColour.blue, diameterOf(p)),
      meanCurvePanel(s, "permeability_ratio", 1, "permeability, k/k(0)", kColour.green, null)],
    {columns: 2, legend: [["mean", kColour.ink, "line"], ["pointwise t-interval", "#4d7ea3", "band"], ["simultaneous band", "#a9c6dd", "band"],
                          ["± standard deviation", kColour.grey, "dash"], ["mean clogging point", kColour.vermillion, "star"]]});
}

function injectionFigures(p, id) {
  const s = p.statistics;
  const fits = s.injection_fits ?? [];
  const inlet = inletOf(p);
  if (!fits.length || !inlet) return [];
  const level = percent(s.confidence);
  const top = Math.min(1, 1.1 * (d3.max(fits, f => d3.max(f.probability)) || 0.1) + 0.02);
  const reach = d3.max(inlet) * kMicro / 2 - (diameterOf(p) ?? 0) / 2;
  const text = f => f.amplitude == null ? `no fit: ${f.note ?? ""}`
    : !worthDrawing(f) ? `no fit better than a constant (R² = ${general(f.r_squared, 2)})`
    : `A = ${general(f.amplitude, 2)}, b = ${general(f.rate_per_m / kMicro, 2)} /µm`
      + (f.rate_ci ? ` (${general(f.rate_ci[0] / kMicro, 2)} to ${general(f.rate_ci[1] / kMicro, 2)})` : " (interval not determined)")
      + (f.r_squared == null ? "" : `, R² = ${f.r_squared.toFixed(2)}`);
  return [
    figure(`injection-${id}`, "Where the first five retained colloids came in.",
      "Centres at the moment of injection, seen from above; grains in grey; concentric square annuli 3 µm wide, the last one cut by the edge of the inlet section."
      + (p.injection_dots.length < 5 * s.n * 0.5 && s.n > 400 ? ` ${p.injection_dots.length} places are shown, evenly in seed order.` : ""),
      () => p.injection_dots.length ? [injectionMap(p, inlet)] : "No colloid was retained.",
      {legend: kOrders.map((name, i) => [name, orderColour(i), "dot"])}),
    figure(`profiles-${id}`, "Distance from the axis at which they came in.",
      `Fraction of ${fits[0].n} realisations whose n-th retained colloid came in through each annulus (bars: ${level} Clopper-Pearson), and A exp(b x) by nonlinear least squares through the annuli that a colloid's centre can reach (up to the dotted line). Intervals of b: BCa bootstrap over realisations.`,
      () => fits.map(f => titled(`${kOrders[f.order - 1]}: ${text(f)}`, injectionPanel(f, top, reach))),
      {columns: 3}),
  ];
}

function exampleFigures(p, id) {
  const shown = p.examples.filter(e => e.series);
  if (!p.examples.length) return [];
  const gone = "Their result files are not in the run folder any more.";
  const top = {
    diameter: 1.05 * kMicro * d3.max(shown, e => d3.max(e.series.critical_diameter_m)),
    ratio: 1.05 * d3.max(shown, e => d3.max(e.series.permeability_ratio)),
    count: 1.05 * d3.max(shown, e => d3.max([...e.series.traversed ?? [0], ...e.series.first_layer ?? [0],
                                             ...e.series.multilayer ?? [0], 1])),
  };
  const name = e => `${e.title}: realisation ${e.idx}, ` + (e.tc_s == null
    ? `not clogged after ${general(e.end_s)} s` : `t_c = ${general(e.tc_s)} s`);
  const times = e => {
    const middle = e.t1_s == null ? e.end_s / 2 : (e.t1_s + (e.tc_s ?? e.end_s)) / 2;
    const all = [["first retention", e.t1_s], ["half way", middle], ["clogging", e.tc_s], ["end", e.end_s]];
    return all.filter(([, t]) => t != null);
  };
  const diameter = diameterOf(p);
  return [
    figure(`examples-${id}`, "Two realisations side by side.",
      "Critical diameter (horizontal line: the colloids' diameter), permeability, and counts of colloids. Dashed red: clogging.",
      () => shown.length ? shown.map(e => titled(name(e), h("div", {}, examplePanels(e, diameter, top)))) : gone,
      {columns: 2, legend: [["traversed", kColour.ink, "line"], ["first layer", kColour.blue, "line"],
                            ["multilayer", kColour.orange, "line"]]}),
    figure(`deposit-${id}`, "The deposit of these two.",
      "Upper row: from the side, flow downwards; lower row: from above. Retained colloids only, to scale.",
      () => {
        const drawable = shown.filter(e => e.grains && e.box_m && diameter);
        return drawable.length ? drawable.map((e, k) => {
          const row = view => times(e).map(([what, t], i) => titled(
            view === "side" ? `${what}, ${general(t)} s` : "",
            depositPicture(e, t, view, diameter, `${id}-${k}-${view}-${i}`)));
          const grid = `display:grid;gap:.5rem;grid-template-columns:repeat(4,minmax(0,1fr));align-items:end`;
          return titled(name(e), h("div", {}, h("div", {style: grid}, row("side")),
                                   h("div", {style: grid}, row("above"))));
        }) : gone;
      }, {legend: [["first layer (on a grain)", kColour.blue, "dot"],
                   ["multilayer (on the deposit)", kColour.orange, "dot"], ["on a wall", kColour.green, "dot"]]}),
  ];
}

function alphaCaption(s) {
  const f = s.alpha_fit;
  const level = percent(s.confidence);
  const slope = (g, name) => {
    const [number, interval] = withInterval(g.slope_s_per_deg, g.slope_ci?.[0], g.slope_ci?.[1]);
    return `${name}: slope ${number} s/deg` + (interval ? ` (${level}: ${interval})` : "");
  };
  let text = "Angle from the throat plane (0: narrowest; positive: upstream), seen from the centre of the touched grain. ";
  text += f.slope_s_per_deg == null ? `No line: ${f.note ?? ""}. `
    : `${slope(f, "Line, least squares")}, intercept ${general(f.intercept_s)} s, `
      + `R² = ${f.r_squared == null ? "–" : f.r_squared.toFixed(2)}, n = ${f.n}; ${f.n_excluded} excluded (censored, or without an angle). `;
  if (f.censored_regression?.slope_s_per_deg != null) {
    text += `${slope(f.censored_regression, "Dashed, censored regression by maximum likelihood")}. `;
  }
  return text + "Triangles: not clogged when they ended.";
}

const pointHead = s => [countsLine(s), warnings(s.warnings), headlineCards(s)]
  .filter(x => x);

function pointFigures(p, id) {
  const s = p.statistics;
  const n = Math.max(1, s.n);
  return [
    curvesFigure(p, id),
    figure(`survival-${id}`, "Fraction of realisations that have not clogged.",
      `Kaplan-Meier estimate with pointwise ${percent(s.confidence)} intervals (${s.clogging.kaplan_meier.method}); crosses: censored.`
      + (s.clogging.median_s == null ? " The median is not reached."
        : ` Red: median with its ${percent(s.confidence)} interval (${s.clogging.median_method}).`),
      () => s.clogging.kaplan_meier.time_s.length ? [survivalFigure(s)] : "No realisation has begun."),
    figure(`alpha-${id}`, "Does the place of the first attachment decide how soon it clogs?", alphaCaption(s),
      () => p.alpha_dots.length ? [alphaFigure(p)] : "No realisation has an angle of first attachment."),
    ...injectionFigures(p, id),
    ...exampleFigures(p, id),
    figure(`mechanisms-${id}`, "How colloids are held.",
      `Mean over ${n} realisations at their end. Bridging by friction is not modelled by the tiers one_way and quasi_steady.`,
      () => p.layers.rows.length ? [mechanismFigure(p)] : "No colloid was retained."),
  ].filter(x => x);
}

function realisationsTable(p) {
  const t = p.realisations;
  const at = name => t.columns.indexOf(name);
  const columns = [
    ["index", "idx", v => String(v)], ["seed", "seed", v => v, true],
    ["status", "status", v => v, true], ["t_1 (s)", "t1_s", v => v?.toFixed(3)],
    ["t_c (s)", "tc_s", v => v?.toFixed(3)], ["angle (deg)", "alpha_deg", v => v?.toFixed(1)],
    ["l_c at the end (µm)", "lc_end_m", v => v == null ? null : (v * kMicro).toFixed(2)],
    ["k/k(0) at the end", "permeability_ratio_end", v => v?.toFixed(3)],
    ["injected", "injected", v => v], ["retained", "retained", v => v],
    ["traversed", "traversed", v => v], ["wall time (s)", "wall_s", v => v?.toFixed(1)],
    ["processor time (s)", "cpu_s", v => v?.toFixed(1)], ["attempts", "attempts", v => v]];
  return h("details", {}, h("summary", {}, `Realisations${content.points.length > 1 ? `: ${label(p)}` : ""} (${t.rows.length} of ${t.all} shown)`),
    table(columns.map(([name, , , words]) => ({name, words})),
          t.rows.map(row => columns.map(([, key, shown]) => {
            const value = shown(row[at(key)]);
            const text = value == null ? null : String(value);
            return key === "status" && text === "failed" ? h("span.ink-failed", {}, text) : text;
          }))));
}

function plainTable(t, words) {
  return table(t.columns.map(name => ({name: name.replaceAll("_", " "), words: words.includes(name)})),
               t.rows.map(r => r.map(v => v == null ? null : String(v))));
}

function provenanceSection() {
  const made = content.made_by ?? {};
  const cost = content.points.map(p => {
    const [attempts, wall, cpu, memory] = p.cost.rows[0];
    return [label(p), String(attempts), general(cpu / 3600), general(cpu / Math.max(1, p.finished)),
            general(wall / Math.max(1, p.finished)), memory == null ? null : general(memory / 1024)];
  });
  return h("section", {},
    h("h2", {}, "Realisations and their cost"),
    table([{name: "ensemble", words: true}, {name: "attempts"}, {name: "core-hours"},
           {name: "core-seconds per realisation"}, {name: "wall seconds per realisation"},
           {name: "largest memory (MiB)"}], cost),
    content.points.slice(0, 40).map(realisationsTable),
    content.failures.rows.length ? [h("h3", {}, "Attempts that left no result"),
      plainTable(content.failures, ["tier", "cause", "message"])] : null,
    content.incidents.rows.length ? [h("h3", {}, "Incidents"),
      plainTable(content.incidents, ["tier", "kind", "text"])] : null,
    h("h2", {}, "Provenance"),
    plainTable(content.programs, ["version", "commit_hash", "cpu_model", "node", "first", "last"]),
    h("p.meta", {}, `Report made ${content.made} by poreclog ${made.version ?? ""} (commit ${made.commit ?? "unknown"}) from ${content.database}. `
      + `Repeat one realisation alone: poreclog show ${content.campaign} POINT INDEX --command.`),
    h("h2", {}, "How to cite"),
    h("p", {}, `The poreclog developers: poreclog ${made.version ?? ""}, commit ${made.commit ?? "unknown"}. CITATION.cff in its repository has the entry. Please give the campaign's master seed (${content.master_seed}) and tier with any number. The reference throat is that of Liu, Shikhov & Arns (2024), Transport in Porous Media 151, 831–851; cite it if you use it.`),
    h("p.meta", {}, "Figures drawn with Observable Plot and D3 (ISC licence)."));
}

function build() {
  const several = content.points.length > 1;
  report.append(...[
    h("h1", {}, content.campaign),
    content.description ? h("p.lead", {}, content.description) : null,
    h("p.meta", {}, `poreclog report, ${content.made.slice(0, 16).replace("T", " ")} UTC`),
  ].filter(x => x));
  if (several) {
    report.append(h("h2", {}, "Headline numbers"), headlineTable(), ...[pairedTable()].filter(x => x),
                  ...comparison(), askedSection(), h("h2", {}, "Design points"));
    content.points.forEach((p, i) => {
      const body = h("details.point", {}, h("summary", {}, label(p)));
      const fill = () => { if (body.children.length === 1) body.append(...pointHead(p.statistics), ...pointFigures(p, i)); };
      body.addEventListener("toggle", fill);
      if (i === 0) { fill(); body.open = true; }
      report.append(body);
    });
  } else {
    const p = content.points[0];
    report.append(h("h2", {}, "Headline numbers"), ...pointHead(p.statistics), askedSection(),
                  h("h2", {}, "Figures"), ...pointFigures(p, 0));
  }
  report.append(provenanceSection());
  window.addEventListener("beforeprint", openAll);
  if (location.hash === "#all") openAll();
}

/// Nothing folded: on paper, and at report.html#all.
function openAll() {
  for (const details of report.querySelectorAll("details")) {
    details.open = true;
    details.dispatchEvent(new Event("toggle"));
  }
}

try {
  build();
} catch (error) {
  noteError(error);
  report.append(h("p.ink-failed", {}, `The report could not be built: ${error}`));
}
document.documentElement.dataset.figures = String(figureCount);
document.documentElement.dataset.ready = "1";
