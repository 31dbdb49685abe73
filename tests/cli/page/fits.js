const ids = [...document.querySelectorAll('[id]')].map(element => element.id);
const links = [...document.querySelectorAll('a[href^="#"]')].filter(link => !document.getElementById(decodeURIComponent(link.hash.slice(1))));
const broken = [...document.images].filter(image => !image.complete || image.naturalWidth === 0 || image.alt.length < 10);
for (const details of document.querySelectorAll('details')) details.open = true;
const wanted = [...document.querySelectorAll('a, button, input, select, summary, .scroll[tabindex]')].filter(element => element.checkVisibility());
const missed = wanted.filter(element => {
  element.focus();
  return document.activeElement !== element || getComputedStyle(element).outlineStyle === 'none';
});
for (const details of document.querySelectorAll('details')) details.open = false;
const root = document.documentElement;
return [ids.filter((id, i) => ids.indexOf(id) !== i).length, links.length, broken.length, wanted.length > 20, missed.length,
  root.scrollWidth <= root.clientWidth].join(' ');
