#!/bin/sh
# Records one run of a part program on LinuxCNC. Made by contourlab record.
#
# 1. Put contourlab-record.hal beside the INI file. Under [HAL] add, after the other lines with HALFILE:
#        HALFILE = contourlab-record.hal
#    and HALUI = halui, if there is no line with HALUI.
# 2. Start LinuxCNC, home, then type in a terminal:
#        sh contourlab-record.sh [LOG]
# 3. Run the program. The log has half a second before its start and after its end.
set -eu
export LC_ALL=C
log=${1:-run-$(date +%Y%m%d-%H%M%S).csv}
if [ -e "$log" ]; then
    echo "$log is there already: name another file" >&2
    exit 2
fi
echo "Start the program. This ends by itself half a second after the program."
now=$(halcmd getp sampler.0.sample-num)
halsampler -t | awk -v period=@PERIOD@ -v kept=@KEPT@ -v now="$now" '
function put(line,    cell, n, i) {
    n = split(line, cell, " ")
    if (!rows++) first = cell[1]
    printf "%.6f", (cell[1] - first) * period
    for (i = 2; i < n - 1; i++) printf ",%s", cell[i]
    print ""
}
BEGIN { print "@HEADER@" }
NF < 2 || $1 < now { next }  # an overrun: the numbers of the samples show the gap; or what was sampled before
{ in_auto = $(NF - 1); is_idle = $NF }
!begun {
    before[n++ % kept] = $0
    if (in_auto && !is_idle) {
        begun = 1
        for (i = (n > kept ? n - kept : 0); i < n; i++) put(before[i % kept])
    }
    next
}
{ put($0); rest = is_idle ? rest + 1 : 0 }
rest >= kept { exit }
END { if (rest < kept) { print "The samples ended before the program: the log is not whole." > "/dev/stderr"; exit 1 } }
' > "$log"
echo "$log has the run"
