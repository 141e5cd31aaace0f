package robotran.robolang.python

import robotran.brick.program.ProgramStatus
import robotran.robolang.RobolangProgram
import robotran.robolang.robot.Durations

/**
 * What a program does on a hub.
 *
 * @property calls a line for each, without those that make the devices ready.
 * @property end how it ended: `end`, `exit`, `time is up` or `error` with what is wrong.
 */
internal class HubRun(all: List<String>, val end: String) {
    val calls: List<String> = all.filter { call -> SET_UP.none { call.startsWith(it) } }
        .map { it.removeSuffix(" nowait") }
        .dropLastWhile { it == "drive_base brake" || it.endsWith("_motor brake") || BRAKE.matches(it) }

    /** Whether it came to its end by itself. */
    val isOver: Boolean get() = end == "end" || end == "exit"

    val isError: Boolean get() = end.startsWith("error")

    companion object {
        private val SET_UP = listOf("device ", "drive_base create", "system ", "sensor ")
        private val RESET = Regex("motor . reset_angle 0")
        private val BRAKE = Regex("motor . brake")

        /** Of the [log] of the fake modules for the program [python]; its last line tells the end. */
        fun ofLog(log: List<String>, python: String): HubRun {
            val end = log.last().removePrefix("# ").substringBeforeLast(' ')
            // Motors with letters are set to 0 with the devices, before the program begins.
            var resets = python.substringAfter("Motor(").substringBefore("\n\n").lines().count {
                ".reset_angle(0)" in it
            }
            return HubRun(log.dropLast(1).filterNot { RESET.matches(it) && resets-- > 0 }, end)
        }
    }
}

/** Runs [program] with the interpreter for [robot]. */
internal fun runOnHub(program: RobolangProgram, robot: PybricksRobot): HubRun {
    val hub = RecordingHub(robot, PybricksSpeeds(program.checked.tree, robot).areApart)
    val run = program.run(hub, Durations(program.robot))
    var left = MAX_RESUMES
    while (true) {
        when (val status = run.resume(STEPS)) {
            ProgramStatus.Running -> if (left-- == 0) return HubRun(hub.calls, "time is up")

            is ProgramStatus.Waiting -> {
                if (status.untilMilliseconds > LIMIT) return HubRun(hub.calls, "time is up")
                hub.milliseconds = maxOf(hub.milliseconds, status.untilMilliseconds)
                left = MAX_RESUMES
            }

            ProgramStatus.Ended -> return HubRun(hub.calls, "end")
            is ProgramStatus.Failed -> return HubRun(hub.calls, "error ${status.failure.message}")
            is ProgramStatus.Paused, is ProgramStatus.ThreadFailed -> throw AssertionError("A pause or a thread.")
        }
    }
}

private const val STEPS = 1000
private const val MAX_RESUMES = 100

/** As in the fake modules. */
private const val LIMIT = 20_000
