// What the page does beyond showing: tables that sort, folds that open, contents that say where the reader is.
'use strict';
(() => {
  const all = (selector, within = document) => [...within.querySelectorAll(selector)];
  const plain = text => { try { return decodeURIComponent(text); } catch { return text; } };

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
    [...table.tHead.rows[0].cells].forEach((head, column) => {
      const button = document.createElement('button');
      button.type = 'button';
      button.append(...head.childNodes);
      head.append(button);
      button.addEventListener('click', () => {
        const direction = head.getAttribute('aria-sort') === 'ascending' ? -1 : 1;
        sort(table, column, direction);
      });
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
    const element = document.getElementById(plain(location.hash.slice(1)));
    for (let at = element; at; at = at.parentElement) if (at.tagName === 'DETAILS') at.open = true;
    element?.scrollIntoView();
  }
  addEventListener('hashchange', go);
  go();

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
