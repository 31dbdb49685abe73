#!/usr/bin/env bash
# The pages for users are true: files that they show (```toml NAME) are written, their commands run in order, and what
# they quote (> ...) is printed. Blocks below <!-- not run: ... --> are left out. Lines of the source (./NAME, docs/NAME,
# cli/NAME) have to exist.
source "$(dirname "$0")/common.sh"
command -v python3 >/dev/null || exit 77
root=$(realpath "$scripts/../..")

# Studies that take minutes are cut short.
mkdir bin
cat >bin/ikbench <<END
#!/usr/bin/env bash
case "\$1 \${2:-}" in
  "run baselines"*) set -- "\$@" --set runs=1 --no-report ;;
  "run my_ur5e.toml") set -- "\$@" --set runs=3 --set stop.evaluations=200 --no-figures ;;
  "run my.toml") set -- "\$@" --set runs=3 --set stop.iterations=20 --no-figures ;;
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
}

# check_page PAGE [COMMANDS]: runs its blocks, after COMMANDS, which make what the page supposes.
check_page() {
  local line block="" text="" is_left_out=""
  page=$1
  mkdir -p "$work/$page" && cd "$work/$page" || fail "$page: no folder"
  ln -s "$root/docs" docs
  ln -s "$root/cli" cli
  [[ $# == 1 ]] || bash -e -c "$2" >/dev/null 2>&1 || fail "$page: not prepared by: $2"
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
}

for name in tutorial which-solver gate figures-for-my-paper your-own-csv; do
  check_page "docs/$name.md"
done
check_page README.md
mine='ikbench list studies slim2023 >my.toml; sed -i "s/^name = .*/name = \"my\"/; /^published = /d" my.toml'
check_page docs/cluster.md "$mine"
