#pragma once
// Style and script of a study's page (study_page.cpp).

namespace netpocket {

inline constexpr const char* kStudyPageStyle = R"(
  :root { color-scheme: light; }
  body { font: 16px/1.5 "DejaVu Sans", "Segoe UI", Helvetica, Arial, sans-serif; color: #1a1c21; background: #fff;
         max-width: 1100px; margin: 2rem auto; padding: 0 1.5rem; }
  h1 { font-size: 1.7rem; margin-bottom: 0.2rem; }
  h2 { font-size: 1.2rem; margin-top: 2.4rem; border-bottom: 1px solid #d5d8de; padding-bottom: 0.3rem; }
  .result { font-size: 1.1rem; }
  .note { color: #5a606b; font-size: 0.9rem; }
  figure { margin: 1.4rem 0; }
  figure svg, figure img { max-width: 100%; height: auto; display: block; }
  #chart { display: flex; flex-wrap: wrap; gap: 1.2rem; align-items: flex-start; }
  #map { width: 640px; max-width: 100%; touch-action: manipulation; }
  #map:focus { outline: 2px solid #005bab; }
  #map text { font-size: 13px; fill: #1a1c21; }
  #map .dot { cursor: pointer; }
  #about { min-width: 20rem; flex: 1; font-size: 0.88rem; }
  #about img { width: 100%; max-width: 420px; }
  table { border-collapse: collapse; }
  td { padding: 0.1rem 0.8rem 0.1rem 0; font-variant-numeric: tabular-nums; }
  td + td { text-align: right; }
  .sheet { display: grid; grid-template-columns: repeat(auto-fill, minmax(230px, 1fr)); gap: 1rem; }
  .sheet button { all: unset; cursor: pointer; font-size: 0.85rem; }
  .sheet button:focus-visible { outline: 2px solid #005bab; }
  .sheet img { width: 100%; height: auto; display: block; border: 1px solid #e4e6ea; }
  @media print { figure { break-inside: avoid; } select { border: 0; } }
)";

// `study`: {inputs: [[name, unit, [values]]], measures: likewise, points: [], captured: [1, 0, null], pictures: {row:
// id of an image}}. A hovered or chosen capture is described beside the map; a chosen one stays until another is.
inline constexpr const char* kStudyPageScript = R"JS(
(function () {
  const study = JSON.parse(document.getElementById('data').textContent);
  const map = document.getElementById('map'), about = document.getElementById('about');
  const across = document.getElementById('across'), up = document.getElementById('up');
  const space = 'http://www.w3.org/2000/svg';
  const box = { left: 70, top: 10, width: 550, height: 420 };
  let chosen = null, dots = [];
  const number = v => v === null ? '–' : String(Number(v.toPrecision(4))).replace('-', '\u2212');
  const title = c => c[1] && c[1] !== '1' ? c[0] + ' (' + c[1] + ')' : c[0];
  const outcome = row => study.captured[row] === null ? 'not judged' : study.captured[row] ? 'captured' : 'missed';
  const make = (name, values, text) => {
    const element = document.createElementNS(space, name);
    for (const key in values) element.setAttribute(key, values[key]);
    if (text !== undefined) element.textContent = text;
    map.appendChild(element);
    return element;
  };
  const range = values => {
    const known = values.filter(v => v !== null);
    let low = known.reduce((a, b) => Math.min(a, b), Infinity), high = known.reduce((a, b) => Math.max(a, b), -Infinity);
    if (!(high > low)) { low -= 0.5; high += 0.5; }
    const room = 0.03 * (high - low);
    return [low - room, high + room];
  };
  const ticks = ([low, high]) => {
    const rough = (high - low) / 5, power = Math.pow(10, Math.floor(Math.log10(rough)));
    const step = [1, 2, 5, 10].map(f => f * power).find(s => s >= 0.7 * rough);
    const list = [];
    for (let i = Math.ceil(low / step); i * step <= high; ++i) list.push(i * step);
    return list;
  };
  const describe = row => {
    about.textContent = '';
    const head = document.createElement('p');
    const bold = document.createElement('b');
    bold.textContent = 'Point ' + study.points[row];
    head.append(bold, ': ' + outcome(row));
    about.append(head);
    if (study.pictures[row]) {
      const picture = document.createElement('img');
      picture.src = document.getElementById(study.pictures[row]).src;
      picture.alt = 'The capture of point ' + study.points[row] + ' at its end';
      about.append(picture);
    }
    const table = document.createElement('table');
    for (const column of study.inputs.concat(study.measures)) {
      if (column[2][row] === null) continue;
      const line = table.insertRow();
      line.insertCell().textContent = title(column);
      line.insertCell().textContent = number(column[2][row]);
    }
    about.append(table);
  };
  const choose = row => {
    if (chosen !== null && dots[chosen]) dots[chosen].setAttribute('stroke', study.pictures[chosen] ? '#1a1c21' : 'none');
    chosen = row;
    if (dots[row]) {
      dots[row].setAttribute('stroke', '#000');
      dots[row].setAttribute('stroke-width', 2.5);
      map.appendChild(dots[row]);
    }
    describe(row);
  };
  const draw = () => {
    map.textContent = '';
    dots = [];
    const x = study.inputs[across.value], y = study.inputs[up.value];
    const rx = range(x[2]), ry = range(y[2]);
    const px = v => box.left + (v - rx[0]) / (rx[1] - rx[0]) * box.width;
    const py = v => box.top + box.height - (v - ry[0]) / (ry[1] - ry[0]) * box.height;
    make('rect', { x: box.left, y: box.top, width: box.width, height: box.height, fill: 'none', stroke: '#5a606b' });
    for (const v of ticks(rx)) {
      make('text', { x: px(v), y: box.top + box.height + 18, 'text-anchor': 'middle' }, number(v));
    }
    for (const v of ticks(ry)) make('text', { x: box.left - 6, y: py(v) + 4, 'text-anchor': 'end' }, number(v));
    make('text', { x: box.left + box.width / 2, y: box.top + box.height + 42, 'text-anchor': 'middle' }, title(x));
    make('text', { transform: 'translate(14 ' + (box.top + box.height / 2) + ') rotate(-90)', 'text-anchor': 'middle' },
         title(y));
    study.points.forEach((point, row) => {
      if (study.captured[row] === null || x[2][row] === null || y[2][row] === null) return;
      const dot = make('circle', { cx: px(x[2][row]), cy: py(y[2][row]), r: study.pictures[row] ? 5 : 3.5, class: 'dot',
        fill: study.captured[row] ? '#56b4e9' : '#d55e00', 'fill-opacity': 0.8,
        stroke: study.pictures[row] ? '#1a1c21' : 'none' });
      dot.addEventListener('mouseenter', () => describe(row));
      dot.addEventListener('mouseleave', () => { if (chosen !== null) describe(chosen); });
      dot.addEventListener('click', () => choose(row));
      dots[row] = dot;
    });
    if (chosen !== null) choose(chosen);
  };
  for (const [list, start] of [[across, study.axes[0]], [up, study.axes[1]]]) {
    study.inputs.forEach((column, i) => list.add(new Option(title(column), i)));
    list.value = start;
    list.addEventListener('change', draw);
  }
  map.addEventListener('keydown', event => {
    const way = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (!way || !study.points.length) return;
    event.preventDefault();
    choose(chosen === null ? 0 : (chosen + way + study.points.length) % study.points.length);
  });
  for (const button of document.querySelectorAll('.sheet button')) {
    button.addEventListener('click', () => {
      choose(Number(button.dataset.row));
      document.getElementById('chart').scrollIntoView();
    });
  }
  draw();
})();
)JS";

}  // namespace netpocket
