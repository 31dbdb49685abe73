// Tables that sort by a click on a head: numbers by all their digits, what is empty always last.
'use strict';
(() => {
  const keyOf = cell => cell.dataset.value ?? cell.textContent.trim();
  const isEmpty = text => text === '' || text === 'not defined';
  const isNumber = text => isEmpty(text) || (text !== '' && !Number.isNaN(Number(text)));

  function sort(table, column, direction) {
    const body = table.tBodies[0];
    const rows = [...body.rows].map(row => ({ row, key: keyOf(row.cells[column]) }));
    const numeric = rows.every(({ key }) => isNumber(key));
    const order = numeric ? (a, b) => Number(a) - Number(b)
                          : (a, b) => a.localeCompare(b, undefined, { numeric: true });
    rows.sort((a, b) => isEmpty(a.key) - isEmpty(b.key) || direction * (isEmpty(a.key) ? 0 : order(a.key, b.key)));
    body.append(...rows.map(({ row }) => row));
  }

  for (const table of document.querySelectorAll('.scroll > table')) {
    if (table.tBodies[0].rows.length < 2) continue;
    const heads = [...table.tHead.rows[0].cells];
    heads.forEach((head, column) => {
      const button = document.createElement('button');
      button.type = 'button';
      button.append(...head.childNodes);
      head.append(button);
      button.addEventListener('click', () => {
        const ascending = head.getAttribute('aria-sort') !== 'ascending';
        for (const other of heads) other.removeAttribute('aria-sort');
        head.setAttribute('aria-sort', ascending ? 'ascending' : 'descending');
        sort(table, column, ascending ? 1 : -1);
      });
    });
  }

  // On a narrow screen the contents would push the verdict off it.
  if (!matchMedia('(min-width: 75rem)').matches) document.getElementById('contents').open = false;
  addEventListener('beforeprint', () => { for (const details of document.querySelectorAll('details.summary')) details.open = true; });
})();
