package robotran.robolang.python

import robotran.robolang.RobolangHubProgram
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
internal class HubComparison(
    val name: String,
    val result: String,
    val calls: Int,
    private val detail: String = "",
    val isWrong: Boolean = false,
) {
    override fun toString(): String = "$name: $result $detail"
}

/** Compares what the translation of [program] did, whose log is [log], with what the interpreter does. */
internal fun compareOnHub(name: String, program: RobolangHubProgram, log: List<String>): HubComparison {
    val first = RecordedCalls.ofLog(log)
    val second = callsOf(program)
    val same = first.lines.zip(second.lines).takeWhile { (one, other) -> areAlike(one, other) }.size
    val sizes = listOf(first.lines.size, second.lines.size)
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

private fun difference(first: RecordedCalls, second: RecordedCalls, place: Int): String =
    "at call $place: ${first.lines.getOrNull(place)} (${first.end}), " +
        "not ${second.lines.getOrNull(place)} (${second.end})"

internal fun reasonNotToCompare(program: RobolangHubProgram): String? = "random numbers".takeIf {
    allExpressions(program.checked.tree).any { it is Expression.Call && it.name.key == BuiltIn.RANDOM.text }
}

/** Numbers that are shown may differ in their last digits, as decimal numbers of a hub do. */
internal fun areAlike(first: String, second: String): Boolean {
    if (first == second) return true
    val shown = SHOWN.matchEntire(first)?.groupValues?.get(1)?.toDoubleOrNull() ?: return false
    val wanted = SHOWN.matchEntire(second)?.groupValues?.get(1)?.toDoubleOrNull() ?: return false
    return abs(shown - wanted) <= maxOf(ALMOST, abs(wanted) * ALMOST)
}

private val SHOWN = Regex("print \"(.*)\"")
private const val ALMOST = 1e-4
