#!/usr/bin/env bash
# The report in a browser: opened from disk, its names are text, it is short, its tables sort, its arm is
# drawn, and nothing fails silently. Skipped without chromium (./setup --with-browser dev installs
# it). With IKBENCH_REPRODUCTION, the folder of a reproduction, it checks that page instead of a small one.
source "$(dirname "$0")/common.sh"

browser=
for name in chromium chromium-browser google-chrome; do
  if command -v "$name" >/dev/null; then browser=$name && break; fi
done
[ -n "$browser" ] || exit 77

# A page shows SVG alone, so no picture is drawn in other formats.
if command -v gnuplot >/dev/null; then
  mkdir bin
  cat >bin/gnuplot <<E2
#!/usr/bin/env bash
sed '/^set terminal @pdf/,\$d' "\$2" >"svg-\$2" && "$(command -v gnuplot)" -d "svg-\$2" || exit 1
printf '%%%%EOF' >"\${2%.gp}.pdf"
printf 'IEND\xAE\x42\x60\x82' >"\${2%.gp}.png"
E2
  chmod +x bin/gnuplot
  PATH=$work/bin:$PATH
fi

# These would leave a mark on the page, or on a figure opened by itself, if any of it ran.
mark="document.documentElement.setAttribute('marked',1)"
hostile=("</text></svg><script>$mark</script>" "\" onload=\"$mark" "\"><img src=x onerror=$mark>" '{{{title}}} &amp; "')
{
  printf 'name = "<script>%s</script>"\ntitle = "<b>title</b>"\nruns = 2\npopulation = 6\n' "$mark"
  printf '[stop]\niterations = 5\n[path]\npoints = 3\n'
  for label in "${hostile[@]}"; do
    printf '[[solvers]]\nsolver = "bat"\nlabel = "%s"\n' "${label//\"/\\\"}"
  done
} >hostile.toml
succeeds run hostile.toml --out hostile
# One in which the arm leaves its limits.
succeeds run slim2023 --set runs=1 --set stop.iterations=20 --set population=10 --out plain
if [ -n "${IKBENCH_REPRODUCTION:-}" ]; then
  cp -r "$IKBENCH_REPRODUCTION" whole
else
  succeeds reproduce --runs 2 --readings 1 --out whole
fi
# One of somebody's own, without a paper.
cat >own.toml <<'E2'
name = "own"
robot = "ur5e"
search = "all_joints"
bounds = "clamp"
runs = 10
population = 20
[stop]
iterations = 60
[path]
kind = "circle"
centre_cm = [40, 0, 30]
radius_cm = 15
points = 6
[[solvers]]
solver = "particle_swarm"
[[solvers]]
solver = "differential_evolution"
[[solvers]]
solver = "damped_least_squares"
E2
succeeds run own.toml --out own
# A stranger's arm, whose torso slides and some of whose joints turn without end, at poses drawn at random.
cp "$scripts/../data/urdf/fetch.urdf" .
sed -e 's/name = "own"/name = "theirs"/; s/robot = .*/robot = "fetch.urdf"/; s/all_joints/pose/; s/iterations = 60/&\ntolerance_cm = 0.1\ntolerance_deg = 0.5/' \
  -e '/^kind/,/^radius/d; s/^\[path\]/&\nkind = "random"/' own.toml >theirs.toml
printf '[analysis]\nestimands = ["mean"]\n' >>theirs.toml
succeeds run theirs.toml --out theirs
for page in hostile/report.html plain/report.html own/report.html theirs/report.html whole/report.html; do
  [ -s "$page" ] || fail "no $page"
  [ "$(wc -c <"$page")" -lt 3000000 ] || fail "$page has $(wc -c <"$page") bytes"
done

# browse PAGE OPTIONS...: puts what the browser prints into $out, and its messages into $err.
browse() {
  local page=$1 sandbox=()
  shift
  [ "$(id -u)" != 0 ] || sandbox=(--no-sandbox)
  HOME=$work timeout 100 "$browser" --headless=new "${sandbox[@]}" --user-data-dir="$work/.profile" --disable-gpu \
    --use-angle=swiftshader --enable-unsafe-swiftshader --enable-logging=stderr --hide-scrollbars \
    --virtual-time-budget=3000 "$@" "file://$work/$page" >"$work/.out" 2>"$work/.err" </dev/null ||
    fail "$browser failed on $page: $(tail -n 5 "$work/.err")"
  out=$(<"$work/.out") err=$(<"$work/.err")
}

# probe PAGE SCRIPTS -- OPTIONS...: opens a copy of the page with one more script, which its policy allows. Each of the
# SCRIPTS is the body of a function; `found NAME` gives what NAME.js returned. Opens it at $fragment, if that is set.
probe() {
  local page=$1 name hash
  shift
  : >.script
  while [ $# -gt 0 ] && [ "$1" != -- ]; do
    name=$1
    printf "{ const meta = document.createElement('meta'); meta.name = 'found-%s';\nmeta.content = String((() => {\n%s\n})()); document.head.append(meta); }\n" \
      "$name" "$(<"$name.js")" >>.script
    shift
  done
  [ $# = 0 ] || shift
  hash=$(printf "$({ echo; cat .script; } | sha256sum | cut -c 1-64 | sed 's/../\\x&/g')" | base64)
  awk -v hash="'sha256-$hash'" '
    /Content-Security-Policy/ { sub(/script-src /, "script-src " hash " ") }
    /^<\/body>/ {
      print "<script>"
      while ((getline line < ".script") > 0) print line
      printf "</script>\n"
    }
    { print }' "$page" >"${page%.html}-probed.html"
  browse "${page%.html}-probed.html${fragment:-}" "$@" --dump-dom
  # A graphics driver's message about its speed is no fault of the page.
  ! grep ':CONSOLE' "$work/.err" | grep -v 'GL Driver Message' || fail "$page: the console has the above"
}
found() {
  sed -n "s/.*<meta name=\"found-$1\" content=\"\([^\"]*\)\".*/\1/p" "$work/.out"
}
# expect NAME WORDS WHAT: checks what NAME.js returned.
expect() {
  [ "$(found "$1")" = "$2" ] || fail "$3: $(found "$1"), expected $2"
}

# Names are text, in tables, figures and headings: no element of their making.
cat >names.js <<E2
const cells = new Set([...document.querySelectorAll('#results td')].map(cell => cell.textContent));
const mark = "$mark";
const names = ['</text></svg><script>' + mark + '<\\/script>', '" onload="' + mark, '"><img src=x onerror=' + mark + '>', '{{{title}}} &amp; "'];
return [names.filter(name => cells.has(name)).length, document.querySelectorAll('img:not(.picture), [onload], [onerror], h1 b').length,
  document.querySelector('h1').textContent.length].join(' ');
E2
probe hostile/report.html names
expect names "4 0 12" "names in the table, strange elements, letters of the title"
has_no "$out" ' marked='

# A figure that a reader opens by itself runs nothing either; a drawing that runs something is seen.
if command -v gnuplot >/dev/null; then
  grep -q 'onload' hostile/figures/error.svg || fail "the figure of the error shows no hostile name"
  svg="<svg xmlns='http://www.w3.org/2000/svg'><script>$mark</script></svg>"
  printf '%s' "$svg" >drawing.svg
  cat >frames.html <<'E2'
<!DOCTYPE html><iframe src="hostile/figures/error.svg"></iframe><iframe src="hostile/figures/error-boxes.svg"></iframe>
<iframe src="drawing.svg"></iframe>
<script>onload = () => { document.title = [...document.querySelectorAll('iframe')].map(frame => {
  const root = frame.contentDocument.documentElement;
  return root.tagName + (root.hasAttribute('marked') ? ' marked' : '');
}).join(', '); };</script>
E2
  browse frames.html --allow-file-access-from-files --dump-dom
  has "$out" '<title>svg, svg, svg marked</title>'
fi

# In the page a drawing is an image and runs nothing; nor does anything from outside the page. The console says so,
# which shows that the checks above can see something.
awk -v svg="$(printf '%s' "${svg:-}" | base64 -w 0)" '
  { sub(/svg\+xml;base64,[^"]*/, "svg+xml;base64," svg); sub(/^<\/body>/, "<script>document.title = \"run\"</script></body>"); print }' \
  plain/report.html >plain/other.html
browse plain/other.html --dump-dom
has_no "$out" ' marked='
has "$err" "CONSOLE"
has_no "$out" "<title>run</title>"

# A table sorts by all digits, up and down, and says so.
cat >sort.js <<'E2'
const head = document.querySelectorAll('#table-3 th')[2];
const values = () => [...document.querySelectorAll('#table-3 tbody tr')].map(row => Number(row.cells[2].dataset.value));
const ordered = (list, sign) => list.every((x, i) => i === 0 || sign * (x - list[i - 1]) >= 0);
const words = [values().length, ordered(values(), 1)];
head.querySelector('button').click();
words.push(head.getAttribute('aria-sort'), ordered(values(), 1));
head.querySelector('button').click();
words.push(head.getAttribute('aria-sort'), ordered(values(), -1));
return words.join(' ');
E2

# Ids are there once, every link inside the page leads somewhere, every picture is there and has words, and what the page
# offers to take along is there.
cat >links.js <<'E2'
const ids = [...document.querySelectorAll('[id]')].map(element => element.id);
const links = [...document.querySelectorAll('a[href^="#"]')].filter(link => !document.getElementById(link.hash.slice(1)));
const broken = [...document.images].filter(image => !image.complete || image.naturalWidth === 0 || image.alt.length < 10);
const files = new Set([...document.querySelectorAll('.downloads a')].map(link => link.textContent));
return [ids.filter((id, i) => ids.indexOf(id) !== i).join(','), links.length, broken.length,
  ['store.sqlite', 'solves.csv', 'statistics.json'].every(name => files.has(name)),
  document.documentElement.scrollWidth <= document.documentElement.clientWidth].join(' ');
E2

# It is read in two minutes: what is shown has at most 3000 words and 12 screens, and its first lines at most 125 words beside
# the claims, each of which is one line, and the warnings, which a busy machine may add to.
cat >length.js <<'E2'
const isShown = element => element.checkVisibility({ checkVisibilityCSS: true }) && element.getClientRects().length > 0;
const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
let words = 0, first = 0;
while (texts.nextNode()) {
  const parent = texts.currentNode.parentElement;
  if (['SCRIPT', 'STYLE'].includes(parent.tagName) || !isShown(parent)) continue;
  const count = texts.currentNode.textContent.split(/\s+/).filter(word => word !== '').length;
  words += count;
  if (parent.closest('header') && !parent.closest('.claims, .warnings')) first += count;
}
const claims = [...document.querySelectorAll('.claims li')].map(claim => claim.getBoundingClientRect());
const cut = [...document.querySelectorAll('.claims :is(.claim, .word, .number)')].filter(part => part.scrollWidth > part.clientWidth);
return [words, Math.ceil(document.documentElement.scrollHeight / 900), first, claims.length,
  Math.round(Math.max(...claims.map(box => box.height))), Math.round(Math.max(...claims.map(box => box.bottom))), cut.length].join(' ');
E2
cat >accurate.js <<'E2'
const claim = [...document.querySelectorAll('.claims summary')].find(each => each.textContent.startsWith('IK-BA is the most accurate'));
return [...claim.children].map(part => part.textContent).join('|').replaceAll(/\d+ %/g, 'N %');
E2

# Every text can be read on its ground, in light and in dark (WCAG 2.1: 4.5; large and quiet parts 3).
cat >contrast.js <<'E2'
const canvas = document.createElement('canvas').getContext('2d', { willReadFrequently: true });
const rgba = colour => {
  canvas.clearRect(0, 0, 1, 1);
  canvas.fillStyle = colour;
  canvas.fillRect(0, 0, 1, 1);
  return [...canvas.getImageData(0, 0, 1, 1).data];
};
const linear = c => (c / 255 <= 0.04045 ? c / 255 / 12.92 : ((c / 255 + 0.055) / 1.055) ** 2.4);
const luminance = ([r, g, b]) => 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);
const contrast = (a, b) => (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
const groundOf = element => {
  for (let at = element; at; at = at.parentElement) {
    const colour = rgba(getComputedStyle(at).backgroundColor);
    if (colour[3] === 255) return luminance(colour);
  }
  return 1;
};
for (const details of document.querySelectorAll('details')) details.open = true;
let least = 21, worst = '', count = 0;
const judge = (colour, element, what) => {
  const value = contrast(luminance(rgba(colour)), groundOf(element));
  ++count;
  if (value < least) [least, worst] = [value, what];
};
for (const element of document.querySelectorAll('body *')) {
  const own = [...element.childNodes].some(node => node.nodeType === 3 && node.textContent.trim() !== '');
  if (own && element.checkVisibility()) judge(getComputedStyle(element).color, element, element.tagName + '.' + element.className);
}
return [Math.floor(least * 100), count > 1000, luminance(rgba(getComputedStyle(document.body).backgroundColor)) > 0.5, worst.trim()].join(' ');
E2

# What the address names is unfolded.
cat >unfolded.js <<'E2'
return document.querySelector('#options').closest('details').open;
E2

# The keyboard comes to everything, and shows where it is; nothing is wider than a phone but what scrolls.
cat >keys.js <<'E2'
for (const details of document.querySelectorAll('details')) details.open = true;
document.body.style.width = '390px';
const wanted = [...document.querySelectorAll('a, button, input, select, summary, .scroll, .frame[tabindex], .command')].filter(element => element.checkVisibility());
const missed = wanted.filter(element => {
  element.focus();
  return document.activeElement !== element || getComputedStyle(element).outlineStyle === 'none';
});
const wide = [...document.querySelectorAll('main *')].filter(element => element.checkVisibility() && !element.closest('.scroll, pre') &&
  element.getBoundingClientRect().right > 391);
return [wanted.length > 100, missed.length, wide.length, wide.slice(0, 3).map(element => element.outerHTML.slice(0, 60))].join(' ');
E2

# On a light screen, from its first lines on.
probe whole/report.html length accurate sort contrast -- --blink-settings=preferredColorScheme=1 --window-size=1400,900
echo "words, screens, words of the first lines, claims, height of a claim, end of the claims, texts cut in them: $(found length)"
read -r words screens first claims height end cut <<<"$(found length)"
[ "$words" -le 3000 ] || fail "$words words are shown"
[ "$screens" -le 12 ] || fail "the page has $screens screens"
[ "$first" -le 125 ] || fail "the first lines have $first words"
[ "$claims" -ge 8 ] || fail "$claims claims"
[ "$height" -le 30 ] || fail "a claim is $height pixels high"
[ "$end" -le 900 ] || fail "the claims end at $end pixels"
[ "$cut" -le 5 ] || fail "$cut texts of the claims are cut"
[ -z "${IKBENCH_REPRODUCTION:-}" ] || expect accurate "IK-BA is the most accurate|depends on who obeys limits etc.|holds|holds in N %, fails in N %" "the first claim"
expect sort "18 false ascending true descending true" "sorting"
readable() {
  read -r least many light worst <<<"$(found contrast)"
  [ "$many $light" = "true $1" ] || fail "contrast: $(found contrast)"
  [ "$least" -ge 300 ] || fail "contrast $least / 100 of $worst"
}
readable true

# On a dark and narrow one, at an address.
fragment="#options" probe whole/report.html unfolded links contrast keys -- \
  --blink-settings=preferredColorScheme=0 --window-size=500,900
expect unfolded true "what the address names"
expect links " 0 0 true true" "ids twice, links to nowhere, images that are broken or have no words, downloads, fits"
readable false
[[ $(found keys) == "true 0 0 "* ]] || fail "many, not reached, too wide: $(found keys)"

# A study without a paper has a verdict of its own on the first screen: who is better, by how much, at what cost; and
# nothing of a paper.
cat >own.js <<'E2'
const lines = [...document.querySelectorAll('.own li')], texts = lines.map(line => line.textContent);
return [/^(Smallest|Most often) [^:]+: \w/.test(texts[0]), texts.filter(text => text.includes('error')).length > 0,
  texts.some(text => text.startsWith('Fewest evaluations: damped_least_squares (')), lines.at(-1).getBoundingClientRect().bottom < 900,
  document.querySelectorAll('.claims').length, /helix|slim|the paper|printed/i.test(document.body.innerText)].join(' ');
E2
probe own/report.html own contrast -- --blink-settings=preferredColorScheme=1 --window-size=1400,900
expect own "true true true true 0 false" "the verdict of a study without a paper"
readable true
probe own/report.html links keys -- --window-size=500,900
expect links " 0 0 true true" "ids twice, links to nowhere, images that are broken or have no words, downloads, fits"
[[ $(found keys) == "true 0 0 "* ]] || fail "many, not reached, too wide: $(found keys)"

# The arm moves: a point on, another solver, on its own. It shows the joint limits violated at the points where the store
# has them so, and nowhere else.
if grep -q 'id="motion-data"' plain/report.html; then
  cat >motion.js <<'E2'
const texts = () => [...document.querySelectorAll('.view p')].map(text => text.textContent.slice(0, 8)).join(' ');
const forth = document.getElementById('forth');
forth.click();
const words = [document.querySelectorAll('#stage canvas').length, document.getElementById('stage').hidden, texts()];
forth.click();
words.push(texts());
const select = document.querySelector('.view select');
select.value = 2;
select.dispatchEvent(new Event('change'));
words.push(document.querySelector('#stage canvas').getAttribute('aria-label'));
document.getElementById('play').click();
words.push(document.getElementById('play').textContent);
document.getElementById('play').click();
return words.join('; ');
E2
  cat >limits.js <<'E2'
const select = document.querySelector('.view select'), place = document.getElementById('place');
let words = '';
for (const option of [...select.options]) {
  select.value = option.value;
  select.dispatchEvent(new Event('change'));
  for (let point = 1; point <= Number(place.max); ++point) {
    place.value = point;
    place.dispatchEvent(new Event('input'));
    words += document.querySelector('.view p').textContent.includes('Outside its limits') ? 1 : 0;
  }
  words += ' ';
}
return words;
E2
  "$program" export plain/store.sqlite | awk -F, '
    NR == 1 { for (i = 1; i <= NF; ++i) column[$i] = i; next }
    { outside[$column["solver"]] = outside[$column["solver"]] ($column["limit_violation_deg"] > 0 ? 1 : 0)
      if (!($column["solver"] in seen)) order[++solvers] = $column["solver"]
      seen[$column["solver"]] = 1 }
    END { for (i = 1; i <= solvers; ++i) printf "%s ", outside[order[i]] }' >recorded
  grep -q 1 recorded || fail "no limit is violated: $(<recorded)"
  probe plain/report.html motion limits
  expect motion "2; false; Point 1: Point 1:; Point 2: Point 2:; The arm, moved by DE; Pause" "the moving arm"
  expect limits "$(<recorded)" "outside the limits, by the page"
fi

# A stranger's arm moves too, and the page says nothing of a helix or a paper.
if grep -q 'id="motion-data"' plain/report.html; then
  cat >theirs.js <<'E2'
document.getElementById('forth').click();
return [document.querySelectorAll('#stage canvas').length, document.getElementById('stage').hidden,
  document.querySelector('.view p').textContent.slice(0, 8), /helix|slim|the paper|printed/i.test(document.body.innerText)].join('; ');
E2
  probe theirs/report.html theirs links -- --window-size=1400,900
  expect theirs "2; false; Point 1:; false" "the arm of a URDF file"
  expect links " 0 0 true true" "ids twice, links to nowhere, images that are broken or have no words, downloads, fits"
fi

# It can be printed, on few pages.
browse whole/report.html --print-to-pdf="$work/whole.pdf"
[ "$(head -c 5 whole.pdf)" = "%PDF-" ] || fail "cannot be printed"
pages=$(grep -a -c '/Type */Page$\|/Type /Page[^s]' whole.pdf)
[ "$pages" -le 18 ] || fail "printed on $pages pages"

# Pictures to be looked at, where a folder for them is named: a phone is a frame, since no window is that narrow.
if [ -n "${IKBENCH_SCREENSHOTS:-}" ]; then
  printf '<!DOCTYPE html><body style="margin:0"><iframe src="report.html" style="border:0;width:390px;height:5000px"></iframe>' >whole/phone.html
  browse whole/report.html --window-size=1400,10000 --screenshot="$IKBENCH_SCREENSHOTS/light.png"
  browse whole/report.html --window-size=1400,10000 --screenshot="$IKBENCH_SCREENSHOTS/dark.png" \
    --blink-settings=preferredColorScheme=0
  browse whole/phone.html --window-size=500,5000 --screenshot="$IKBENCH_SCREENSHOTS/phone.png"
  cp whole.pdf "$IKBENCH_SCREENSHOTS/"
fi
