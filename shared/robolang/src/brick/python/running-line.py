//// RUNNING_LINE

from pybricks.tools import StopWatch

@CLOCK@ = StopWatch()
@TOLD@ = 0
@COUNT@ = 0


def @MARK@(line, most=1):
    # Tells the app which line runs.
    global @TOLD@, @COUNT@
    if @CLOCK@.time() >= @WINDOW@:
        @CLOCK@.reset()
        @COUNT@ = 0
    if line != @TOLD@ and @COUNT@ < most:
        @TOLD@ = line
        @COUNT@ += 1
        print("@SIGN@%d" % line)
