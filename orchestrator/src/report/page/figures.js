// The figures of a report: functions from its content to SVG.  Lengths in micrometres,
// times in seconds.  Colours: Okabe & Ito (2008), and cividis, which are safe for the
// colour blind.
"use strict";

const kColour = {
  blue: "#0072b2", vermillion: "#d55e00", green: "#009e73", orange: "#e69f00",
  sky: "#56b4e9", purple: "#cc79a7", grey: "#7a828e", ink: "#1d2430",
};
const kSeries = [kColour.blue, kColour.vermillion, kColour.green, kColour.purple,
                 kColour.orange, kColour.sky, kColour.ink, kColour.grey];
const kMicro = 1e6;
const kFont = '"Source Sans 3", "Liberation Sans", "Helvetica Neue", Arial, sans-serif';

/// Plot.plot with what all figures share.
function chart(options) {
  return Plot.plot({
    width: 520, height: 300, marginLeft: 56, marginBottom: 44, marginTop: 24, marginRight: 16,
    style: {fontFamily: kFont, fontSize: "13px", color: kColour.ink, background: "#fff"},
    ...options,
    x: {labelAnchor: "center", labelArrow: "none", labelOffset: 38, nice: false, ...options.x},
    y: {labelAnchor: "center", labelArrow: "none", labelOffset: 48, nice: true, ...options.y},
  });
}

const frame = () => Plot.frame({stroke: "#9aa2ad"});
const rows = (n, make) => Array.from({length: n}, (_, i) => make(i));

/// A legend entry: [label, colour, shape], with shape line | band | dot | dash | star.
function legend(entries) {
  const box = document.createElement("div");
  box.className = "legend";
  for (const [label, colour, shape] of entries) {
    const item = document.createElement("span");
    const svg = d3.create("svg").attr("width", 26).attr("height", 14);
    if (shape === "band") {
      svg.append("rect").attr("y", 2).attr("width", 26).attr("height", 10).attr("fill", colour)
        .attr("fill-opacity", 0.3);
    } else if (shape === "dot") {
      svg.append("circle").attr("cx", 13).attr("cy", 7).attr("r", 5).attr("fill", colour);
    } else if (shape === "star" || shape === "triangle") {
      svg.append("path").attr("transform", "translate(13,7)").attr("fill", colour)
        .attr("d", d3.symbol(shape === "star" ? d3.symbolStar : d3.symbolTriangle, 70)());
    } else {
      svg.append("line").attr("x2", 26).attr("y1", 7).attr("y2", 7).attr("stroke", colour)
        .attr("stroke-width", 2.5).attr("stroke-dasharray", shape === "dash" ? "5,4" : null);
    }
    item.append(svg.node(), document.createTextNode(label));
    box.append(item);
  }
  return box;
}

function stageMarks(stages, end) {
  const ends = [["I", stages.end_of_first_s], ["II", stages.end_of_second_s],
                ["III", stages.end_of_third_s]].filter(([, t]) => t != null && t <= end);
  // Regions have names only as far as their ends are known, one after the other.
  const all = [stages.end_of_first_s, stages.end_of_second_s, stages.end_of_third_s];
  const known = all.findIndex(t => t == null);
  const inOrder = ends.length === (known < 0 ? 3 : known)
    && ends.every(([, t], i) => i === 0 || t >= ends[i - 1][1]);
  const serif = {fontFamily: "Georgia, 'Liberation Serif', serif"};
  const marks = [Plot.ruleX(ends, {x: d => d[1], stroke: kColour.grey,
                                   strokeDasharray: "2,3"})];
  if (inOrder) {
    const names = ends.map(([name, t], i) => [name, ((i ? ends[i - 1][1] : 0) + t) / 2]);
    if (ends.length === 3) names.push(["IV", (ends[2][1] + end) / 2]);
    marks.push(Plot.text(names, {x: d => d[1], text: d => d[0], frameAnchor: "top", dy: -12,
                                 fill: kColour.grey, ...serif}));
  } else {
    marks.push(Plot.text(ends, {x: d => d[1], text: d => `end of ${d[0]}`, frameAnchor: "top",
                                dy: -12, fill: kColour.grey, ...serif}));
  }
  return marks;
}

/// Mean clogging point: where the mean clogging time lies on the mean curve.
function meanClogging(statistics) {
  const time = statistics.tc.mean ?? statistics.clogging.restricted_mean_s;
  const grid = statistics.curves.time_s;
  if (time == null || !grid.length || time > grid[grid.length - 1]) return null;
  const at = values => {
    const i = Math.min(d3.bisectRight(grid, time), grid.length - 1);
    const share = i ? (time - grid[i - 1]) / (grid[i] - grid[i - 1]) : 0;
    return i ? values[i - 1] + share * (values[i] - values[i - 1]) : values[0];
  };
  return {time, at};
}

function meanCurvePanel(statistics, key, scale, label, colour, diameter) {
  const curve = statistics.curves[key];
  const grid = statistics.curves.time_s;
  const d = rows(grid.length, i => ({
    t: grid[i], mean: curve.mean[i] * scale,
    low: curve.ci_low[i] * scale, high: curve.ci_high[i] * scale,
    bandLow: curve.band_low[i] * scale, bandHigh: curve.band_high[i] * scale,
    above: (curve.mean[i] + curve.sd[i]) * scale, below: (curve.mean[i] - curve.sd[i]) * scale,
  }));
  const spread = curve.sd.length > 0;
  const star = meanClogging(statistics);
  const end = grid[grid.length - 1];
  const top = 1.04 * d3.max(d, p => Math.max(p.mean, spread ? p.bandHigh : 0,
                                             spread ? p.above : 0));
  return chart({
    height: 320,
    x: {label: "time (s)", domain: [0, end]},
    y: {label, domain: [0, top], nice: false},
    marks: [
      frame(),
      ...stageMarks(statistics.stages, end),
      spread ? Plot.areaY(d, {x: "t", y1: "bandLow", y2: "bandHigh", fill: colour,
                              fillOpacity: 0.16, clip: true}) : null,
      spread ? Plot.areaY(d, {x: "t", y1: "low", y2: "high", fill: colour,
                              fillOpacity: 0.28, clip: true}) : null,
      spread ? Plot.lineY(d, {x: "t", y: "above", stroke: colour, strokeWidth: 1,
                              strokeDasharray: "4,3"}) : null,
      spread ? Plot.lineY(d, {x: "t", y: "below", stroke: colour, strokeWidth: 1,
                              strokeDasharray: "4,3", clip: true}) : null,
      diameter ? Plot.ruleY([diameter], {stroke: kColour.ink, strokeWidth: 1}) : null,
      diameter ? Plot.text([diameter], {y: v => v, text: () => "colloid diameter",
                                        frameAnchor: "right", dx: -6, dy: 10,
                                        stroke: "#fff", strokeWidth: 4, fill: kColour.ink}) : null,
      Plot.lineY(d, {x: "t", y: "mean", stroke: colour, strokeWidth: 2.2}),
      star ? Plot.dot([star], {x: "time", y: s => s.at(curve.mean) * scale, symbol: "star",
                               r: 8, fill: kColour.vermillion, stroke: "#fff"}) : null,
    ],
  });
}

function survivalFigure(statistics) {
  const km = statistics.clogging.kaplan_meier;
  const tau = statistics.clogging.restricted_mean_tau_s;
  const d = rows(km.time_s.length, i => ({t: km.time_s[i], s: km.survival[i],
                                          low: km.ci_low[i], high: km.ci_high[i],
                                          censored: km.censored[i]}));
  const end = Math.max(tau ?? 0, d[d.length - 1].t);
  if (d[d.length - 1].t < end && d[d.length - 1].s === 0) {
    d.push({...d[d.length - 1], t: end, censored: 0});
  }
  const [low, high] = statistics.clogging.median_ci ?? [null, null];
  const median = statistics.clogging.median_s;
  return chart({
    width: 720, height: 340,
    x: {label: "time (s)", domain: [0, end]},
    y: {label: "fraction not clogged", domain: [0, 1], nice: false},
    marks: [
      frame(),
      Plot.areaY(d, {x: "t", y1: "low", y2: "high", curve: "step-after", fill: kColour.blue,
                     fillOpacity: 0.22}),
      Plot.lineY(d, {x: "t", y: "s", curve: "step-after", stroke: kColour.blue,
                     strokeWidth: 2.2}),
      Plot.dot(d.filter(p => p.censored > 0), {x: "t", y: "s", symbol: "plus", r: 6,
                                               stroke: kColour.ink, clip: false}),
      median != null ? Plot.ruleX([median], {y1: 0, y2: 0.5, stroke: kColour.vermillion,
                                             strokeDasharray: "4,3"}) : null,
      median != null ? Plot.link([0], {x1: low ?? 0, x2: high ?? end, y1: 0.5, y2: 0.5,
                                       stroke: kColour.vermillion, strokeWidth: 2}) : null,
      median != null ? Plot.dot([median], {x: t => t, y: 0.5, r: 4.5,
                                           fill: kColour.vermillion}) : null,
      median != null ? Plot.text([median], {x: t => t, y: 0.5, text: () => "median", dx: 8,
                                            dy: -10, textAnchor: "start",
                                            fill: kColour.vermillion}) : null,
    ],
  });
}

function alphaFigure(point) {
  const fit = point.statistics.alpha_fit;
  const d = point.alpha_dots.map(p => ({...p, lost: p.lost_m == null ? null
                                                                     : p.lost_m * kMicro}));
  const span = d3.extent(d, p => p.alpha_deg);
  const line = f => f && f.slope_s_per_deg != null
    ? span.map(a => ({a, t: f.intercept_s + f.slope_s_per_deg * a})) : [];
  const censored = line(fit.censored_regression);
  return chart({
    width: 720, height: 370, marginTop: 14,
    x: {label: "elevation angle of the first attachment, α (deg)", nice: true},
    y: {label: "time from first retention to clogging (s)", zero: true},
    color: {type: "linear", scheme: "cividis", label: "critical diameter lost to it (µm)",
            legend: d.some(p => p.lost != null)},
    symbol: {},
    marks: [
      frame(),
      Plot.line(line(fit), {x: "a", y: "t", stroke: kColour.ink, strokeWidth: 2, clip: true}),
      Plot.line(censored, {x: "a", y: "t", stroke: kColour.vermillion, strokeWidth: 2,
                           strokeDasharray: "6,4", clip: true}),
      Plot.dot(d.filter(p => !p.censored), {x: "alpha_deg", y: "duration_s", r: 5,
        fill: p => p.lost, stroke: kColour.ink, strokeWidth: 0.7,
        title: p => `realisation ${p.idx}`}),
      Plot.dot(d.filter(p => p.censored), {x: "alpha_deg", y: "duration_s", r: 5,
        symbol: "triangle", fill: p => p.lost, stroke: kColour.vermillion, strokeWidth: 1.2,
        title: p => `realisation ${p.idx}, not clogged when it ended`}),
    ],
  });
}

/// Circles in the units of the axes, as closed lines; d: [{x, y, r, fill}].
function circles(d, options) {
  const points = d.flatMap((c, id) => rows(73, k => ({
    id, fill: c.fill, x: c.x + c.r * Math.cos(k * Math.PI / 36),
    y: c.y + c.r * Math.sin(k * Math.PI / 36)})));
  return Plot.line(points, {x: "x", y: "y", z: "id", curve: "linear-closed", clip: true,
                            ...options});
}

const kOrders = ["first", "second", "third", "fourth", "fifth"];
const orderColour = i => d3.interpolateViridis(0.02 + 0.235 * i);

function injectionMap(point, inlet) {
  const [width, depth] = inlet.map(v => v * kMicro);
  const step = 3;
  const squares = [];
  for (let half = step; half < Math.max(width, depth) / 2; half += step) {
    squares.push({x1: Math.max(0, width / 2 - half), x2: Math.min(width, width / 2 + half),
                  y1: Math.max(0, depth / 2 - half), y2: Math.min(depth, depth / 2 + half)});
  }
  const grains = (point.examples[0]?.grains ?? [])
    .map(g => ({x: g[0] * kMicro, y: g[1] * kMicro, r: g[3] * kMicro / 2}));
  const dots = point.injection_dots.map(([x, y, order]) => ({x: x * kMicro, y: y * kMicro,
                                                             order}));
  return chart({
    width: 540, height: 540 * depth / width - 4, marginRight: 20, aspectRatio: 1,
    x: {label: "x (µm)", domain: [0, width]},
    y: {label: "y (µm)", domain: [0, depth], nice: false},
    marks: [
      circles(grains, {fill: "#e9ecf0", stroke: "#c3c9d2"}),
      Plot.rect(squares, {x1: "x1", x2: "x2", y1: "y1", y2: "y2", stroke: "#c3c9d2",
                          strokeWidth: 0.7, fill: "none"}),
      frame(),
      Plot.dot(dots, {x: "x", y: "y", r: dots.length > 600 ? 2.5 : 4.5,
                      fill: p => orderColour(p.order - 1), stroke: "#fff",
                      strokeWidth: 0.8}),
    ],
  });
}

/// A least-squares fit worse than a constant is a local minimum far from the data.
const worthDrawing = fit => fit.amplitude != null && !(fit.r_squared < 0);

/// `reach`: how far out a colloid's centre can come in (µm); the fit ends there.
function injectionPanel(profile, top, reach) {
  const d = rows(profile.annulus_centre_m.length, i => ({
    x: profile.annulus_centre_m[i] * kMicro, p: profile.probability[i],
    low: profile.probability_ci_low[i], high: profile.probability_ci_high[i]}));
  const last = d[d.length - 1].x;
  const fit = !worthDrawing(profile) ? [] : rows(101, i => {
    const x = Math.min(last, reach) * i / 100;
    return {x, p: profile.amplitude * Math.exp(profile.rate_per_m * x / kMicro)};
  });
  return chart({
    width: 330, height: 230, marginLeft: 52,
    x: {label: "distance from the centre (µm)", domain: [0, last * 1.04]},
    y: {label: "probability", domain: [0, top], nice: false, ticks: 5},
    marks: [
      frame(),
      Plot.ruleX(d, {x: "x", y1: "low", y2: p => Math.min(top, p.high), stroke: "#aab2bd"}),
      Plot.ruleX([reach], {stroke: kColour.grey, strokeDasharray: "2,3"}),
      Plot.line(fit, {x: "x", y: "p", stroke: kColour.vermillion, strokeWidth: 2, clip: true}),
      Plot.dot(d, {x: "x", y: "p", r: 3.5, fill: orderColour(profile.order - 1),
                   stroke: "#fff", strokeWidth: 0.6}),
    ],
  });
}

/// One example realisation: [l_c, k, counts], on axes that all examples share.
function examplePanels(example, diameter, top) {
  const s = example.series;
  const n = s.time_s.length;
  const end = s.time_s[n - 1];
  const series = key => rows(n, i => ({t: s.time_s[i], v: s[key]?.[i]}))
    .filter(p => p.v != null);
  const event = Plot.ruleX(example.tc_s == null ? [] : [example.tc_s],
                           {stroke: kColour.vermillion, strokeDasharray: "4,3"});
  const panel = (label, domain, marks) => chart({
    width: 500, height: 210, marginTop: 10, x: {label: "time (s)", domain: [0, end]},
    y: {label, domain, ticks: 5}, marks: [frame(), event, ...marks]});
  const step = (key, scale, colour) => Plot.lineY(series(key), {
    x: "t", y: p => p.v * scale, curve: "step-after", stroke: colour, strokeWidth: 2});
  return [
    panel("critical diameter (µm)", [0, top.diameter], [
      diameter ? Plot.ruleY([diameter], {strokeWidth: 1}) : null,
      step("critical_diameter_m", kMicro, kColour.blue)]),
    panel("permeability, k/k(0)", [0, top.ratio],
          [step("permeability_ratio", 1, kColour.green)]),
    panel("colloids", [0, top.count], [
      step("traversed", 1, kColour.ink), step("first_layer", 1, kColour.blue),
      step("multilayer", 1, kColour.orange)]),
  ];
}

const layerColour = layer => ({first: kColour.blue, multilayer: kColour.orange})[layer]
  ?? kColour.green;

/// The deposit at one time, seen from the side (along y) or from above (along z).
function depositPicture(example, time, view, diameter, id) {
  const [lx, ly, lz] = example.box_m.map(v => v * kMicro);
  const high = view === "side" ? lz : ly;
  const width = 230;
  const scale = width / lx;
  const svg = d3.create("svg").attr("viewBox", `-1 -1 ${width + 2} ${high * scale + 2}`)
    .attr("width", width).attr("xmlns", "http://www.w3.org/2000/svg")
    .style("font-family", kFont);
  const clip = `clip-${id}`;
  svg.append("clipPath").attr("id", clip).append("rect").attr("width", width)
    .attr("height", high * scale);
  svg.append("rect").attr("width", width).attr("height", high * scale).attr("fill", "#fff");
  const place = g => view === "side" ? [g[0] * scale, (high - g[2]) * scale]
                                     : [g[0] * scale, (high - g[1]) * scale];
  const inside = svg.append("g").attr("clip-path", `url(#${clip})`);
  const ball = (g, r, fill, opacity, stroke) => {
    const [x, y] = place(g);
    inside.append("circle").attr("cx", x).attr("cy", y).attr("r", r * scale)
      .attr("fill", fill).attr("fill-opacity", opacity).attr("stroke", stroke)
      .attr("stroke-width", 0.8);
  };
  for (const g of example.grains) {
    ball(g.slice(0, 3).map(v => v * kMicro), g[3] * kMicro / 2, "#c9ced6", 0.55, "#8d95a1");
  }
  const depth = view === "side" ? c => -c.y_m : c => c.z_m;
  const deposit = example.retained.filter(c => c.time_s <= time && c.x_m != null)
    .sort((a, b) => depth(a) - depth(b));
  for (const c of deposit) {
    const at = [c.x_m, c.y_m, c.z_m].map(v => v * kMicro);
    ball(at, diameter / 2, layerColour(c.layer), 0.95, "#fff");
    const shine = [at[0] - diameter * 0.14, at[1] + (view === "side" ? 0 : diameter * 0.14),
                   at[2] + (view === "side" ? diameter * 0.14 : 0)];
    const [x, y] = place(shine);
    inside.append("circle").attr("cx", x).attr("cy", y).attr("r", diameter * 0.13 * scale)
      .attr("fill", "#fff").attr("fill-opacity", 0.35);
  }
  svg.append("rect").attr("width", width).attr("height", high * scale).attr("fill", "none")
    .attr("stroke", "#5b6472");
  const bar = svg.append("g").attr("transform", `translate(8,${high * scale - 8})`);
  bar.append("rect").attr("x", -3).attr("y", -17).attr("width", 20 * scale + 6)
    .attr("height", 22).attr("fill", "#fff").attr("fill-opacity", 0.8);
  bar.append("line").attr("x2", 20 * scale).attr("stroke", kColour.ink)
    .attr("stroke-width", 2.5);
  bar.append("text").attr("x", 10 * scale).attr("y", -4).attr("text-anchor", "middle")
    .attr("font-size", 11).text("20 µm");
  return svg.node();
}

const kMechanisms = {
  attachment_to_grain: "attached to a grain", attachment_to_deposit: "attached to the deposit",
  attachment_to_wall: "attached to a side wall", straining: "strained",
};
const kLayers = {first: "first layer", multilayer: "multilayer", wall: "wall"};

function mechanismFigure(point) {
  const n = Math.max(1, point.finished);
  const d = point.layers.rows.map(([layer, mechanism, colloids]) => ({
    label: `${kMechanisms[mechanism] ?? mechanism}, ${kLayers[layer] ?? layer}`,
    layer, mean: colloids / n}));
  return chart({
    width: 720, height: 60 + 34 * d.length, marginLeft: 230, marginTop: 8, marginRight: 50,
    x: {label: "retained colloids per realisation", nice: true},
    y: {label: null, domain: d.map(p => p.label), tickSize: 0},
    marks: [
      Plot.barX(d, {x: "mean", y: "label", fill: p => layerColour(p.layer), insetTop: 3,
                    insetBottom: 3}),
      Plot.text(d, {x: "mean", y: "label", text: p => p.mean.toFixed(p.mean < 10 ? 2 : 1),
                    textAnchor: "start", dx: 6}),
      Plot.ruleX([0]),
    ],
  });
}

/// A headline number against the varied parameter; d: [{x, series, v, low, high}].
function sweepPanel(d, xLabel, numeric, yLabel, colours, domain) {
  const shown = d.filter(p => p.v != null);
  const xs = shown.map(p => p.x);
  const wide = numeric && d3.min(xs) > 0 && d3.max(xs) / d3.min(xs) >= 20;
  return chart({
    width: 340, height: 280, marginBottom: numeric ? 44 : 60,
    x: numeric ? {label: xLabel, type: wide ? "log" : "linear", nice: true,
                  tickFormat: wide ? "~g" : undefined, ticks: wide ? 4 : 5, inset: 14}
               : {label: xLabel, type: "point", domain: [...new Set(d.map(p => p.x))],
                  padding: 0.5},
    y: {label: yLabel, zero: true, domain, ticks: 5},
    marks: [
      frame(),
      numeric ? Plot.line(shown, {x: "x", y: "v", z: "series", sort: "x",
                                  stroke: p => colours(p.series), strokeOpacity: 0.5}) : null,
      Plot.ruleX(shown.filter(p => p.low != null && p.high != null),
                 {x: "x", y1: "low", y2: "high", stroke: p => colours(p.series),
                  strokeWidth: 2}),
      Plot.dot(shown, {x: "x", y: "v", fill: p => colours(p.series), r: 5, stroke: "#fff"}),
    ],
  });
}

/// One curve with its band for each design point.
function overlay(curves, xLabel, yLabel, step, diameter) {
  const curve = step ? "step-after" : "linear";
  return chart({
    width: 520, height: 330,
    x: {label: xLabel, domain: [0, d3.max(curves, c => d3.max(c.d, p => p.t))]},
    y: {label: yLabel, zero: true, nice: !step},
    marks: [
      frame(),
      ...curves.map(c => Plot.areaY(c.d.filter(p => p.low != null), {
        x: "t", y1: "low", y2: "high", curve, fill: c.colour, fillOpacity: 0.14})),
      diameter ? Plot.ruleY([diameter], {strokeWidth: 1}) : null,
      ...curves.map(c => Plot.lineY(c.d, {x: "t", y: "v", curve, stroke: c.colour,
                                          strokeWidth: 2})),
    ],
  });
}
