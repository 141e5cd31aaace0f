package robotran.robolang.python

import robotran.robolang.RobolangProgram
import robotran.robolang.syntax.BuiltIn
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Sense
import robotran.robolang.syntax.allExpressions
import kotlin.math.abs

/**
 * A translation on the fake modules beside its program in the interpreter.
 *
 * @property result what came out, in a few words.
 * @property calls how many calls are the same.
 * @property isWrong whether that is a mistake.
 */
internal class HubComparison(
    val name: String,
    val result: String,
    val calls: Int,
    private val detail: String = "",
    val isWrong: Boolean = false,
) {
    override fun toString(): String = "$name: $result $detail"
}

/** Compares what [python] did, whose log is [log], with what [program] does in the interpreter. */
internal fun compareOnHub(
    name: String,
    program: RobolangProgram,
    robot: PybricksRobot,
    python: String,
    log: List<String>,
): HubComparison {
    val first = HubRun.ofLog(log, python)
    val second = runOnHub(program, robot)
    val same = first.calls.zip(second.calls).takeWhile { (one, other) -> areAlike(one, other) }.size
    val sizes = listOf(first.calls.size, second.calls.size)
    val size = if (first.isOver && second.isOver) sizes.max() else sizes.min()
    val reason = reasonNotToCompare(program)
    return when {
        first.isError && second.isError -> HubComparison(name, "fail as in Robolang", same)
        first.isError -> HubComparison(name, "fail", same, first.end, isWrong = true)
        second.isError -> HubComparison(name, "fail only in Robolang", same, second.end)
        reason != null -> HubComparison(name, "not compared: $reason", same)
        same == size -> HubComparison(name, "make the same calls", same)
        else -> HubComparison(name, "differ", same, difference(first, second, same), isWrong = true)
    }
}

private fun difference(first: HubRun, second: HubRun, place: Int): String = "at call $place: ${first.calls.getOrNull(
    place,
)} (${first.end}), not ${second.calls.getOrNull(place)} (${second.end})"

private fun reasonNotToCompare(program: RobolangProgram): String? {
    val expressions = allExpressions(program.checked.tree)
    return when {
        expressions.any { it is Expression.Call && it.name.key == BuiltIn.RANDOM.text } -> "random numbers"
        expressions.any { it is Expression.Sense && it.sense is Sense.Sensor } -> "ports of an NXT"
        else -> null
    }
}

/** Numbers that are shown may differ in their last digits, as decimal numbers of a hub do. */
internal fun areAlike(first: String, second: String): Boolean {
    if (first == second) return true
    val shown = SHOWN.matchEntire(first)?.groupValues?.get(1)?.toDoubleOrNull() ?: return false
    val wanted = SHOWN.matchEntire(second)?.groupValues?.get(1)?.toDoubleOrNull() ?: return false
    return abs(shown - wanted) <= maxOf(ALMOST, abs(wanted) * ALMOST)
}

/** The robot that has what a program asks for. */
internal fun robotOf(program: RobolangProgram): PybricksRobot {
    val asksForDistance = allExpressions(program.checked.tree).any {
        it is Expression.Sense &&
            it.sense == Sense.Distance
    }
    return if (asksForDistance) sonarRobot else bumperRobot
}

private val SHOWN = Regex("print \"(.*)\"")
private const val ALMOST = 1e-4
