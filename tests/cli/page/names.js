const cells = new Set([...document.querySelectorAll('#table-results td')].map(cell => cell.textContent));
const mark = "@MARK@";
const names = ['</text></svg><script>' + mark + '<\/script>', '" onload="' + mark, '"><img src=x onerror=' + mark + '>', '{{{title}}} &amp; "'];
return [names.filter(name => cells.has(name)).length,
  document.querySelectorAll('img:not([src^="data:image/svg+xml"]), [onload], [onerror], h1 *, p b, td :not(.pill, i, b)').length].join(' ');
