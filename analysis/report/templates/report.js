// What the page does beyond showing: tables that sort, solvers shown or not everywhere at once, values where a figure is
// pointed at, and an address that keeps all of it. Nothing is loaded.
'use strict';
(() => {
  const all = (selector, within = document) => [...within.querySelectorAll(selector)];
  const plain = text => { try { return decodeURIComponent(text); } catch { return text; } };

  // The address after # is TARGET&off=SOLVER&sort=TABLE.COLUMN.DIRECTION.
  const [first, ...rest] = location.hash.slice(1).split('&');
  const state = new URLSearchParams(rest.join('&'));
  let target = plain(first);
  function remember() {
    const words = state.toString();
    const hash = encodeURIComponent(target) + (words ? '&' + words : '');
    try { history.replaceState(null, '', '#' + hash); } catch { /* a page that has no address */ }
  }

  // Numbers by all their digits, what is empty always last.
  const keyOf = cell => cell.dataset.value ?? cell.textContent.trim();
  const isEmpty = text => text === '' || text === 'not defined';
  const isNumber = text => isEmpty(text) || (text !== '' && !Number.isNaN(Number(text)));
  function sort(table, column, direction) {
    const body = table.tBodies[0], heads = [...table.tHead.rows[0].cells];
    for (const head of heads) head.removeAttribute('aria-sort');
    heads[column].setAttribute('aria-sort', direction > 0 ? 'ascending' : 'descending');
    const rows = [...body.rows].map(row => ({ row, key: keyOf(row.cells[column]) }));
    const numeric = rows.every(({ key }) => isNumber(key));
    const order = numeric ? (a, b) => Number(a) - Number(b)
                          : (a, b) => a.localeCompare(b, undefined, { numeric: true });
    rows.sort((a, b) => isEmpty(a.key) - isEmpty(b.key) || direction * (isEmpty(a.key) ? 0 : order(a.key, b.key)));
    body.append(...rows.map(({ row }) => row));
  }
  for (const table of all('.scroll > table')) {
    if (table.tBodies[0].rows.length < 2) continue;
    const id = table.closest('article').id;
    [...table.tHead.rows[0].cells].forEach((head, column) => {
      const button = document.createElement('button');
      button.type = 'button';
      button.append(...head.childNodes);
      head.append(button);
      button.addEventListener('click', () => {
        const direction = head.getAttribute('aria-sort') === 'ascending' ? -1 : 1;
        sort(table, column, direction);
        const others = state.getAll('sort').filter(each => !each.startsWith(id + '.'));
        state.delete('sort');
        for (const each of [...others, `${id}.${column}.${direction}`]) state.append('sort', each);
        remember();
      });
    });
  }
  for (const each of state.getAll('sort')) {
    const [id, column, direction] = each.split('.');
    const table = document.getElementById(id)?.querySelector('.scroll > table');
    if (table && table.tHead.rows[0].cells[column]) sort(table, Number(column), direction === '-1' ? -1 : 1);
  }

  // A picture's text as a document, in which nothing runs.
  const sources = new Map(all('.frame > .picture').map(image => [image, image.src]));
  const drawings = new Map();
  function drawing(image) {
    if (!drawings.has(image)) {
      const bytes = Uint8Array.from(atob(sources.get(image).split(',')[1]), letter => letter.charCodeAt(0));
      // Its style sheet has another name here, since the page's policy would refuse it.
      const text = new TextDecoder().decode(bytes).replace(/<(\/?)style>/g, '<$1held>');
      drawings.set(image, new DOMParser().parseFromString(text, 'image/svg+xml'));
    }
    return drawings.get(image);
  }
  const seriesOf = image => all('g > title', drawing(image)).map(title => ({ name: title.textContent, group: title.parentNode }));

  // Solvers that are off: their rows, columns and curves go.
  const switches = all('#solvers input');
  const off = new Set();
  const isShared = new Set(switches.map(one => one.closest('label').className)).size < switches.length;
  // What belongs to a curve and has no name (a band, a printed ring) has its colour, while no two solvers share one.
  const colourOf = group => {
    const drawn = group.querySelector('[color^="rgb"], [fill^="rgb"], path[stroke^="rgb"]');
    return drawn && ['color', 'fill', 'stroke'].map(name => drawn.getAttribute(name)).find(value => value?.startsWith('rgb'));
  };
  function hiddenOf(series) {
    const named = series.filter(({ name }) => off.has(name));
    const colours = isShared ? [] : named.map(({ group }) => colourOf(group));
    const others = series.filter(({ name, group }) => !/^[^'"]*$/.test(name) || name === group.id)
      .filter(({ group }) => colours.includes(colourOf(group)));
    return [...named, ...others].map(({ group }) => group);
  }
  function apply() {
    const isOff = cell => off.has(cell.textContent.trim());
    for (const table of all('.scroll > table')) {
      const heads = [...table.tHead.rows[0].cells];
      for (const row of table.tBodies[0].rows) {
        row.hidden = [...row.cells].some(isOff);
        heads.forEach((head, column) => { row.cells[column].hidden = head.hidden = isOff(head); });
      }
    }
    for (const [image, source] of sources) {
      const hidden = off.size === 0 ? [] : hiddenOf(seriesOf(image));
      if (hidden.length === 0) {
        if (image.src !== source) image.src = source;
        continue;
      }
      for (const group of hidden) group.setAttribute('display', 'none');
      image.src = 'data:image/svg+xml,' + encodeURIComponent(new XMLSerializer().serializeToString(drawing(image)).replace(/<(\/?)held>/g, '<$1style>'));
      for (const group of hidden) group.removeAttribute('display');
    }
  }
  for (const input of switches) {
    if (state.getAll('off').includes(input.value)) {
      input.checked = false;
      off.add(input.value);
    }
    input.addEventListener('change', () => {
      if (input.checked) off.delete(input.value);
      else off.add(input.value);
      state.delete('off');
      for (const name of off) state.append('off', name);
      remember();
      apply();
    });
  }
  if (switches.length > 0) document.getElementById('solvers').hidden = false;
  if (off.size > 0) apply();

  // Where a figure is pointed at, or walked through by the arrow keys, it tells the nearest value.
  const told = JSON.parse(document.getElementById('told').textContent);
  function spotsOf(image, series) {
    const drawn = seriesOf(image), spots = [];
    const at = element => /translate\(([-\d.]+),([-\d.]+)\)/.exec(element?.getAttribute('transform') ?? '')?.slice(1).map(Number);
    for (const { series: name, words } of series) {
      const marks = all('use', drawn.find(each => each.name === name)?.group ?? document.createElement('g'));
      if (marks.length === words.length || marks.length === words.length + 1) {  // one more is in the legend
        words.forEach((text, i) => spots.push({ name, text: `${name}, ${text}`, place: at(marks[i]) }));
      }
    }
    return spots.filter(({ place }) => place);
  }
  for (const [image] of sources) {
    const series = told[image.closest('figure').id];
    if (!series) continue;
    const frame = image.parentNode, tip = document.createElement('output'), mark = document.createElement('span');
    tip.className = 'tip';
    mark.className = 'spot';
    tip.hidden = mark.hidden = true;
    frame.append(mark, tip);
    frame.tabIndex = 0;
    frame.setAttribute('role', 'group');
    frame.setAttribute('aria-label', 'Values: arrow keys');
    let spots, chosen = -1;
    const known = () => (spots ??= spotsOf(image, series)).filter(({ name }) => !off.has(name));
    const size = () => drawing(image).documentElement.getAttribute('viewBox').split(' ').slice(2).map(Number);
    function show(spot) {
      tip.hidden = mark.hidden = !spot;
      if (!spot) return;
      const [width, height] = size(), [x, y] = spot.place;
      const left = 100 * x / width, top = 100 * y / height;
      for (const element of [mark, tip]) {
        element.style.left = `${element === tip ? Math.min(Math.max(left, 25), 75) : left}%`;
        element.style.top = `${top}%`;
      }
      tip.textContent = spot.text;
    }
    frame.addEventListener('pointermove', event => {
      const box = image.getBoundingClientRect(), [width] = size(), scale = width / box.width;
      const x = (event.clientX - box.left) * scale, y = (event.clientY - box.top) * scale;
      let best = null, least = 15;  // points of the picture
      for (const spot of known()) {
        const distance = Math.hypot(spot.place[0] - x, spot.place[1] - y);
        if (distance < least) [best, least] = [spot, distance];
      }
      show(best);
    });
    frame.addEventListener('pointerleave', () => show(null));
    frame.addEventListener('blur', () => show(null));
    frame.addEventListener('keydown', event => {
      const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key], list = known();
      if (event.key === 'Escape') show(null);
      if (!step || list.length === 0) return;
      event.preventDefault();
      chosen = (chosen + step + list.length) % list.length;
      show(list[chosen]);
    });
  }

  // On paper nothing can be unfolded: what is before everything else is open there, but for the long summary.
  const end = document.getElementById('rest');
  const isBefore = details => !end || (details.compareDocumentPosition(end) & Node.DOCUMENT_POSITION_FOLLOWING) !== 0;
  let unfolded = [];
  addEventListener('beforeprint', () => {
    unfolded = all('main details:not([open], .summary, .again)').filter(isBefore);
    for (const details of unfolded) details.open = true;
  });
  addEventListener('afterprint', () => {
    for (const details of unfolded) details.open = false;
  });

  // A printed page has what is open, so all of it can be opened at once.
  const open = document.getElementById('open');
  if (open && all('main details').length > 0) {
    open.hidden = false;
    const button = open.querySelector('button');
    button.addEventListener('click', () => {
      const closes = button.textContent === 'Close everything';
      for (const details of all('main details')) details.open = !closes;
      button.textContent = closes ? 'Open everything' : 'Close everything';
    });
  }

  // On a narrow screen the contents would push the verdict off it.
  if (!matchMedia('(min-width: 75rem)').matches) document.getElementById('contents').open = false;

  // What a link leads to is unfolded.
  function go() {
    const element = document.getElementById(target);
    for (let at = element; at; at = at.parentElement) if (at.tagName === 'DETAILS') at.open = true;
    element?.scrollIntoView();
  }
  addEventListener('hashchange', () => {
    target = plain(location.hash.slice(1).split('&')[0]);
    remember();
    go();
  });
  if (target) go();

  // The contents say where the reader is.
  const links = new Map(all('#contents a').map(link => [link.hash.slice(1), link]));
  const watch = new IntersectionObserver(entries => {
    for (const { target: section, isIntersecting } of entries) {
      const link = links.get(section.id);
      if (isIntersecting) link.setAttribute('aria-current', 'true');
      else link.removeAttribute('aria-current');
    }
  }, { rootMargin: '-20% 0px -75% 0px' });
  for (const id of links.keys()) {
    const section = document.getElementById(id);
    if (section && section.tagName !== 'MAIN') watch.observe(section);
  }
})();
