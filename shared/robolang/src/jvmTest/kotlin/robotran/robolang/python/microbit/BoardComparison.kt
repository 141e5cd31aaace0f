package robotran.robolang.python.microbit

import robotran.robolang.RobolangMicrobitProgram
import robotran.robolang.syntax.BuiltIn
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.allExpressions
import kotlin.math.abs

/**
 * A translation on the fake modules beside its program in the interpreter.
 *
 * @property result what came out, in a few words.
 * @property calls how many calls are the same.
 * @property isWrong whether that is a mistake.
 */
internal class BoardComparison(
    val name: String,
    val result: String,
    val calls: Int,
    private val detail: String = "",
    val isWrong: Boolean = false,
) {
    override fun toString(): String = "$name: $result $detail"
}

/** Compares what [python], the translation of [program], did, whose log is [log], with what the interpreter does. */
internal fun compareOnBoard(
    name: String,
    program: RobolangMicrobitProgram,
    python: String,
    log: List<String>,
): BoardComparison {
    val isBusy = PAUSE.containsMatchIn(python)
    val second = boardRunOf(program, STEPS_OF_BOARD.takeIf { isBusy })
    val first = BoardRun.ofLog(log, program.robot.buggy).upTo(second.until)
    val exact = sameCalls(first.calls, second.calls)
    val isSame = isAll(exact, first, second)
    return when {
        isRandom(program) -> BoardComparison(name, "not compared: random numbers", exact)
        first.isError && second.isError && first.errorLine == second.errorLine && isSame ->
            BoardComparison(name, "fail as in Robolang, in the same line", exact)

        second.isError && DEEP in first.end -> BoardComparison(name, "call too deep, as in Robolang", exact)

        first.isError || second.isError ->
            BoardComparison(
                name,
                "fail",
                exact,
                "${first.end} ${first.errorLine}, not ${second.end} ${second.errorLine}",
                true,
            )

        isSame -> BoardComparison(name, "make the same calls at the same times", exact)
        isBusy -> ofBusyLoop(name, first, second)
        else -> BoardComparison(name, "differ", exact, difference(first, second, exact), isWrong = true)
    }
}

/** A loop that never waits does as many rounds as the board can: what it says again and again counts once. */
private fun ofBusyLoop(name: String, first: BoardRun, second: BoardRun): BoardComparison {
    val one = BoardRun(first.calls.withoutRepetition(), first.end, until = first.until)
    val other = BoardRun(second.calls.withoutRepetition(), second.end, until = second.until)
    val same = sameCalls(one.calls, other.calls, TOLERANCE_OF_LOOPS)
    if (isAll(same, one, other)) return BoardComparison(name, "make the same calls in loops that never wait", same)
    return BoardComparison(
        name,
        "differ in a loop that never waits",
        same,
        difference(one, other, same),
        isWrong = true,
    )
}

private fun isAll(same: Int, first: BoardRun, second: BoardRun): Boolean {
    if (second.until == Long.MAX_VALUE) return same == maxOf(first.calls.size, second.calls.size)
    // In the last moments one may have begun another call.
    val last = second.until - TOLERANCE_OF_LOOPS
    return same >= maxOf(first.calls.count { it.time < last }, second.calls.count { it.time < last })
}

/** What is done before this time, with what may be one or two milliseconds off. */
private fun BoardRun.upTo(time: Long): BoardRun = if (time == Long.MAX_VALUE) {
    this
} else {
    BoardRun(calls.filter { it.time <= time }, end, errorLine, until)
}

private fun sameCalls(first: List<TimedCall>, second: List<TimedCall>, tolerance: Int = TOLERANCE): Int =
    first.zip(second).takeWhile { (one, other) ->
        abs(one.time - other.time) <= tolerance && areAlike(one.call, other.call)
    }.size

/** Numbers that are shown may differ in their last digits, as decimal numbers of a board do. */
private fun areAlike(first: String, second: String): Boolean {
    if (first == second) return true
    val shown = SHOWN.matchEntire(first)?.groupValues ?: return false
    val wanted = SHOWN.matchEntire(second)?.groupValues ?: return false
    if (shown[1] != wanted[1]) return false
    val number = numberOf(shown[2]) ?: return false
    val other = numberOf(wanted[2]) ?: return false
    return number == other || (number.isNaN() && other.isNaN()) ||
        abs(number - other) <= maxOf(ALMOST, abs(other) * ALMOST)
}

private fun numberOf(text: String): Double? = when (text.lowercase()) {
    "inf" -> Double.POSITIVE_INFINITY
    "-inf" -> Double.NEGATIVE_INFINITY
    "nan" -> Double.NaN
    else -> text.toDoubleOrNull()
}

/** Without calls that tell a part of the robot what it was told last. */
private fun List<TimedCall>.withoutRepetition(): List<TimedCall> {
    val last = HashMap<String, String>()
    return filter { last.put(partOf(it.call), it.call) != it.call }
}

private fun partOf(call: String): String = when {
    call.startsWith("i2c") -> call.split(' ').take(3).joinToString(" ")
    call.startsWith("pin") -> call.split(' ').take(2).joinToString(" ")
    call.startsWith("display") -> "display"
    else -> call.substringBefore(' ')
}

private fun difference(first: BoardRun, second: BoardRun, place: Int): String =
    "at call $place: ${first.calls.getOrNull(place)} (${first.end}), " +
        "not ${second.calls.getOrNull(place)} (${second.end})"

private fun isRandom(program: RobolangMicrobitProgram): Boolean =
    allExpressions(program.checked.tree).any { it is Expression.Call && it.name.key == BuiltIn.RANDOM.text }

private val SHOWN = Regex("(print|display scroll|display show) (.*)")
private val PAUSE = Regex("""(?m)^ +(sleep\(1\)|tick\(\)|look\(\))$""")
private const val ALMOST = 1e-4

/** What MicroPython for Node says when calls are too deep. */
private const val DEEP = "pystack exhausted"

/** How many statements a millisecond has in a loop that never waits. */
private const val STEPS_OF_BOARD = 50

/** In milliseconds; a loop that never waits takes a millisecond for each round in Python. */
private const val TOLERANCE = 2
private const val TOLERANCE_OF_LOOPS = 20
