"use strict";
// Draws the page from the JSON of the report. Nothing here decides anything: verdicts and conclusions come with the data.

const problems = [];
window.addEventListener("error", event => {
  problems.push(event.message);
  document.documentElement.dataset.problems = problems.join("; ");
  const notice = document.createElement("p");
  notice.className = "notice";
  notice.textContent = "This page could not be drawn whole: " + event.message + ". The figures are also in report.json beside it.";
  document.body.prepend(notice);
});

const report = JSON.parse(document.getElementById("report").textContent);
const page = document.getElementById("page");
const charts = [];

// --- words and numbers -----------------------------------------------------------------------------------------------------------

const superscript = n => String(n).replace(/[-0-9]/g, c => c === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[c]);
const isNumber = x => typeof x === "number" && Number.isFinite(x);

function figure(x, digits = 3) {
  if (!isNumber(x)) return "–";
  if (x === 0) return "0";
  const size = Math.abs(x);
  return size >= 1e5 || size < 1e-2 ? x.toExponential(digits - 1).replace("e+", "e").replace(/\.?0+e/, "e") : String(+x.toPrecision(digits));
}

function time(s) {
  if (!isNumber(s)) return "–";
  if (s >= 120) return `${figure(s / 60)} min`;
  if (s >= 1) return `${figure(s)} s`;
  return s >= 1e-3 ? `${figure(s * 1e3)} ms` : `${figure(s * 1e6)} µs`;
}

const bytes = b => isNumber(b) ? (b >= 1e9 ? `${figure(b / 1e9)} GB` : `${figure(b / 1e6)} MB`) : "–";
const isDecade = x => Math.abs(Math.log10(x) - Math.round(Math.log10(x))) < 1e-6;
const baseName = path => path.startsWith("builtin:") ? path : path.split("/").pop();
const probeName = i => baseName(report.probes[i].name);
const count = (n, noun) => `${n} ${noun}${n === 1 ? "" : "s"}`;

/// Text of a tick on a logarithmic axis: decades, and 2 and 5 too where the axis spans little.
function tickText(value, scale, text) {
  const decades = Math.log10(scale.max / scale.min);
  const leading = value / 10 ** Math.floor(Math.log10(value) + 1e-9);
  if (isDecade(value)) {
    const step = decades > 14 ? 3 : decades > 8 ? 2 : 1;
    return Math.round(Math.log10(value)) % step === 0 ? text(value) : "";
  }
  return decades < 2 && (Math.abs(leading - 2) < 1e-6 || Math.abs(leading - 5) < 1e-6) ? text(value) : "";
}

const powerText = v => isDecade(v) ? `10${superscript(Math.round(Math.log10(v)))}` : figure(v);
const timeText = v => v >= 1 ? `${figure(v)} s` : v >= 0.99e-3 ? `${figure(v * 1e3)} ms` : `${figure(v * 1e6)} µs`;
const bytesText = v => v >= 1e9 ? `${figure(v / 1e9)} GB` : v >= 1e6 ? `${figure(v / 1e6)} MB` : `${figure(v / 1e3)} kB`;

// --- elements --------------------------------------------------------------------------------------------------------------------

function element(tag, attributes = {}, ...children) {
  const e = document.createElement(tag);
  for (const [key, value] of Object.entries(attributes))
    if (key.startsWith("on")) e.addEventListener(key.slice(2), value);
    else if (value !== undefined && value !== null) e.setAttribute(key, value);
  e.append(...children.filter(child => child !== null && child !== undefined));
  return e;
}

function section(id, title, ...children) {
  const s = element("section", {id}, element("h2", {}, title), ...children);
  page.append(s);
  contents.append(element("a", {href: "#" + id}, title));
  return s;
}

/// A table that sorts by the column clicked. A column: {title, value(row) for sorting, text(row) to show, kind, className(row), hint(row)}.
function sortableTable(columns, rows) {
  const body = element("tbody");
  const fill = sorted => body.replaceChildren(...sorted.map(row => element("tr", {}, ...columns.map(column => {
    const shown = column.text ? column.text(row) : column.value(row);
    return element("td", {class: [column.kind, column.className?.(row)].filter(Boolean).join(" ") || null, title: column.hint?.(row)}, shown ?? "–");
  }))));
  const heads = columns.map(column => element("th", {class: column.kind === "number" ? "number" : null, scope: "col"},
    element("button", {type: "button", title: "sort", onclick: event => {
      const head = event.currentTarget.parentNode;
      const direction = head.getAttribute("aria-sort") === "ascending" ? -1 : 1;
      heads.forEach(h => h.removeAttribute("aria-sort"));
      head.setAttribute("aria-sort", direction === 1 ? "ascending" : "descending");
      const key = row => { const v = column.value(row); return v === undefined || Number.isNaN(v) ? null : v; };
      fill([...current()].sort((a, b) => {
        const x = key(a), y = key(b);
        if (x === null || y === null) return x === y ? 0 : x === null ? 1 : -1; // what was not measured stays at the end
        return direction * (typeof x === "number" && typeof y === "number" ? x - y : String(x).localeCompare(String(y)));
      }));
    }}, column.title)));
  let shownRows = rows;
  const current = () => shownRows;
  fill(rows);
  const table = element("div", {class: "scroll", tabindex: "0"}, element("table", {}, element("thead", {}, element("tr", {}, ...heads)), body));
  table.show = subset => { shownRows = subset; heads.forEach(h => h.removeAttribute("aria-sort")); fill(subset); };
  return table;
}

// --- plots -----------------------------------------------------------------------------------------------------------------------

const methods = ["auto", "reference", "spectral", "direct", "hierarchical", "importance", "paraboloid", "mip", "sh9"];
for (const c of report.cases) for (const m of c.measurements) if (!methods.includes(m.method)) methods.push(m.method);
const shapes = ["star", "cross", "circle", "rect", "triangle", "rectRot", "rectRounded", "crossRot", "dash"];
const shapeOf = method => shapes[Math.max(0, methods.indexOf(method)) % shapes.length];
const strokeOnly = shape => ["star", "cross", "crossRot", "dash"].includes(shape);
const color = name => getComputedStyle(document.documentElement).getPropertyValue("--" + name).trim() || color("text");
const hidden = new Set();

Chart.defaults.animation = false;
Chart.defaults.maintainAspectRatio = false;
Chart.defaults.font.family = getComputedStyle(document.body).fontFamily;
Chart.defaults.font.size = 12;
Chart.defaults.plugins.legend.display = false;

function axis(title, text, range, type = "logarithmic") {
  const logarithmic = type === "logarithmic";
  return {
    type, min: range?.[0], max: range?.[1],
    title: {display: true, text: title, color: color("soft"), font: {size: 12.5}},
    border: {color: color("line")},
    grid: {color: c => !logarithmic || isDecade(c.tick.value) ? color("line") : c.scale.max / c.scale.min > 1e5 ? "transparent" : color("faint"), tickColor: color("line"), borderColor: color("line")},
    ticks: {color: color("soft"), maxRotation: 0, autoSkip: !logarithmic, callback: logarithmic ? function(value) { return tickText(value, this, text); } : text},
  };
}

const degrees = scale => ({...scale, ticks: {...scale.ticks, stepSize: 30}});

/// Decades that hold all values.
function decades(values, slack = 1.15) {
  const good = values.filter(v => isNumber(v) && v > 0);
  if (good.length === 0) return [1e-6, 1];
  return [10 ** Math.floor(Math.log10(Math.min(...good) / slack)), 10 ** Math.ceil(Math.log10(Math.max(...good) * slack))];
}

/// Whiskers from x.low to x.high of points that carry them.
const whiskers = {
  id: "whiskers",
  beforeDatasetsDraw(chart) {
    const ctx = chart.ctx;
    chart.data.datasets.forEach((set, i) => {
      if (!chart.isDatasetVisible(i) || !set.whiskers) return;
      ctx.save();
      ctx.strokeStyle = set.borderColor;
      ctx.globalAlpha = 0.7;
      for (const p of set.data) {
        if (!isNumber(p.low) || !isNumber(p.high) || p.high <= p.low) continue;
        const [a, b, y] = [chart.scales.x.getPixelForValue(p.low), chart.scales.x.getPixelForValue(p.high), chart.scales.y.getPixelForValue(p.y)];
        if (b - a < 3) continue;
        ctx.beginPath();
        ctx.moveTo(a, y); ctx.lineTo(b, y);
        ctx.moveTo(a, y - 3); ctx.lineTo(a, y + 3);
        ctx.moveTo(b, y - 3); ctx.lineTo(b, y + 3);
        ctx.stroke();
      }
      ctx.restore();
    });
  },
};

/// Named lines across a plot: {axis, value, text}.
const markers = {
  id: "markers",
  afterDatasetsDraw(chart) {
    const ctx = chart.ctx, area = chart.chartArea;
    for (const line of chart.options.markerLines ?? []) {
      const at = chart.scales[line.axis].getPixelForValue(line.value);
      const vertical = line.axis === "x";
      if (vertical ? at < area.left || at > area.right : at < area.top || at > area.bottom) continue;
      ctx.save();
      ctx.strokeStyle = ctx.fillStyle = color(line.color);
      ctx.setLineDash([5, 4]);
      ctx.beginPath();
      ctx.moveTo(vertical ? at : area.left, vertical ? area.top : at);
      ctx.lineTo(vertical ? at : area.right, vertical ? area.bottom : at);
      ctx.stroke();
      ctx.setLineDash([]);
      ctx.font = `12px ${Chart.defaults.font.family}`;
      if (vertical) {
        ctx.translate(at - 5, area.top + 6);
        ctx.rotate(-Math.PI / 2);
        ctx.textAlign = "right";
        ctx.fillText(line.text, 0, 0);
      } else {
        ctx.textAlign = "left";
        ctx.fillText(line.text, area.left + 6, at - 5);
      }
      ctx.restore();
    }
  },
};

const tooltip = () => ({
  backgroundColor: color("card"), borderColor: color("line"), borderWidth: 1, titleColor: color("text"), bodyColor: color("soft"), padding: 10,
  displayColors: false, filter: item => !item.dataset.silent,
  callbacks: {title: items => items[0]?.raw.title ?? "", label: item => item.raw.lines ?? ""},
});

/// A plot in a card. `configure` gives {datasets, x, y, markerLines}; it is asked again when the theme or a control changes.
function plotCard(id, title, footer, configure, low = false) {
  const canvas = element("canvas", {role: "img", "aria-label": title});
  const card = element("article", {class: "card", id},
    element("header", {}, element("h3", {}, title), element("a", {href: "#only=" + id, title: "show this plot as large as the window"}, "enlarge")),
    element("div", {class: low ? "plot low" : "plot"}, canvas), footer ? element("footer", {}, footer) : null);
  const entry = {canvas, configure, chart: null};
  charts.push(entry);
  return card;
}

function drawChart(entry) {
  const c = entry.configure();
  const options = {
    scales: {x: c.x, y: c.y}, markerLines: c.markerLines ?? [], interaction: {mode: "nearest", intersect: true},
    layout: {padding: {right: 8}},
    plugins: {tooltip: tooltip(), legend: {display: Boolean(c.legend), position: "bottom", labels: {color: color("text"), usePointStyle: true, pointStyle: "line", boxWidth: 30, font: {size: 12.5}}}},
  };
  entry.chart?.destroy();
  entry.chart = new Chart(entry.canvas, {type: "scatter", data: {datasets: c.datasets}, options, plugins: [whiskers, markers]});
}

const drawCharts = () => charts.forEach(drawChart);

function methodSet(method, points, extra = {}) {
  const shape = shapeOf(method), own = color(method);
  return {
    label: method, data: points, showLine: true, borderColor: own, borderWidth: 1.6, whiskers: true, hidden: hidden.has(method),
    pointStyle: shape, pointRadius: p => p.raw?.front ? 6.5 : 4.5, pointHoverRadius: 8, pointBorderWidth: p => strokeOnly(shape) ? 2 : p.raw?.front ? 1.5 : 1,
    pointBorderColor: p => p.raw?.front && !strokeOnly(shape) ? color("text") : own, pointBackgroundColor: p => p.raw?.hollow ? color("card") : own, clip: 12, ...extra,
  };
}

/// Symbols and names of the methods; a click hides a method in all plots.
function legend(names) {
  return element("div", {class: "legend", role: "group", "aria-label": "methods"}, ...names.map(method => {
    const symbol = element("canvas", {width: 28, height: 28, style: "width:14px;height:14px"});
    symbols.push({symbol, method});
    return element("button", {type: "button", "aria-pressed": String(!hidden.has(method)), title: "show or hide", onclick: event => {
      hidden.has(method) ? hidden.delete(method) : hidden.add(method);
      document.querySelectorAll(".legend button").forEach(b => { if (b.textContent === method) b.setAttribute("aria-pressed", String(!hidden.has(method))); });
      drawCharts();
    }}, symbol, method);
  }));
}
const symbols = [];

function drawSymbols() {
  for (const {symbol, method} of symbols) {
    const ctx = symbol.getContext("2d");
    ctx.clearRect(0, 0, 28, 28);
    ctx.strokeStyle = ctx.fillStyle = color(method);
    ctx.lineWidth = 4;
    Chart.helpers.drawPoint(ctx, {pointStyle: shapeOf(method), radius: 9, borderWidth: 4, rotation: 0}, 14, 14);
  }
}

// --- head ------------------------------------------------------------------------------------------------------------------------

const contents = element("nav", {"aria-label": "contents"});
const machine = report.machine;
page.append(element("div", {},
  element("h1", {}, report.cases.length > 0 ? "Filtering methods: error against run time" : "Mirrorball report"),
  element("p", {class: "soft"}, [
    machine.date.slice(0, 16).replace("T", " ") + " UTC",
    ...(report.cases.length > 0 ? [count(report.probes.length, "probe"), count(new Set(report.cases.map(c => c.lobe)).size, "lobe"), `${report.target.kind} map of ${report.target.width} × ${report.target.height} texels`] : []), count(report.threads, "thread"), machine.processor || "unknown processor",
    `Mirrorball ${report.version}`].join("  ·  ")),
  report.complete ? null : element("p", {class: "notice"}, "This report was stopped before it was complete: it holds what had been measured until then."),
  contents));

if (report.conclusions.length > 0)
  section("conclusions", "What to conclude", element("ul", {class: "conclusions"}, ...report.conclusions.map(c => element("li", {}, c))));

if (report.probes.length > 0) section("probes", "Probes", element("div", {class: "probes"}, ...report.probes.map(p => element("figure", {},
  element("img", {src: p.picture, alt: "the probe " + baseName(p.name)}),
  element("figcaption", {}, element("b", {}, baseName(p.name)), element("br"), `${p.width} × ${p.height}, brightest ${figure(p.max_luminance)}, mean ${figure(p.mean_luminance)}`,
    element("br"), `brightest 0.01 % of the texels hold ${figure(100 * p.sun_share)} % of the energy`,
    p.resampling_error > 0 ? ` · resampled to latlong at rel_rms ${figure(p.resampling_error, 2)}` : "")))));

// --- error against run time ------------------------------------------------------------------------------------------------------

const errors = {rel_rms: "relative RMS error (rel_rms)", p99_rel: "99th percentile of relative error (p99_rel)", max_abs: "largest error over RMS (max_abs)"};
const shown = {error: "rel_rms", time: "seconds", predicted: false};
const measured = m => m.state === "measured";
const allMeasured = report.cases.flatMap(c => c.measurements.filter(measured));

function lines(m) {
  const t = m.seconds;
  return [
    `${time(t.median)} first lobe` + (t.runs > 1 ? ` (${time(t.shortest)} to ${time(t.longest)}, ${t.runs} runs)` : m.scaled ? " (scaled from a part)" : " (one run)") +
      (t.cpu === null ? "" : `, ${time(t.cpu)} of CPU`),
    m.next_lobe_seconds.runs ? `${time(m.next_lobe_seconds.median)} next lobe` : "",
    `rel_rms ${figure(m.rel_rms)}   p99_rel ${figure(m.p99_rel)}   max_abs ${figure(m.max_abs)}`,
    `predicted: rel_rms ${figure(m.predicted_error)}, ${time(m.predicted_seconds)}`,
    `peak memory ${bytes(m.peak_bytes)}   energy ${figure(m.energy, 6)}`,
    m.method === "auto" ? `chose ${m.ran}` : "", m.band_limit ? `band limit ${m.band_limit}` : "",
    m.filtered ? "" : "lobe unresolved by the probe: a lookup", m.on_front ? "on the Pareto front" : "",
  ].filter(Boolean);
}

const floorOf = values => { const good = values.filter(v => isNumber(v) && v > 0); return good.length ? Math.min(...good) : 1e-7; };

/// Points of a case's front: no other method is both faster and more accurate. auto repeats another method, the reference has no error.
function front(points) {
  const best = [];
  for (const p of points.filter(p => p.m.method !== "auto").sort((a, b) => a.x - b.x || a.y - b.y))
    if (best.length === 0 || p.y < best[best.length - 1].y) best.push(p);
  return best;
}

function errorTimePlot(c) {
  const key = shown.error, clock = shown.time;
  const others = allMeasured.filter(m => m.method !== "reference");
  const floor = floorOf(others.map(m => m[key]));
  const reference = c.measurements.find(m => m.method === "reference" && measured(m));
  const points = c.measurements.filter(m => measured(m) && m.method !== "reference" && m[clock].runs > 0).map(m => ({
    x: m[clock].median, y: Math.max(m[key] ?? floor, floor), low: m[clock].shortest, high: m[clock].longest, m,
    title: `${m.method}${m.setting ? " · " + m.setting : ""}`, lines: lines(m),
  }));
  const best = front(points);
  best.forEach(p => p.front = true);
  // A line joins settings of one knob: the two variants of the paraboloid are not.
  const variant = p => p.m.method === "paraboloid" ? p.m.setting.split(" ")[0] : "";
  const sets = methods.flatMap(name => {
    const own = points.filter(p => p.m.method === name).sort((a, b) => a.x - b.x);
    return [...new Set(own.map(variant))].map(v =>
      methodSet(name, own.filter(p => variant(p) === v), name === "auto" ? {showLine: false, order: -1} : {showLine: name !== "mip"}));
  });
  sets.push({label: "Pareto front", data: best.map(p => ({x: p.x, y: p.y})), silent: true, showLine: true, stepped: "before", borderColor: color("front"),
    borderWidth: 9, borderJoinStyle: "round", borderCapStyle: "round", pointRadius: 0, pointHoverRadius: 0, order: 10});
  if (shown.predicted)
    for (const p of points)
      if (p.m.predicted_error > 0 && p.m.predicted_seconds > 0 && p.m.method !== "auto" && !hidden.has(p.m.method))
        sets.push({data: [{x: p.x, y: p.y}, {x: p.m.predicted_seconds, y: p.m.predicted_error, title: p.title + " · predicted", lines: p.lines}], showLine: true, borderColor: color(p.m.method),
          borderWidth: 1, borderDash: [2, 3], pointRadius: q => q.dataIndex === 1 ? 3.5 : 0, pointStyle: "circle", pointBackgroundColor: color("card"), pointBorderColor: color(p.m.method), order: 5});
  const times = allMeasured.filter(m => m[clock].runs > 0).flatMap(m => [m[clock].shortest, m[clock].longest]);
  return {
    datasets: sets,
    x: axis(clock === "seconds" ? "run time, first lobe of a probe (median)" : "run time, a further lobe of the same probe (median)", timeText, decades(times)),
    y: axis(errors[key], powerText, decades(others.map(m => Math.max(m[key] ?? floor, floor)).concat(report.tolerance))),
    markerLines: [{axis: "y", value: report.tolerance, text: key === "rel_rms" ? `tolerance ${figure(report.tolerance)}` : "", color: "soft"}]
      .filter(l => l.text)
      .concat(reference && !hidden.has("reference") ? [{axis: "x", value: reference.seconds.median, text: `reference ${time(reference.seconds.median)}`, color: "reference"}] : []),
  };
}

if (report.cases.length > 0) {
  const choose = (label, options, set) => element("label", {}, label, element("select", {onchange: event => { set(event.target.value); drawCharts(); }},
    ...Object.entries(options).map(([value, text]) => element("option", {value}, text))));
  const used = methods.filter(name => report.cases.some(c => c.measurements.some(m => m.method === name && measured(m))));
  const controls = element("div", {class: "controls"}, legend(used),
    choose("error", errors, v => shown.error = v),
    choose("time", {seconds: "first lobe of a probe", next_lobe_seconds: "a further lobe"}, v => shown.time = v),
    element("label", {}, element("input", {type: "checkbox", onchange: event => { shown.predicted = event.target.checked; drawCharts(); }}), "predictions"));
  const grid = element("div", {class: "grid"});
  report.cases.forEach((c, i) => {
    const absent = c.measurements.filter(m => m.state === "refused" || m.state === "failed");
    const reasons = [...new Set(absent.map(m => m.method))];
    const leftOut = c.measurements.filter(m => m.state === "left-out").length;
    grid.append(plotCard("case-" + i, `${c.lobe}  ·  ${probeName(c.probe)}`,
      `Error against the reference sum at ${c.reference_complete ? "all" : c.reference_directions} texels of the map.` +
      (leftOut ? ` ${count(leftOut, "setting")} left out.` : "") + (reasons.length ? ` Refused: ${reasons.join(", ")}.` : ""), () => errorTimePlot(c)));
  });
  section("error-time", "Error against run time",
    element("p", {class: "soft"}, "Every point is one setting of a method; whiskers span the repeated runs. The band and the outlined symbols are the Pareto front: " +
      "no other method is both faster and more accurate. Down and to the left is better. Click a method to hide it, hover a point for its figures."),
    controls, grid);
}

// --- verdicts --------------------------------------------------------------------------------------------------------------------

if (report.verdicts.length > 0)
  section("verdicts", `auto at rel_rms ${figure(report.tolerance)}`,
    element("p", {class: "soft"}, "auto against the fastest setting of any method that meets the tolerance, and spectral against sampling and summing at equal error. " +
      "Times for an error between two settings are interpolated on logarithms; “≥” means that sampling did not get there in the time it was given."),
    sortableTable([
      {title: "lobe", value: v => v.lobe}, {title: "probe", value: v => probeName(v.probe)},
      {title: "auto chose", value: v => v.auto_ran}, {title: "rel_rms", kind: "number", value: v => v.auto_error, text: v => figure(v.auto_error, 2), className: v => v.meets_tolerance ? "good" : "bad"},
      {title: "time", kind: "number", value: v => v.auto_seconds, text: v => time(v.auto_seconds)},
      {title: "fastest that meets it", value: v => v.fastest ?? "none", text: v => v.fastest ? `${v.fastest}${v.fastest_setting ? ", " + v.fastest_setting : ""}` : "none"},
      {title: "its time", kind: "number", value: v => v.fastest_seconds, text: v => v.fastest ? time(v.fastest_seconds) : "–"},
      {title: "auto / fastest", kind: "number", value: v => v.auto_over_fastest, text: v => figure(v.auto_over_fastest), className: v => v.fastest ? (v.auto_over_fastest <= 1.3 ? "good" : "bad") : null},
      {title: "importance / spectral", kind: "number", value: v => v.importance_ratio, text: v => isNumber(v.importance_ratio) ? (v.importance_ratio_is_bound ? "≥ " : "") + figure(v.importance_ratio) : "–"},
      {title: "reference / spectral", kind: "number", value: v => v.reference_ratio, text: v => figure(v.reference_ratio)},
    ], report.verdicts));

// --- maps and signed errors ------------------------------------------------------------------------------------------------------

const pictured = report.cases.filter(c => c.picture);
if (pictured.length > 0) {
  const parts = [];
  for (const c of pictured) {
    parts.push(element("h3", {}, `${c.lobe}  ·  ${probeName(c.probe)}`), element("div", {class: "pictures"},
      element("figure", {}, element("img", {src: c.picture, alt: `the map of ${c.lobe}`, loading: "lazy"}),
        element("figcaption", {}, element("b", {}, "filtered map"), element("br"), `by ${c.stand_in}, itself rel_rms ${figure(c.stand_in_error, 2)} off the reference`)),
      ...c.measurements.filter(m => m.error_picture).map(m => element("figure", {},
        element("img", {src: m.error_picture, alt: `signed error of ${m.method}`, loading: "lazy"}),
        element("figcaption", {}, element("b", {}, m.method), ` ${m.setting}`, element("br"), `rel_rms ${figure(m.rel_rms, 2)} · `, element("span", {class: "whole"}, `colors to ±${figure(m.error_picture_limit, 1)}`))))));
  }
  section("pictures", "Maps and signed errors",
    element("p", {class: "soft"}, "Each method at its fastest setting that meets the tolerance, else at its most accurate. Red is too bright, blue too dark, in luminance over the map's root mean square; " +
      "the colors end at the limit below each picture. Errors are taken against the map on the left, which stands in for the reference sum."), ...parts);
}

// --- predictions -----------------------------------------------------------------------------------------------------------------

const predictable = report.cases.flatMap(c => c.measurements.filter(m => measured(m) && m.method !== "reference" && m.method !== "auto" && m.filtered).map(m => ({c, m})));
function predictionPlot(predicted, actual, what, text) {
  const points = predictable.filter(({m}) => predicted(m) > 0 && actual(m) > 0);
  const range = decades(points.flatMap(({m}) => [predicted(m), actual(m)]));
  const sets = methods.filter(name => points.some(({m}) => m.method === name)).map(name => methodSet(name,
    points.filter(({m}) => m.method === name).map(({c, m}) => ({x: predicted(m), y: actual(m), title: `${m.method} · ${m.setting} · ${c.lobe} · ${probeName(c.probe)}`, lines: lines(m)})), {showLine: false, whiskers: false}));
  sets.push({data: range.map(v => ({x: v, y: v})), silent: true, showLine: true, borderColor: color("soft"), borderDash: [5, 4], borderWidth: 1, pointRadius: 0, pointHoverRadius: 0, order: 10});
  return {datasets: sets, x: axis("predicted " + what, text, range), y: axis("measured " + what, text, range)};
}
if (predictable.length > 0)
  section("predictions", "Predicted beside measured",
    element("p", {class: "soft"}, "What auto chooses by. On the dashed line the prediction is right; above it the work took longer, or erred more, than predicted."),
    element("div", {class: "grid"},
      plotCard("predicted-error", "Error", null, () => predictionPlot(m => m.predicted_error, m => m.rel_rms, "rel_rms", powerText)),
      plotCard("predicted-time", "Time", null, () => predictionPlot(m => m.predicted_seconds, m => m.seconds.cpu, "CPU time", timeText))));

// --- parameterizations -----------------------------------------------------------------------------------------------------------

report.parameterizations.forEach((study, i) => {
  const palette = ["spectral", "direct", "hierarchical", "importance", "paraboloid", "mip"];
  const dashes = [[], [7, 3], [2, 3], [10, 3, 2, 3], [5, 2], [1, 2]];
  const rows = study.rows;
  const bars = {
    datasets: () => rows.flatMap((r, j) => [["mirror_error", "rect", "mirror lookup"], ["filtered_error", "circle", "filtered lookup"]].map(([key, shape, what]) => ({
      data: [{x: r[key], y: j, title: `${r.kind} · ${what}`, lines: [`rel_rms ${figure(r[key])}`, `${r.width} × ${r.height} texels, ${figure(100 * r.used / r.texels)} % used`]}],
      pointStyle: shape, pointRadius: 6, borderColor: color(palette[j % 6]), backgroundColor: key === "mirror_error" ? color("card") : color(palette[j % 6]), pointBorderWidth: 2}))),
  };
  section("parameterizations" + (i || ""), "Parameterizations at equal texel counts",
    element("p", {class: "soft"}, `On ${probeName(study.probe)}: rel_rms of bilinear lookups at ${study.directions} texels of the probe for the mirror, ` +
      `and at ${study.reference_directions} directions against the reference sum for ${study.lobe}.`),
    element("div", {class: "grid two"},
      plotCard("solid-angle" + i, "Solid angle of a texel over its mean, against the angle from +Z towards +Y", null, () => ({
        legend: true,
        datasets: rows.map((r, j) => ({
          label: r.kind, showLine: true, pointRadius: 0, pointHitRadius: 6, borderColor: color(palette[j % 6]), borderDash: dashes[j % 6], borderWidth: 2,
          data: r.solid_angle.map((v, k) => ({x: 180 * k / (r.solid_angle.length - 1), y: v, title: r.kind, lines: [`${Math.round(180 * k / (r.solid_angle.length - 1))}°: ${figure(v)} of the mean`]})).filter(p => p.y > 0),
        })),
        x: degrees(axis("angle from +Z (degrees)", v => v + "°", [0, 180], "linear")), y: axis("solid angle / mean", figure, decades(rows.flatMap(r => r.solid_angle.filter(v => v > 1e-3)), 1)),
      })),
      plotCard("lookup-error" + i, "Error of lookups", "Hollow squares: mirror. Filled circles: filtered.", () => ({
        datasets: bars.datasets(), x: axis("rel_rms", powerText, decades(rows.flatMap(r => [r.mirror_error, r.filtered_error]))),
        y: {...axis("", v => rows[v]?.kind ?? "", [-0.6, rows.length - 0.4], "linear"), reverse: true, ticks: {color: color("soft"), stepSize: 1, autoSkip: false, callback: v => Number.isInteger(v) ? rows[v]?.kind ?? "" : ""}, afterBuildTicks: scale => { scale.ticks = rows.map((r, k) => ({value: k})); }},
      }))),
    element("p"),
    sortableTable([
      {title: "parameterization", value: r => r.kind}, {title: "image", value: r => r.texels, text: r => `${r.width} × ${r.height}`},
      {title: "texels used", kind: "number", value: r => r.used}, {title: "mirror rel_rms", kind: "number", value: r => r.mirror_error, text: r => figure(r.mirror_error)},
      {title: "mirror p99_rel", kind: "number", value: r => r.mirror_p99, text: r => figure(r.mirror_p99)},
      {title: `${study.lobe} rel_rms`, kind: "number", value: r => r.filtered_error, text: r => figure(r.filtered_error)},
      {title: "largest / smallest texel", kind: "number", value: r => r.density_ratio, text: r => figure(r.density_ratio)},
      {title: "stretch, median", kind: "number", value: r => r.anisotropy_median, text: r => figure(r.anisotropy_median)},
      {title: "stretch, 99 %", kind: "number", value: r => r.anisotropy_p99, text: r => figure(r.anisotropy_p99)},
      {title: "a lookup", kind: "number", value: r => r.lookup_seconds, text: r => time(r.lookup_seconds)},
      {title: "a picture", kind: "number", value: r => r.draw_seconds, text: r => time(r.draw_seconds)},
    ], rows),
    element("p", {class: "soft small"}, "Stretch is the longer over the shorter axis of what a texel stands for, on half of the sphere and on 99 % of it no more. A lookup is bilinear, on one thread" +
      (study.drawn_by ? `; a picture is a sphere that mirrors the map, one lookup a pixel: ${study.drawn_by}.` : ".")));
});

// --- the paraboloid method as published ------------------------------------------------------------------------------------------

if (report.kernels) {
  const k = report.kernels, rate = s => isNumber(s) && s > 0 ? figure(1 / s, 2) : "–";
  const pair = (r, which) => `${r[which].small} / ${r[which].large}`, shrinks = (r, which) => `${r[which].small_shrink} / ${r[which].large_shrink}`;
  section("kernels", "Kernel sizes and frames a second",
    element("p", {class: "soft"}, `Heidrich 2000, section 3.2.5: halves of ${k.half} texels with a border of ${k.border}, the lobe clamped at ${figure(k.clamp)}, kernels of at most ${k.largest_kernel} texels, in the middle of a half and at its rim. ` +
      `A frame filters ${probeName(0)} anew, though the exponent stays` + (k.drawn_by ? `, and draws a sphere that mirrors the map: ${k.drawn_by}.` : "; nothing is drawn.")),
    sortableTable([
      {title: "exponent", kind: "number", value: r => r.exponent, text: r => figure(r.exponent)},
      {title: "kernel", value: r => r.sizes.small, text: r => pair(r, "sizes")}, {title: "published", value: r => r.published_sizes.small, text: r => pair(r, "published_sizes")},
      {title: "shrunk by", value: r => r.sizes.small_shrink, text: r => shrinks(r, "sizes")}, {title: "published", value: r => r.published_sizes.small_shrink, text: r => shrinks(r, "published_sizes")},
      {title: "frames/s, published (SGI O2)", kind: "number", value: r => r.published_frames, text: r => figure(r.published_frames)},
      {title: "frames/s, the two kernels", kind: "number", value: r => 1 / r.blended_seconds, text: r => rate(r.blended_seconds)},
      {title: "frames/s, exact kernels", kind: "number", value: r => 1 / r.exact_seconds, text: r => rate(r.exact_seconds)},
      {title: "frames/s, auto", kind: "number", value: r => 1 / r.auto_seconds, text: r => `${rate(r.auto_seconds)} (${r.auto_ran})`},
    ], k.rows));
}

if (report.distortion.length > 0) {
  const palette = ["spectral", "direct", "hierarchical", "importance", "paraboloid"], dashes = [[], [7, 3], [2, 3], [10, 3, 2, 3], [5, 2]];
  section("distortion", "What happens to circles of a paraboloid map",
    element("p", {class: "soft"}, "Heidrich 2000, figure 12: a circle of the map is brought back to the sphere, where it is a circle again, its middle displaced. Distortion is that displacement over the radius: |a − b| / (a + b), with a and b the angles from the projected middle to the nearer and to the farther side. Lengths are in radii of a half's disc."),
    element("div", {class: "grid two"}, plotCard("distortion-plot", "Distortion against the distance of the circle's middle from the map's", null, () => ({
      legend: true,
      datasets: report.distortion.map((c, j) => ({
        label: `radius ${figure(c.radius)}`, showLine: true, pointRadius: 0, pointHitRadius: 6, borderColor: color(palette[j % 5]), borderDash: dashes[j % 5], borderWidth: 2,
        data: c.distortion.map((v, i) => ({x: i / (c.distortion.length - 1), y: 100 * v, title: `radius ${figure(c.radius)}`, lines: [`distance ${figure(i / (c.distortion.length - 1))}: ${figure(100 * v)} %`]})),
      })),
      x: axis("distance from the middle of the half", figure, [0, 1], "linear"), y: axis("distortion", v => figure(v) + " %", [0, 30], "linear"),
    }), true)));
}

if (report.comparison) {
  const c = report.comparison;
  section("comparison", "Four maps to compare by eye",
    element("p", {class: "soft"}, `Heidrich 2000, figure 13: ${c.lobe} in a paraboloid map of ${c.target.width} × ${c.target.height} texels with a border of ${c.target.border}, of ${probeName(c.probe)}. Errors are against the classic method, on this original.`),
    element("div", {class: "compared"}, ...c.maps.map(m => element("figure", {},
      element("img", {src: m.picture, alt: m.label}),
      element("figcaption", {}, element("b", {}, m.label), ` · ${m.how}`, element("br"), m.seconds > 0 ? time(m.seconds) : "", m.error_picture ? ` · rel_rms ${figure(m.rel_rms, 2)} · p99_rel ${figure(m.p99_rel, 2)}` : ""),
      m.error_picture ? element("img", {src: m.error_picture, alt: `signed error of ${m.label}`}) : null,
      m.error_picture ? element("figcaption", {}, `signed error, colors to ±${figure(m.error_picture_limit, 1)}`) : null))));
}

// --- growth ----------------------------------------------------------------------------------------------------------------------

function growthPlot(axisName, value, spread, xTitle, xText, yTitle, yText) {
  const points = report.growth.filter(p => p.axis === axisName && measured(p) && value(p) > 0);
  return {
    datasets: methods.filter(name => points.some(p => p.method === name)).map(name => methodSet(name, points.filter(p => p.method === name).map(p => ({
      x: p.at, y: value(p), front: p.streamed, hollow: !p.filtered, title: `${name} · ${xText(p.at)}`,
      lines: [time(p.seconds.median) + (p.seconds.runs > 1 ? ` (${time(p.seconds.shortest)} to ${time(p.seconds.longest)})` : ""), `peak memory ${bytes(p.peak_bytes)} beside ${bytes(p.probe_bytes)} of probe`,
        p.method === "auto" ? `chose ${p.ran}` : "", p.streamed ? "streamed: the probe is never held" : "", p.filtered ? "" : "lobe unresolved: a lookup"].filter(Boolean),
    })), {whiskers: false})),
    x: axis(xTitle, xText, axisName === "exponent" ? [1, 1e6] : undefined), y: axis(yTitle, yText, decades(points.map(value))),
  };
}
if (report.growth.length > 0) {
  const powersOfTwo = scale => { scale.ticks = [256, 512, 1024, 2048, 4096, 8192, 16384].filter(v => v >= scale.min && v <= scale.max).map(value => ({value, major: true})); };
  const byWidth = (value, title, text) => { const p = growthPlot("probe-width", value, null, "columns of the probe", String, title, text);
    p.x = {...p.x, min: 220, max: Math.max(...report.growth.filter(g => g.axis === "probe-width").map(g => g.at), 512) * 1.15, afterBuildTicks: powersOfTwo, ticks: {...p.x.ticks, callback: v => String(v)}, grid: {...p.x.grid, color: color("line")}}; return p; };
  const byExponent = (value, title, text) => growthPlot("exponent", value, null, "exponent of the phong lobe", powerText, title, text);
  const seconds = p => p.seconds.median, memory = p => p.peak_bytes;
  const names = methods.filter(name => report.growth.some(p => p.method === name && measured(p)));
  section("growth", "How cost grows",
    element("p", {class: "soft"}, `Each method with its usual knobs at tolerance ${figure(report.tolerance)}, on ${probeName(0)} resampled. Time is that of the first lobe; memory is the peak beside the probe. ` +
      "Outlined symbols are streamed: the probe's rows are made on the fly and never held. Hollow ones are lookups: the lobe is narrower than a texel of the probe."),
    element("div", {class: "controls"}, legend(names)),
    element("div", {class: "grid two"},
      report.growth.some(p => p.axis === "probe-width" && measured(p)) ? plotCard("growth-time-width", `Time against probe width, ${report.growth_lobe}`, null, () => byWidth(seconds, "run time (median)", timeText), true) : null,
      report.growth.some(p => p.axis === "probe-width" && measured(p)) ? plotCard("growth-memory-width", `Memory against probe width, ${report.growth_lobe}`, null, () => byWidth(memory, "peak memory beside the probe", bytesText), true) : null,
      plotCard("growth-time-exponent", "Time against exponent", null, () => byExponent(seconds, "run time (median)", timeText), true),
      plotCard("growth-memory-exponent", "Memory against exponent", null, () => byExponent(memory, "peak memory beside the probe", bytesText), true)));
}

// --- stability -------------------------------------------------------------------------------------------------------------------

if (report.stability.length > 0) {
  const names = [...new Set(report.stability.map(r => r.name))], columns = [...new Set(report.stability.map(r => r.method))];
  const cells = new Map(report.stability.map(r => [r.name + "\n" + r.method, r]));
  const cell = (row, method) => cells.get(row.name + "\n" + method);
  const verdict = r => !r ? "" : r.refused ? "–" : !r.holds ? "✗" : r.promised ? "✓" : "~";
  section("stability", "Extreme cases",
    element("p", {class: "soft"}, "✓ finite, energy kept, a constant kept to 1e-6, and all four promises of the tolerance of 1e-5 kept (rel_rms, median_rel, p99_rel, no negative light). ~ a method that promises none: finite, energy kept, and its rel_rms within what it predicts of itself. – refused, with a reason: it cannot do the case, or not keep the tolerance. ✗ does not hold. Hover for the figures; all of them are in the table below."),
    sortableTable([{title: "case", kind: "wide", value: r => r.name}, ...columns.map(method => ({
      title: method, kind: "mark", value: r => verdict(cell(r, method)), text: r => verdict(cell(r, method)),
      className: r => { const c = cell(r, method); return !c || c.refused ? null : !c.holds ? "bad" : c.promised ? "good" : null; },
      hint: r => { const c = cell(r, method); return !c ? "" : c.refused || (c.holds ? "" : c.failures.join("; ") + "\n") + `rel_rms ${figure(c.rel_rms)}, energy ${figure(c.energy, 6)}, lowest ${figure(c.lowest)}`; },
    }))], names.map(name => ({name}))),
    element("p"),
    sortableTable([
      {title: "case", kind: "wide", value: r => r.name}, {title: "method", value: r => r.method},
      {title: "outcome", value: r => r.refused ? "refused" : !r.holds ? "does not hold" : r.promised ? "holds" : "as foretold", className: r => r.refused ? null : !r.holds ? "bad" : r.promised ? "good" : null},
      {title: "finite", value: r => r.refused ? null : r.finite ? "yes" : "no"},
      {title: "rel_rms", kind: "number", value: r => r.refused ? null : r.rel_rms, text: r => r.refused ? "–" : figure(r.rel_rms)},
      {title: "median_rel", kind: "number", value: r => r.refused ? null : r.median_rel, text: r => r.refused ? "–" : figure(r.median_rel)},
      {title: "p99_rel", kind: "number", value: r => r.refused ? null : r.p99_rel, text: r => r.refused ? "–" : figure(r.p99_rel)},
      {title: "promised", value: r => r.refused ? null : r.promised ? "yes" : "no"},
      {title: "predicted", kind: "number", value: r => r.refused ? null : r.predicted_error, text: r => r.refused ? "–" : figure(r.predicted_error)},
      {title: "energy", kind: "number", value: r => r.refused ? null : r.energy, text: r => r.refused ? "–" : figure(r.energy, 7)},
      {title: "constant off by", kind: "number", value: r => r.refused ? null : r.constant_error, text: r => r.refused ? "–" : figure(r.constant_error)},
      {title: "lowest / largest", kind: "number", value: r => r.refused ? null : r.lowest, text: r => r.refused ? "–" : figure(r.lowest)},
      {title: "why", kind: "wide", value: r => r.refused || r.failures.join("; ")},
    ], report.stability));
}

if (report.shading.length > 0)
  section("shading", "Extreme cases of shading",
    element("p", {class: "soft"}, "Fresnel terms, lambda, the sphere map's rim and painted maps, at many places each, beside a formula of another form and in more digits."),
    sortableTable([
      {title: "family", value: r => r.family}, {title: "case", kind: "wide", value: r => r.name},
      {title: "outcome", value: r => r.holds ? "holds" : "does not hold", className: r => r.holds ? "good" : "bad"},
      {title: "places", kind: "number", value: r => r.places, text: r => String(r.places)},
      {title: "error", kind: "number", value: r => r.error, text: r => figure(r.error)},
      {title: "bound", kind: "number", value: r => r.bound, text: r => figure(r.bound)},
      {title: "why", kind: "wide", value: r => r.failures.join("; ")},
    ], report.shading));

// --- all measurements ------------------------------------------------------------------------------------------------------------

const rows = report.cases.flatMap(c => c.measurements.map(m => ({c, m})));
if (rows.length > 0) {
  const ok = ({m}) => measured(m);
  const number = (title, get, text, className) => ({title, kind: "number", value: r => ok(r) ? get(r.m) : null, text: r => ok(r) ? text(get(r.m)) : "–", className});
  const table = sortableTable([
    {title: "probe", value: r => probeName(r.c.probe)}, {title: "lobe", value: r => r.c.lobe}, {title: "method", value: r => r.m.method},
    {title: "setting", value: r => r.m.setting, hint: r => r.m.command},
    number("time", m => m.seconds.median, time), number("shortest", m => m.seconds.shortest, time), number("longest", m => m.seconds.longest, time), number("CPU", m => m.seconds.cpu ?? NaN, time), number("runs", m => m.seconds.runs, String),
    number("next lobe", m => m.next_lobe_seconds.runs ? m.next_lobe_seconds.median : NaN, time), number("predicted", m => m.predicted_seconds, time),
    number("memory", m => m.peak_bytes, bytes),
    number("rel_rms", m => m.rel_rms, figure), number("predicted", m => m.predicted_error, figure), number("median_rel", m => m.median_rel, figure), number("p99_rel", m => m.p99_rel, figure), number("max_abs", m => m.max_abs, figure),
    number("energy", m => m.energy, v => figure(v, 6)), number("seam", m => m.seam_ratios[0], figure),
    {title: "seam, by level", value: r => ok(r) ? Math.max(...r.m.seam_ratios) : null, text: r => ok(r) ? r.m.seam_ratios.map(v => figure(v, 2)).join("  ") : "–"},
    {title: "front", kind: "mark", value: r => ok(r) && r.m.on_front ? "●" : ""},
    {title: "remark", kind: "wide", value: r => [r.m.state === "measured" ? "" : r.m.state, r.m.why, r.m.scaled ? "time scaled from a part of the texels" : ""].filter(Boolean).join(": ")},
  ], rows);
  const search = element("input", {type: "search", placeholder: "filter: words of probe, lobe, method", "aria-label": "filter the table", size: 36, oninput: event => {
    const wanted = event.target.value.toLowerCase().split(/\s+/).filter(Boolean);
    table.show(rows.filter(r => { const text = `${probeName(r.c.probe)} ${r.c.lobe} ${r.m.method} ${r.m.setting} ${r.m.state}`.toLowerCase(); return wanted.every(w => text.includes(w)); }));
  }});
  section("measurements", "All measurements",
    element("p", {class: "soft"}, "Click a heading to sort. “Seam” is the change of the map across the seams of its charts over the change just inside them, for the map and for maps of half its size and less; about 1 means that no seam can be seen. Hover a setting for the command that makes its map."),
    element("p", {}, search), table);
}

// --- how -------------------------------------------------------------------------------------------------------------------------

const facts = Object.entries({
  processor: machine.processor, cores: `${machine.cores}, ${count(report.threads, "thread")} used`, memory: bytes(machine.memory_bytes), system: machine.system,
  compiler: `${machine.compiler}, ${machine.build}`, "graphics (paraboloid)": report.device || "none given",
  load: `${figure(machine.load)} processes at the start, ${figure(report.load_at_end)} at the end`, "time of the report": `${time(report.seconds)}, foretold ${time(report.parts.reduce((sum, p) => sum + p.foretold_seconds, 0))}: ` +
    report.parts.map(p => `${p.part} ${time(p.seconds)} (${time(p.foretold_seconds)})`).join(", "),
}).flatMap(([k, v]) => [element("dt", {}, k), element("dd", {}, v || "not told by the system")]);
section("how", "How this was measured",
  element("dl", {}, ...facts),
  element("p", {class: "soft"}, "The command:"), element("pre", {}, element("code", {}, report.command)),
  element("p", {}, `Times are wall times of the work itself, the probe in memory and the map left in memory: the median of up to ${count(report.repeats, "run")} after one to warm up; work of over half a second is repeated only while the runs take less than ${figure(report.longest)} s, its first run counted. ` +
    `A setting predicted to take longer than ${figure(report.longest)} s is left out. “First lobe” starts from the probe alone, so it includes the spectrum or the pyramid; “next lobe” finds them made.`),
  element("p", {}, "Peak memory is what the process held at most during a run above what it held before: freed pages are given back to the system and the kernel's high-water mark is reset before each (Linux, /proc/self/clear_refs). The probe, in memory throughout, is not in it; neither is memory of a graphics card."),
  element("p", {}, "Errors are against the brute-force sum over every texel of the probe, in double precision. Where that would take minutes it is summed at a part of the map's texels: those that hold a Fibonacci lattice of directions, which lie evenly on the sphere, so each stands for an equal solid angle. " +
    "The largest error also looks around the brightest direction and at the cube's axes, edges and corners; between those it may miss a peak. The reference's own time is that of its sums, scaled to all texels."),
  ...(rows.length === 0 ? [] : [element("p", {}, "To make one of the maps again, such as the first:"), element("pre", {}, element("code", {}, rows[0].m.command))]),
  element("p", {class: "soft small"}, "Plots by Chart.js 3 (MIT license; its text stands in the source of this page). This page makes no request of the network."));

// --- one plot alone, themes ------------------------------------------------------------------------------------------------------

/// "#only=ID" in the address shows one plot, as large as the window.
function showAlone() {
  const card = location.hash.startsWith("#only=") ? document.getElementById(location.hash.slice(6)) : null;
  document.querySelectorAll(".card").forEach(c => c.classList.toggle("shown", c === card));
  document.querySelectorAll(".card header a").forEach(link => {
    const alone = link.closest(".card") === card;
    link.textContent = alone ? "all plots" : "enlarge";
    link.href = alone ? "#error-time" : "#only=" + link.closest(".card").id;
  });
  document.body.classList.toggle("alone", card !== null);
}
window.addEventListener("hashchange", showAlone);
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => { drawSymbols(); drawCharts(); });
showAlone();
drawSymbols();
drawCharts();
document.documentElement.dataset.charts = charts.length;
document.documentElement.dataset.state = "ready";
