const place = document.getElementById('place'), play = document.getElementById('play'), select = document.querySelector('.view select');
const told = () => document.querySelector('.view p').textContent;
const words = [document.querySelectorAll('#stage canvas').length, document.getElementById('stage').hidden];
const to = point => { place.value = point; place.dispatchEvent(new Event('input')); };
for (const point of [1, 2]) { to(point); words.push(told().startsWith(`Target ${point}:`)); }
words.push(play.textContent);
play.click();
words.push(play.textContent);
const outside = [...select.options].map(option => {
  select.value = option.value;
  select.dispatchEvent(new Event('change'));
  let bits = option.text + '=';
  for (let point = 1; point <= Number(place.max); ++point) { to(point); bits += told().includes('Outside its limits') ? 1 : 0; }
  return bits;
});
return [...words, ...outside.sort()].join(' ');
