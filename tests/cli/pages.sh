#!/usr/bin/env bash
# The pages for users are true: files that they show (```toml NAME) are written, their commands run in order, and what
# they quote (> ...) is printed. Blocks below <!-- not run: ... --> are left out. Lines of the source (./NAME, docs/NAME,
# cli/NAME) have to exist.
source "$(dirname "$0")/common.sh"
command -v python3 >/dev/null || exit 77
root=$(realpath "$scripts/../..")

# Studies and papers that take minutes are cut short: a paper other than slim2023 has only to be there.
mkdir bin
cat >bin/ikbench <<END
#!/usr/bin/env bash
case "\$1 \${2:-}" in
  "reproduce slim2023") set -- "\$@" --quick --runs 2 --no-figures ;;
  "reproduce "*) "$program" list studies | grep -q "^\$2 " && exit ;;
  "run baselines"*) set -- "\$@" --set runs=1 --no-report ;;
  "multiverse "*) set -- "\$@" --set runs=1 --small --no-figures ;;
  "run my_collection.toml" | "run my_ur5e.toml") set -- "\$@" --set runs=3 --set stop.evaluations=200 --no-figures ;;
  "run my.toml") set -- "\$@" --set runs=3 --set stop.iterations=20 --no-figures ;;
  "tune "*) set -- "\${@/#2000/600}" --set stop.iterations=20 ;;
  "article "*) exit ;; # tests/cli/latex.sh
esac
exec "$program" "\$@"
END
chmod +x bin/ikbench
export PATH=$work/bin:$PATH

# run_block FILE: its commands, in the folder of the page.
run_block() {
  local first
  while read -r first _; do
    [[ $first != ./* && $first != docs/?* && $first != cli/?* ]] || [ -x "$root/$first" ] || fail "$page: no $first"
  done <"$1"
  grep -vE '^(\./|docs/|cli/)' "$1" >"$work/block"
  out=$(bash -e "$work/block" 2>&1 </dev/null) || fail "$page: exit code $? of: $(<"$work/block") it said: $out"
  blocks=$((blocks + 1))
}

# check_page PAGE BLOCKS [COMMANDS]: runs this many blocks, after COMMANDS, which make what the page supposes.
check_page() {
  local line block="" text="" is_left_out=""
  page=$1 blocks=0
  mkdir -p "$work/$page" && cd "$work/$page" || fail "$page: no folder"
  ln -s "$root/docs" docs
  ln -s "$root/results" results
  ln -s "$root/cli" cli
  [[ $# == 2 ]] || bash -e -c "$3" >/dev/null 2>&1 || fail "$page: not prepared by: $3"
  while IFS= read -r line; do
    if [[ -n $text && $line != "> "* ]]; then
      has "$out" "$text"
      text=""
    fi
    if [[ $line == "<!-- not run: "* ]]; then
      is_left_out=yes
    elif [[ -n $block && $line == '```' ]]; then
      [[ $block != sh || -n $is_left_out ]] || run_block "$work/commands"
      block="" is_left_out=""
    elif [[ -n $block ]]; then
      [[ $block == shown ]] || printf '%s\n' "$line" >>"$file"
    elif [[ $line == '```sh' ]]; then
      block=sh file=$work/commands
      : >"$file"
    elif [[ $line == '```'*' '* ]]; then
      block=file file=${line#* }
      : >"$file"
    elif [[ $line == '```'* ]]; then
      block=shown
    elif [[ $line == "> "* ]]; then
      text+="${text:+ }${line#> }"
    fi
  done < <(cat "$root/$page"; echo)
  cd "$work" || exit 1
  [ "$blocks" = "$2" ] || fail "$page: $blocks blocks ran, expected $2"
}

check_page README.md 2
check_page docs/tutorial.md 5
check_page docs/which-solver.md 6
check_page docs/is-my-variant-better.md 5
check_page docs/figures-for-my-paper.md 4
check_page docs/repeat-a-paper.md 5
new='ikbench new my.toml --like slim2023 --without-paper'
check_page docs/gate.md 2 "$new; ikbench run my.toml --set runs=3 --no-report; cp out/my/store.sqlite baseline.sqlite"
check_page docs/sweeps-and-tuning.md 2
check_page docs/cluster.md 1 "$new"
