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
    val first = BoardRun.ofLog(log, program.robot.buggy)
    val second = boardRunOf(program)
    val exact = sameCalls(first.calls, second.calls)
    val isSame = isAll(exact, first, second)
    return when {
        isRandom(program) -> BoardComparison(name, "not compared: random numbers", exact)
        first.isError && second.isError && first.errorLine == second.errorLine && isSame ->
            BoardComparison(name, "fail as in Robolang, in the same line", exact)

        first.isError || second.isError ->
            BoardComparison(name, "fail", exact, "${first.end} ${first.errorLine}, not ${second.end} ${second.errorLine}", true)

        isSame -> BoardComparison(name, "make the same calls at the same times", exact)
        PAUSE.containsMatchIn(python) -> ofBusyLoop(name, first, second)
        else -> BoardComparison(name, "differ", exact, difference(first, second, exact), isWrong = true)
    }
}

/** A loop that never waits does as many rounds as the board can: what it says again and again counts once. */
private fun ofBusyLoop(name: String, first: BoardRun, second: BoardRun): BoardComparison {
    val one = BoardRun(first.calls.withoutRepetition(), first.end)
    val other = BoardRun(second.calls.withoutRepetition(), second.end)
    val same = sameCalls(one.calls, other.calls)
    if (isAll(same, one, other)) return BoardComparison(name, "make the same calls in loops that never wait", same)
    return BoardComparison(name, "differ in a loop that never waits", same, difference(one, other, same), isWrong = true)
}

private fun isAll(same: Int, first: BoardRun, second: BoardRun): Boolean {
    val sizes = listOf(first.calls.size, second.calls.size)
    // A program whose time is up may have just begun another call.
    return same == sizes.max() || (!first.isOver && !second.isOver && same >= sizes.max() - 2)
}

private fun sameCalls(first: List<TimedCall>, second: List<TimedCall>): Int =
    first.zip(second).takeWhile { (one, other) -> areAlike(one, other) }.size

private fun areAlike(first: TimedCall, second: TimedCall): Boolean =
    abs(first.time - second.time) <= TOLERANCE && areAlike(first.call, second.call)

/** Numbers that are shown may differ in their last digits, as decimal numbers of a board do. */
private fun areAlike(first: String, second: String): Boolean {
    if (first == second) return true
    val shown = SHOWN.matchEntire(first)?.groupValues ?: return false
    val wanted = SHOWN.matchEntire(second)?.groupValues ?: return false
    if (shown[1] != wanted[1]) return false
    val number = numberOf(shown[2]) ?: return false
    val other = numberOf(wanted[2]) ?: return false
    return number == other || (number.isNaN() && other.isNaN()) || abs(number - other) <= maxOf(ALMOST, abs(other) * ALMOST)
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

/** In milliseconds. */
private const val TOLERANCE = 2
