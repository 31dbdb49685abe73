#!/usr/bin/env bash
# The report in a browser: opened from disk, its names are text, it asks for nothing outside, its first screen answers, it
# fits a phone, it can be read, its arm moves, and nothing fails silently. Skipped without chromium (./setup
# --with-all check installs it).
source "$(dirname "$0")/common.sh"
browser=$(command -v chromium chromium-browser google-chrome | head -n 1)
needs "${browser:-chromium}"

# These would leave a mark on the page if any of it ran.
mark="document.documentElement.setAttribute('marked',1)"
hostile=("</text></svg><script>$mark</script>" "\" onload=\"$mark" "\"><img src=x onerror=$mark>" '{{{title}}} &amp; "')
{
  printf 'name = "<script>%s</script>"\ntitle = "<b>title</b>"\nrobot = "kuka_iiwa14"\nruns = 2\npopulation = 6\n' "$mark"
  printf '[stop]\niterations = 5\n[path]\nkind = "helix"\npoints = 3\n'
  for label in "${hostile[@]}"; do printf '[[solvers]]\nsolver = "bat"\nlabel = "%s"\n' "${label//\"/\\\"}"; done
} >hostile.toml
succeeds run hostile.toml --out hostile
# One in which the arm leaves its limits, and one of a stranger's arm with whole poses.
succeeds run slim2023 --set runs=1 --set stop.iterations=20 --set population=10 --out plain
cp "$root/tests/data/urdf/fetch.urdf" "$scripts/studies/own.toml" .
succeeds run own.toml --no-report --out own
sqlite3 own/store.sqlite "UPDATE environment SET value = 'machine' WHERE key = 'cpu'" # of one word, since words are counted
succeeds report own/store.sqlite
for page in {hostile,plain,own}/report.html; do
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

# probe FOLDER SCRIPTS -- OPTIONS...: opens a copy of its page with one more script. Each of the SCRIPTS is the body of a
# function; `expect NAME WORDS` checks what it returned.
probe() {
  local folder=$1
  shift
  {
    sed '/^<\/body>/,$d' "$folder/report.html"
    while [ $# -gt 0 ] && [ "$1" != -- ]; do
      printf "<script>addEventListener('load', () => { const meta = document.createElement('meta'); meta.name = 'found-%s';\nmeta.content = String((() => {\n%s\n})()); document.head.append(meta); });</script>\n" \
        "$1" "$(sed "s/@MARK@/$mark/" "$scripts/page/$1.js")"
      shift
    done
    printf '</body>\n</html>\n'
  } >"$folder/probed.html"
  while [ $# -gt 0 ] && [ "$1" != -- ]; do shift; done
  [ $# = 0 ] || shift
  browse "$folder/probed.html" "$@" --dump-dom
  # A graphics driver's message about its speed is no fault of the page.
  ! grep ':CONSOLE' "$work/.err" | grep -v 'GL Driver Message' || fail "$folder: the console has the above"
}
found() { sed -n "s/.*<meta name=\"found-$1\" content=\"\([^\"]*\)\".*/\1/p" "$work/.out"; }
expect() { equal "$1" "$(found "$1")" "$2"; }

# Names are text: cells, and no element of their making; an image runs nothing.
probe hostile names
expect names "4 0" # names in the table, strange elements
has_no "$out" ' marked='
# The page asks for nothing, and its policy forbids it; the console says so, which shows that it is seen.
sed 's/^<\/body>/<img src="file:\/\/\/nowhere.png"><script src="other.js"><\/script>&/' plain/report.html >plain/other.html
echo "$mark" >plain/other.js
browse plain/other.html --dump-dom
has "$err" CONSOLE
has_no "$out" ' marked='

# The first screen is one sentence, the table and the moving arm; ids are there once, links inside lead somewhere, pictures
# are there and have words, the keyboard comes to everything, and nothing but what scrolls is wider than the window. Every
# text can be read on its ground, in light and in dark (WCAG 2.1: 4.5; large and quiet parts 3).
for folder in plain own; do
  solvers=$(sed -n '2,$p' $folder/tables/results.csv | wc -l)
  probe $folder words network first fits contrast -- --blink-settings=preferredColorScheme=1 --window-size=1400,900
  expect network 0
  expect first "1 true true true $solvers"
  echo "$folder: $(found words) words"
  [ $folder != own ] || [ "$(found words)" -le 1150 ] || fail "$(found words) words"
  expect fits "0 0 0 true 0 true"
  expect contrast "true true true"
  probe $folder fits contrast -- --blink-settings=preferredColorScheme=0 --window-size=500,900
  expect fits "0 0 0 true 0 true"
  expect contrast "true true false"
done
# A phone is a frame, since no window is that narrow.
printf '<!DOCTYPE html><body style="margin:0"><iframe src="own/report.html" style="border:0;width:390px;height:800px"></iframe>
<script>onload = () => { const page = frames[0].document.documentElement; document.title = "wide " + (page.scrollWidth > 390); }</script>' >phone.html
browse phone.html --allow-file-access-from-files --dump-dom
has "$out" '<title>wide false</title>'

# The arm moves: to another target, by another solver.
if grep -q 'id="motion-data"' plain/report.html; then
  probe plain motion
  expect motion "2 false true true Play Pause true"
fi

# The pointer's words are those of the cell below it.
succeeds run map --robot ur5e --set path.step_cm=10 --only LM,Newton --out map
probe map pointer
equal "cells with other words" "$(found pointer | sed 's/;.*//')" "0 of $(sqlite3 map/store.sqlite "SELECT count(*) FROM current_solves WHERE label = 'LM'")"
has "$(found pointer)" "LM solves it with "

# It can be printed, on few pages.
browse own/report.html --print-to-pdf="$work/own.pdf"
pages=$(grep -a -c '/Type */Page$\|/Type /Page[^s]' own.pdf)
[ "$(head -c 5 own.pdf)" = "%PDF-" ] && [ "$pages" -le 8 ] || fail "printed on $pages pages"
