// How many cells of the first panel of a map have another colour than the pointer's words say, of how many; and the words
// of the last cell that is solved.
const figure = document.getElementById('figure-map'), picture = figure.querySelector('img');
const map = JSON.parse(figure.querySelector('script.pointer').textContent), panel = map.panels[0];
const canvas = document.createElement('canvas');
const inside = picture.clientWidth - 2 * parseFloat(getComputedStyle(picture).paddingLeft);
canvas.width = 2000;
canvas.height = Math.round(2000 * picture.naturalHeight / picture.naturalWidth);
const pen = canvas.getContext('2d', { willReadFrequently: true });
pen.drawImage(picture, 0, 0, canvas.width, canvas.height);
const box = picture.getBoundingClientRect(), edge = (box.width - inside) / 2;
let wrong = 0, last = '';
for (const [across, up] of map.places) {
  const x = panel.left + (across - map.low[0]) / map.side * panel.size, y = panel.below + (up - map.low[1]) / map.side * panel.size;
  picture.dispatchEvent(new PointerEvent('pointermove', { clientX: box.left + edge + x * inside, clientY: box.bottom - edge - y * inside }));
  const words = figure.querySelector('p.pointer').textContent.split('.  ')[0];
  const [red, green, blue] = pen.getImageData(Math.round(2000 * x) + 3, Math.round(canvas.height - 2000 * y) + 2, 1, 1).data;
  const is_grey = red === green && green === blue;
  if (words.includes(`${panel.label} solves it`) === is_grey) ++wrong;
  if (!is_grey) last = words;
}
return `${wrong} of ${map.places.length}; ${last}`;
