// Says below a map which target the cell below the pointer is, and how each solver fared there.
(() => {
  'use strict';
  for (const numbers of document.querySelectorAll('script.pointer')) {
    const map = JSON.parse(numbers.textContent);
    const figure = numbers.closest('figure'), picture = figure.querySelector('img'), text = figure.querySelector('p.pointer');
    const cell = (across, up) => `${Math.round((across - map.places[0][0]) / map.step)} ${Math.round((up - map.places[0][1]) / map.step)}`;
    const places = new Map(map.places.map(([across, up], index) => [cell(across, up), index]));
    const waiting = 'Point at a cell for its target and its result.';
    text.textContent = waiting;
    text.hidden = false;

    const result = value => {
      if (value === null) return 'has not solved it yet';
      if (map.directions > 1) return `solves ${value} of ${map.directions} tool directions`;
      if (value === 0) return 'does not solve it';
      return value < 0 ? 'solves it, evaluations not counted' : `solves it with ${value} evaluations`;
    };
    function at(event) {
      const box = picture.getBoundingClientRect(), style = getComputedStyle(picture);
      const [left, right, bottom] = ['paddingLeft', 'paddingRight', 'paddingBottom'].map(side => parseFloat(style[side]));
      const width = box.width - left - right;
      const x = (event.clientX - box.left - left) / width, y = (box.bottom - bottom - event.clientY) / width;
      const panel = map.panels.find(each => x >= each.left && x <= each.left + each.size && y >= each.below && y <= each.below + each.size);
      if (!panel) return waiting;
      const across = map.low[0] + (x - panel.left) / panel.size * map.side, up = map.low[1] + (y - panel.below) / panel.size * map.side;
      const index = places.get(cell(across, up));
      const where = ([along, above]) => `${map.axes[0]} = ${along.toFixed(3)} m, ${map.axes[1]} = ${above.toFixed(3)} m`;
      if (index === undefined) {
        const isBeyond = Math.hypot(across - map.low[0] - map.side / 2, up - map.low[1] - map.side / 2) > map.reach;
        const why = isBeyond ? 'certainly out of reach' : map.blank;
        return `${where([across, up])}: no target${why ? `; ${why}` : ''}.`;
      }
      const target = map.places[index];
      return `${where(target)}, target ${target[2]}: ${panel.label} ${result(panel.values[index])}. ${
        map.panels.filter(each => each !== panel).map(each => `${each.label} ${result(each.values[index])}.`).join(' ')}`;
    }
    picture.addEventListener('pointermove', event => { text.textContent = at(event); });
    picture.addEventListener('pointerdown', event => { text.textContent = at(event); });
  }
})();
