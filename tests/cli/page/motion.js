const place = document.getElementById('place'), play = document.getElementById('play'), select = document.querySelector('.view select');
const told = () => document.querySelector('.view p').textContent;
const words = [document.querySelectorAll('#stage canvas').length, document.getElementById('stage').hidden];
const to = point => { place.value = point; place.dispatchEvent(new Event('input')); };
for (const point of [1, 2]) { to(point); words.push(told().startsWith(`Target ${point}:`)); }
words.push(play.textContent);
play.click();
words.push(play.textContent);
select.value = select.options[1].value;
select.dispatchEvent(new Event('change'));
return [...words, told().startsWith('Target')].join(' ');
