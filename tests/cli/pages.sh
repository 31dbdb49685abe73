#!/usr/bin/env bash
# The commands of the pages for users run: files that they show (```toml NAME) are written, blocks of commands run in order,
# but for those below <!-- not run: ... --> and lines of the source (./NAME, docs/NAME, cli/NAME), which have to exist.
source "$(dirname "$0")/common.sh"

mkdir bin
cat >bin/ikbench <<END
#!/usr/bin/env bash
[[ "\$*" != "run baselines"* ]] || set -- "\$@" --set runs=1 --set path.points=2 # they take minutes
[[ "\$*" != "run "* || "\$*" == *" --set runs="* || "\$*" == "run map"* ]] || set -- "\$@" --set runs=4
exec "$program" "\$@"
END
chmod +x bin/ikbench
export PATH=$work/bin:$PATH

for page in README.md docs/{tutorial,which-solver,map,compare,for-maintainers,for-teachers,answers,figures,your-own-csv,many-machines}.md; do
  mkdir -p "$work/$page" && cd "$work/$page" || fail "$page: no folder"
  ln -s "$root"/{docs,cli,solvers} .
  block="" is_left_out="" count=0
  while IFS= read -r line; do
    if [[ $line == "<!-- not run: "* ]]; then
      is_left_out=yes
    elif [[ $page == *your-own-csv.md && $line == "> "* ]]; then # tests/cli/run.sh has those of the tutorial
      has "$(tr -s '\n' ' ' <said)" "${line#> }"
    elif [[ -n $block && $line == '```' ]]; then
      if [[ $block == commands && -z $is_left_out ]]; then
        while read -r first _; do
          [[ $first != ./* && $first != docs/?* && $first != cli/?* ]] || [ -x "$root/$first" ] || fail "$page: no $first"
        done <commands
        sed -i -E '/^(\.\/|docs\/|cli\/)/d' commands
        bash -e commands >said 2>&1 </dev/null || fail "$page: exit code $? of: $(<commands) it said: $(<said)"
        count=$((count + 1))
      fi
      block="" is_left_out=""
    elif [[ -n $block ]]; then
      [[ $block == shown ]] || printf '%s\n' "$line" >>"$block"
    elif [[ $line == '```'* ]]; then
      block=shown
      [[ $line != '```sh' ]] || block=commands
      [[ $line != '```'*' '* ]] || block=${line#* }
      [[ $block == shown ]] || : >"$block"
    fi
  done <"$root/$page"
  echo "$page: $count blocks"
  [ $count -gt 0 ] || fail "$page has no commands"
done

# README's first screen is what the program prints, but for times.
cd "$work" || exit
command=$(sed -n 's/^\$ ikbench \(run --robot [^#]*[^# ]\).*/\1/p' "$root/README.md")
"$program" $command --figures none --out screen >said 2>/dev/null || fail "README's first screen: $command"
table_of() { sed -n '/^ .* solved  /,/^\*/{/^\*/!p}' "$1" | cut -c 1-37; }
sed -n '/^\$ ikbench run --robot/,/^```/p' "$root/README.md" >readme
first_sentence() { tr '\n' ' ' | sed 's/\. .*//'; }
equal "README's headline" "$(sed 1d readme | first_sentence)" "$(first_sentence <said)"
equal "README's table" "$(table_of readme)" "$(table_of said)"
