# Shared by launch/demo and test/run: the apt packages and the environment; the build is build.sh. Sourced, not run.

# The only list of what the package needs, by the names of Debian 12; differences of other releases stand below it.
debian_releases="11 12 13 sid"
packages_build="g++ make cmake catkin ros-actionlib-msgs ros-std-msgs ros-geometry-msgs libactionlib-dev libdiagnostic-msgs-dev libdiagnostic-updater-dev libdynamic-reconfigure-config-init-mutex-dev libgeometry-msgs-dev
  libnav-msgs-dev librosbag-storage-dev libroscpp-dev libroslib-dev libros-rosgraph-msgs-dev libsensor-msgs-dev libstd-srvs-dev libtf2-msgs-dev libtf2-ros-dev
  libvisualization-msgs-dev libeigen3-dev libsuitesparse-dev libsundials-dev libyaml-cpp-dev libtinyxml2-dev libcli11-dev nlohmann-json3-dev libspectra-dev libhwy-dev libgtest-dev
  librostest-dev pybind11-dev python3-dev"
packages_run="python3-numpy python3-matplotlib python3-actionlib python3-actionlib-msgs python3-dynamic-reconfigure python3-rospy python3-roslaunch python3-diagnostic-msgs python3-geometry-msgs python3-nav-msgs python3-sensor-msgs
  python3-std-srvs python3-tf2-msgs python3-visualization-msgs python3-yaml"
packages_web="python3-aiohttp libjs-chart.js python3-rosbag"
packages_browser="chromium chromium-driver python3-selenium"
packages_rviz="rviz librviz-dev qtbase5-dev libqwt-qt5-dev"
packages_test="catkin-lint rosbash python3-rosbag python3-rostest xvfb xauth imagemagick python3-yaml valgrind"
packages_campaign="python3-distributed python3-scipy python3-lxml openssl procps"
packages_tidy="clang-tidy clang-format"
packages_fuzz="clang libclang-rt-dev"
packages_neon="g++-aarch64-linux-gnu qemu-user"
packages_manual="python3-sphinx python3-myst-parser python3-breathe doxygen furo libjs-mathjax fonts-mathjax"

debian=$(. /etc/os-release 2>/dev/null; [ "${ID:-}" != debian ] || echo "${VERSION_ID:-sid}")  # 12 for example; empty: another system
without() { tr ' ' '\n' <<<"$1" | grep -vxF "$(tr ' ' '\n' <<<"$2")" | tr '\n' ' '; }
case "$debian" in
  11)
    packages_build=$(without "$packages_build" "libcli11-dev libspectra-dev libhwy-dev")  # it has none: no runner, scalar kernels
    packages_rviz+=" libopengl-dev"  # librviz-dev does not depend on it
    ;;
  13|sid) packages_rviz="rviz" ;;  # it has Qt 6, for which Debian has no Qwt: the plug-ins are left out
esac

package_dir=$(cd -P "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
. "$package_dir/launch/build.sh"

say() { printf '%s: %s\n' "${0##*/}" "$*"; }
complain() { printf '%s: %s\n' "${0##*/}" "$*" >&2; }

# Debian's own ROS and nothing in front of it; whatever the tools write at home goes into the build folder.
set_environment()
{
  if [ -z "${ROS_DISTRO:-}" ]; then
    export PATH=/usr/sbin:/usr/bin:/sbin:/bin
    unset PYTHONPATH ROS_PACKAGE_PATH CMAKE_PREFIX_PATH ROS_IP ROS_HOSTNAME
  fi
  export ROS_HOME=$1/ros_home ROS_LOG_DIR=$1/ros_home/log MPLCONFIGDIR=$1/matplotlib
  mkdir -p "$ROS_LOG_DIR" "$MPLCONFIGDIR"
  export ROS_LANG_DISABLE=${ROS_LANG_DISABLE-geneus:genlisp:gennodejs}  # messages in C++ and Python only
}

missing_packages()
{
  local package installed
  installed=$(dpkg-query -W -f '${db:Status-Status} ${Package} \n' "$@" 2>/dev/null | sed -n 's/^installed//p')
  for package in "$@"; do
    [[ $installed = *" $package "* ]] || printf '%s ' "$package"
  done
}

# How much apt is about to do, where its lists are there: say_size APT "PACKAGES".
say_size()
{
  local plan
  plan=$($1 install --assume-no --no-install-recommends $2 2>/dev/null | sed -n -E 's/.* ([0-9]+) newly installed.*/\1 packages with all that they need/p
    s/^Need to get ([^/]*).* of archives.*/\1 to download/p; s/^After this operation, (.*) of additional.*/\1 on disk/p')
  [ -z "$plan" ] || say "apt: ${plan//$'\n'/, }"
}

# Asks on a terminal whether sudo may install "PACKAGES"; with yes=true, and where nobody can answer, it may. Exit 2 where it may not.
ask_for_sudo()
{
  local answer
  ! ${yes:-false} && [ -t 0 ] || return 0
  say "$(wc -w <<<"$1") packages are missing: $1"
  say_size "apt-get -o Debug::NoLocking=1" "$1"
  read -rp "${0##*/}: install them with sudo? [Y/n] " answer || answer=n
  case "$answer" in ""|[Yy]*) return 0 ;; esac
  complain "nothing is installed. With --no-install it goes on without them; as root:"
  complain "  apt-get update && apt-get install -y --no-install-recommends $1"
  exit 2
}

# Installs what is missing of the packages named; status 1 where apt fails, exit 2 without root and sudo, or where the user says no.
install_packages()
{
  local missing apt
  if [ -n "${ROS_DISTRO:-}" ]; then
    say "a ROS $ROS_DISTRO environment is loaded: installing nothing, using what is there"
    return 0
  elif [ -z "$debian" ] || [[ " $debian_releases " != *" $debian "* ]]; then
    say "this is not Debian ${debian_releases// /, }: installing nothing, using what is there"
    return 0
  fi
  missing=$(missing_packages "$@")
  [ -n "$missing" ] || return 0
  apt="apt-get -o DPkg::Lock::Timeout=600"
  if [ "$(id -u)" = 0 ]; then
    apt="env LC_ALL=C DEBIAN_FRONTEND=noninteractive $apt"
  elif command -v sudo >/dev/null; then
    ask_for_sudo "$missing"
    apt="sudo env LC_ALL=C DEBIAN_FRONTEND=noninteractive $apt"
  else
    complain "packages are missing, and there is neither root nor sudo. As root, run:"
    complain "  apt-get update && apt-get install -y --no-install-recommends $missing"
    exit 2
  fi
  say "installing $(wc -w <<<"$missing") packages: $missing"
  { $apt update -qq && say_size "$apt" "$missing" >&3 && $apt install -y -qq --no-install-recommends $missing; } 3>&1 >"$build_dir/apt.log" 2>&1 ||
    { tail -n 5 "$build_dir/apt.log" >&2; complain "apt failed; all it said is in $build_dir/apt.log"; return 1; }
}

# The first port from 11311 on that is free.
free_port()
{
  local port=11311
  while (exec 3<>"/dev/tcp/127.0.0.1/$port") 2>/dev/null; do port=$((port + 1)); done
  echo "$port"
}
