package robotran.robolang.python

import robotran.brick.program.ProgramStatus
import robotran.robolang.RobolangHubProgram

/**
 * What a program does on a hub.
 *
 * @property end how it ended: `end`, `exit`, `time is up` or `error` with what is wrong.
 */
internal class RecordedCalls(all: List<String>, val end: String) {
    /** A line for each call, without the last ones that stop the wheels: a hub's program ends so or so. */
    val lines: List<String> = all.dropLastWhile { it == "drive_base brake" || BRAKE.matches(it) }

    /** Whether it came to its end by itself. */
    val isOver: Boolean get() = end == "end" || end == "exit"

    val isError: Boolean get() = end.startsWith("error")

    companion object {
        private val BRAKE = Regex("motor . brake")

        /** Of the [log] of the fake modules; its last line tells the end. */
        fun ofLog(log: List<String>): RecordedCalls =
            RecordedCalls(log.dropLast(1), log.last().removePrefix("# ").substringBeforeLast(' '))
    }
}

/** Runs [program] with the interpreter on [hub]. */
internal fun callsOf(program: RobolangHubProgram, hub: HubRecorder = HubRecorder(program.robot.model)): RecordedCalls {
    val run = program.start(hub)
    var left = MAX_RESUMES
    while (true) {
        when (val status = run.resume(STEPS)) {
            ProgramStatus.Running -> if (left-- == 0) return RecordedCalls(hub.calls, "time is up")

            is ProgramStatus.Waiting -> {
                if (status.untilMilliseconds > LIMIT) return RecordedCalls(hub.calls, "time is up")
                hub.milliseconds = maxOf(hub.milliseconds, status.untilMilliseconds)
                left = MAX_RESUMES
            }

            ProgramStatus.Ended -> return RecordedCalls(hub.calls, "end")
            is ProgramStatus.Failed -> return RecordedCalls(hub.calls, "error ${status.failure.message}")
            is ProgramStatus.Paused, is ProgramStatus.ThreadFailed -> throw AssertionError("A pause or a thread.")
        }
    }
}

private const val STEPS = 1000
private const val MAX_RESUMES = 100

/** As in the fake modules. */
private const val LIMIT = 20_000
