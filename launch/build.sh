# The build of launch/demo and test/run: skipped where nothing changed, its progress shown. Sourced by lib.sh, not run.

# All that cmake's result depends on, except the sources: make runs cmake again when those change.
config_state()
{
  local dir=$1 prefixes
  shift
  printf '%s\n' "$package_dir" "$@"
  stat -c %y /var/lib/dpkg/status 2>/dev/null || date +%s%N  # an optional package may have been installed
  cksum "$dir/CMakeCache.txt" 2>/dev/null                     # cmake may have been run by hand
  prefixes=$(tr ':' '\n' <<<"${CMAKE_PREFIX_PATH:-}" | grep -vxF "$dir/devel")
  echo "$prefixes"
  # packages of another workspace change unseen: the time makes every state a new one
  ! grep -qvE '^(/usr|/opt/ros/[^/]*)?$' <<<"$prefixes" || date +%s%N
}

source_state()
{
  (cd "$package_dir" && find . /usr/local/include \( -path './build*' -o -name .git -o -name __pycache__ \) -prune -o \
    ! -type d -printf '%p %s %T@\n' 2>/dev/null | cksum)
}

product_state() { find "$1/devel" -name __pycache__ -prune -o ! -type d -printf '%p %s %T@\n' | LC_ALL=C sort; }

# Did a build that ended in this STAMP begin with this STATE, and is everything there that it left?
stamp_holds()
{
  local dir=$1 stamp=$2 state=$3
  [ -e "$stamp" ] && [ "$(head -n 1 "$stamp")" = "$state" ] &&
    [ -z "$(tail -n +2 "$stamp" | LC_ALL=C comm -23 - <(product_state "$dir"))" ]
}

# cmake takes seconds even where it changes nothing
configure_and_make()
{
  local dir=$1 targets=$2
  shift 2
  if ! [ -e "$dir/configured" ] || [ "$(cat "$dir/configured")" != "$(config_state "$dir" "$@")" ]; then
    rm -f "$dir/configured"
    cmake -S "$package_dir" -B "$dir" "$@" || return
    config_state "$dir" "$@" >"$dir/configured"
  fi
  make -C "$dir" -j"$(nproc)" $targets
}

in_words() { if [ "$1" -lt 60 ]; then echo "$1 s"; else echo "$((($1 + 30) / 60)) min"; fi; }

on_terminal() { [ -t 1 ] && [ "${TERM:-dumb}" != dumb ]; }

clear_line() { ! on_terminal || printf '\r\033[K'; }

files_begun() { grep -c 'Building CXX object' "$1/build.log"; }

# How many files this build compiles: those begun, and what make has still to compile; asked of make, for only it knows what is out of date. The
# rule stands for the libraries and generated sources that are not there yet: without them make ends before it comes to what needs them.
files_in_all()
{
  {
    make -n -k --eval='.DEFAULT: ;' -C "$1" $2 2>/dev/null
    cat "$1/build.log"
  } | grep -o 'Building CXX object [^"]*' | sort -u | wc -l
}

# What the build does: progress_text LOG BEGUN TOTAL SECONDS, of files and from the first to the last begun.
progress_text()
{
  local log=$1 begun=$2 total=$3 seconds=$4 ended
  if [ "$begun" = 0 ]; then
    if grep -q 'Generating' "$log"; then echo "generating messages"
    elif grep -q '^make' "$log"; then echo "checking what changed"
    else echo "configuring"; fi
  elif [ "$begun" -gt $((total + $(nproc))) ]; then  # a header changed, and make learns target by target what includes it
    echo "compiling: file $begun"
  else
    ended=$((begun - $(nproc)))
    total=$((begun > total ? begun : total))  # a header changed: make may learn of more
    printf 'compiling: file %s of %s' "$begun" "$total"
    [ "$ended" -lt 4 ] || printf ', about %s left' "$(in_words $(((seconds * (total - ended) / ended / 10 + 1) * 10)))"
    echo
  fi
}

# Shows what the build in DIR does until process PID ends: one line that is rewritten; not on a terminal, a line every PROGRESS_EVERY s.
show_progress()
{
  local pid=$1 dir=$2 targets=$3 begun before=0 total="" since=$SECONDS last=$SECONDS next=$((SECONDS + ${PROGRESS_EVERY:=15})) text
  while kill -0 "$pid" 2>/dev/null; do
    begun=$(files_begun "$dir")
    if [ "$begun" -gt 0 ] && [ -z "$total" ]; then
      since=$SECONDS
      total=$(files_in_all "$dir" "$targets")
    fi
    [ "$begun" = "$before" ] || last=$SECONDS  # the pace is that of whole files
    before=$begun
    text=$(progress_text "$dir/build.log" "$begun" "${total:-0}" $((last - since)))
    if on_terminal; then printf '\r%s\033[K' "${0##*/}: $text"
    elif [ "$SECONDS" -ge "$next" ]; then
      say "$text"
      next=$((SECONDS + PROGRESS_EVERY))
    fi
    sleep 0.2
  done
  clear_line
}

stop_making()
{
  kill -TERM -- "-$making" 2>/dev/null
  wait "$making" 2>/dev/null
  clear_line
}

# cmake and make with their progress; errors to the screen on failure
run_build()
{
  local dir=$1 targets=$2 status
  : >"$dir/build.log"  # what the last build said is not counted
  set -m  # a process group of its own: a signal to this script ends all of the build
  { trap 'exit 143' TERM; configure_and_make "$@"; } </dev/null >"$dir/build.log" 2>&1 &  # the trap: it outlives make, which cleans up
  making=$!
  set +m
  trap stop_making EXIT
  trap 'trap - INT; kill -INT $$' INT  # only bash ignores a Ctrl-C that none of its own programs dies of
  show_progress "$making" "$dir" "$targets"
  wait "$making"
  status=$?
  trap - EXIT INT
  [ $status != 0 ] || return 0
  grep -E -A 5 'error|Error' "$dir/build.log" | head -n 40 >&2
  complain "the build failed; all it said is in $dir/build.log"
  return 1
}

# Builds what is out of date: build DIR "TARGETS" [cmake options]. All output goes to DIR/build.log.
build()
{
  local dir=$1 targets=$2 started=$SECONDS sources stamp state
  shift 2
  sources=$(source_state)  # before the build: what changes during it is built the next time
  state=$({ echo "$sources"; config_state "$dir" "$@"; } | cksum)
  stamp=$dir/built.$(cksum <<<"$targets" | cut -d ' ' -f 1)
  [[ " $targets " != *" all "* ]] || stamp=$dir/built.all
  if stamp_holds "$dir" "$stamp" "$state" || stamp_holds "$dir" "$dir/built.all" "$state"; then
    say "nothing has changed since the last build in $dir"
    return 0
  fi
  rm -f "$stamp"
  say "building in $dir ($(nproc) jobs)"
  run_build "$dir" "$targets" "$@" || return 1
  { { echo "$sources"; config_state "$dir" "$@"; } | cksum; product_state "$dir"; } >"$stamp"
  say "built in $(in_words $((SECONDS - started))), files compiled: $(files_begun "$dir")"
}
