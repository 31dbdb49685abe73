const bottom = selector => document.querySelector(selector).getBoundingClientRect().bottom;
const stage = document.getElementById('stage');
return [document.querySelectorAll('h1').length, bottom('h1') < 200, bottom('#table-results table') < 900,
  !stage || stage.hidden || bottom('#stage .controls') < 900,
  document.querySelectorAll('#table-results tbody tr').length].join(' ');
