package robotran.robolang.python.microbit

import robotran.brick.program.ProgramStatus
import robotran.microbit.buggy.AnalogLine
import robotran.microbit.buggy.Buggy
import robotran.microbit.buggy.I2cLine
import robotran.microbit.buggy.PinLine
import robotran.microbit.model.MicrobitButton
import robotran.microbit.model.MicrobitModel
import robotran.microbit.program.Microbit
import robotran.microbit.program.MicrobitCall
import robotran.microbit.program.MicrobitError
import robotran.robolang.RobolangMicrobitProgram

/** A board that moves nothing: it keeps the calls of a program with their times, and measures what the fake modules do. */
internal class BoardRecorder(override val model: MicrobitModel) : Microbit {
    val calls = mutableListOf<TimedCall>()

    override var milliseconds: Long = 0

    override fun call(call: MicrobitCall, sourceLine: Int, sourceFile: String?): MicrobitError? {
        calls += TimedCall(milliseconds, "$call")
        return null
    }

    override fun isPressed(button: MicrobitButton): Boolean = when (button) {
        MicrobitButton.A -> milliseconds % 4000 in 1500..<1800
        MicrobitButton.B -> milliseconds % 4000 in 2700..<3000
        MicrobitButton.LOGO -> milliseconds % 3000 in 600..<1000
    }

    override fun isDark(line: Int): Boolean = (milliseconds + 400 * line) % 2600 >= 1300

    override fun grey(line: Int): Int = if (isDark(line)) 20 else 60

    override val distance: Int get() = if (milliseconds % 5000 >= 3000) 15 else 90

    override val lightLevel: Int get() = if (milliseconds % 2600 >= 1300) 51 else 204

    override val soundLevel: Int get() = if (milliseconds % 3000 >= 2000) 204 else 51
}

/** A [call] at this time in milliseconds since the program began. */
internal data class TimedCall(val time: Long, val call: String) {
    override fun toString(): String = "$time $call"
}

/** The first line of a program for the fake modules: a comment with what [buggy] has on its pins. */
internal fun fakePinsOf(buggy: Buggy): String =
    buggy.lines.withIndex().joinToString(" | ", prefix = "# ") { (line, it) ->
        when (it) {
            is PinLine -> "digital;${it.pin};$line;${it.darkIs}"
            is AnalogLine -> "analog;${it.pin};$line;${if (it.isDarkHigh) 1 else 0}"
            is I2cLine -> "i2c;${MicrobitCall.i2c(it.address, it.ask)};${it.bit};${it.darkIs};$line"
        }
    }

/**
 * What a program does on a board.
 *
 * @property end how it ended: `end`, `exit`, `time is up` or `error`.
 * @property errorLine the line in Robolang of the mistake that ended it.
 * @property until when it was stopped by the test, if it was.
 */
internal class BoardRun(
    val calls: List<TimedCall>,
    val end: String,
    val errorLine: Int? = null,
    val until: Long = Long.MAX_VALUE,
) {
    val isOver: Boolean get() = end == "end" || end == "exit"

    val isError: Boolean get() = end.startsWith("error")

    companion object {
        private val LINE = Regex("print line (\\d+): .*")

        /** Of the log of the fake modules; the program must have stopped [buggy] before its first line and behind its last. */
        fun ofLog(log: List<String>, buggy: Buggy): BoardRun {
            val end = log.last().removePrefix("# ").substringBeforeLast(' ')
            val begin = log.indexOf("# begin")
            if (begin < 0) return BoardRun(emptyList(), "$end before it began")
            val stops = buggy.stopCalls.map { "$it" }
            val before = log.take(begin).map(::timed)
            check(before.takeLast(stops.size).map { it.call } == stops) { "Not stopped before: $before" }
            val all = log.drop(begin + 1).dropLast(1).map(::timed)
            val done = withoutStop(all, stops)
            val error = done.getOrNull(done.size - 2)?.call?.let { LINE.matchEntire(it) }
            if (error == null ||
                "display scroll ${done[done.size - 2].call.removePrefix("print ")}" != done.last().call
            ) {
                return BoardRun(done, end)
            }
            return BoardRun(withoutStop(done.dropLast(2), stops), "error", error.groupValues[1].toInt())
        }

        private fun timed(line: String) = TimedCall(line.substringBefore(' ').toLong(), line.substringAfter(' '))

        private fun withoutStop(calls: List<TimedCall>, stops: List<String>): List<TimedCall> {
            val quiet = if (calls.lastOrNull()?.call == "music stop") calls.dropLast(1) else calls
            check(
                quiet.takeLast(stops.size).map {
                    it.call
                } == stops,
            ) { "Not stopped at the end: ${calls.takeLast(5)}" }
            return quiet.dropLast(stops.size)
        }
    }
}

/**
 * Runs [program] with the interpreter, at most so many [steps] a millisecond; if that is null, statements take no time, as
 * in the fake modules.
 */
internal fun boardRunOf(program: RobolangMicrobitProgram, steps: Int?): BoardRun {
    val board = BoardRecorder(program.robot.model)
    val run = program.start(board)
    var resumes = 0
    while (board.milliseconds <= LIMIT && board.calls.size < MOST_CALLS && resumes++ < MOST_RESUMES) {
        when (val status = run.resume(steps ?: MANY_STEPS)) {
            ProgramStatus.Running -> if (steps != null) board.milliseconds++
            is ProgramStatus.Waiting -> board.milliseconds = maxOf(board.milliseconds, status.untilMilliseconds)
            ProgramStatus.Ended -> return BoardRun(board.calls, "end")
            is ProgramStatus.Failed -> return BoardRun(board.calls, "error", status.failure.sourceLine)
            is ProgramStatus.Paused, is ProgramStatus.ThreadFailed -> throw AssertionError("A pause or a thread.")
        }
    }
    return BoardRun(board.calls, "time is up", until = board.milliseconds)
}

private const val MOST_CALLS = 100_000
private const val MOST_RESUMES = 200_000
private const val MANY_STEPS = 10_000

/** As in the fake modules. */
private const val LIMIT = 20_000
