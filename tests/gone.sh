#!/usr/bin/env bash
# Nothing that users read names what version 2 no longer has, and help, screens and reports have none of the words that
# only the source has: gone.sh PROGRAM
# The notes on the paper, the decisions and the changes may.
set -euo pipefail
export LC_ALL=C.UTF-8
program=$(realpath "$1")
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")"/..

commands='solve|new|tune|trend|site|cite|article|audit|submit|status|store|import|host|fingerprint|verify'
names=(
  "ikbench ($commands)\\b" "\`($commands)\` command"
  halley robotics_toolbox 'Robotics Toolbox' haviland lloyd ceres closed_form 'kind = "(line|polyline|rectangle|lissajous|spiral|numpy)"'
  lissajous polyline 'shared.object' '\.so\b' ikbench_plugin 'ikbench\.py' 'import ikbench'
  junit bencher 'benchmark_json' 'paper\.tex' 'article\.tex' conda codemeta help2man 'docs/commands'
  'docs/(man|package|scale|gate-rate|gate-repeats|same-bits|renew-reference|error-rates|between-markers)\b'
  '--sequential' '--perturb' '--repetitions' '--one-at-a-time' '--max-runs' '--alone' '--dark'
  perturbed 'last-bits' 'round_trips' 'transport_seconds' 'waited_seconds' 'not_verified' manipulability
  'group.sequential' 'shapiro' 'critical.difference' 'performance profile' 'critical-difference' 'cluster bootstrap'
  '--(verbose|unit|quartiles|force|metric|margin-cm|estimand|other-study|quick)\b' 'METRICS=' 'verdict\.json' 'statistics\.json'
  'statistics-' 'analysis-plan' '\bestimand' 'by_design' 'tamhane' 'games-howell' 'bartlett' 'within_cm' 'analysis\.unit'
  'tables/status' 'table-3-statistics' 'kruskal_wallis'
  'runs to decide' 'expected running time' 'runs_to_decide' 'memory forecast' 'writer mark' 'instructions counted'
)
pages=(README.md CONTRIBUTING.md)
shopt -s globstar
for page in docs/**/*.md; do
  [[ $page == docs/papers/slim2023-notes.md || $page == docs/explanation/decisions.md ]] || pages+=("$page")
done
help=$(mktemp -d)
trap 'rm -rf "$help"' EXIT
"$program" --help >"$help/ikbench"
for command in reproduce run report compare stats multiverse list robot check-solver export merge; do
  "$program" "$command" --help >"$help/$command"
done

found=0
for name in "${names[@]}"; do
  ! grep -rinE -e "$name" "${pages[@]}" docs/examples cli "$help" || { echo "^ names what is gone: $name" >&2; found=1; }
done

# Words of the source alone; keys of files may have them.
inner='series|sessions?|entry|entries|companions?|famil(y|ies)|locks?|locked|estimands?|reliability|typical(ly)?|universes?|looks?'
inner+='|doubts?|findings?|contrasts?|peers?|undecided|untestable|untested|observations?|replicates?|quantit(y|ies)'
awk '/^```toml/ { take = 1; next } /^```/ { take = 0 } take' docs/tutorial.md >"$help/mine.toml"
cp docs/examples/pso.py "$help/mine.py"
cp tests/show/golden/* "$help"
cd "$help"
"$program" run mine.toml --set runs=4 >screen
"$program" compare PSO mine --store out/mine/store.sqlite >compared || true
cp out/mine/report.md .
perl -0pe 's/<(script|style).*?<\/\1>//gs; s/<[^>]*>//g' out/mine/report.html >page
rm -r out mine.*
! grep -rnwiE -e "$inner" . || { echo "^ has words of the source" >&2; found=1; }
exit $found
