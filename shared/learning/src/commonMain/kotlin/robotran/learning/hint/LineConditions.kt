package robotran.learning.hint

import robotran.world.GoalCondition
import kotlin.math.abs

/** What the comparison of the program with the solution, line by line, finds. */
internal val lineConditions: List<HintCondition> = listOf(
    HintCondition("units mixed up") { attempt ->
        attempt.pairLine { _, pair ->
            isTenfold(pair) ||
                (pair.mine in UNITS && pair.meant in UNITS && !isSameUnit(pair))
        }
    },
    HintCondition("turned the wrong way") { attempt ->
        attempt.pairLine { line, pair -> isSide(pair) && line.tokens.none { it == "bumper" || it == "power" } }
            ?: attempt.swappedMotors()
    },
    HintCondition("mirror image") { if (isMirrorImage(it)) HintMatch() else null },
    HintCondition("drove the wrong way") { attempt ->
        attempt.pairLine { _, pair -> setOf(pair.mine, pair.meant) == WAYS }
    },
    HintCondition("wrong sensor") { attempt ->
        attempt.otherBumper() ?: attempt.otherSense()
    },
    HintCondition("compared the wrong way") { attempt ->
        attempt.pairLine { _, pair -> isOpposite(pair.mine, pair.meant) }
    },
    HintCondition("one too few") { attempt ->
        attempt.pairLine { line, pair -> counts(line, pair) == -1.0 || (pair.mine == "<" && pair.meant == "<=") }
    },
    HintCondition("one too many") { attempt ->
        attempt.pairLine { line, pair -> counts(line, pair) == 1.0 || (pair.mine == "<=" && pair.meant == "<") }
    },
    HintCondition("wrong angle") { attempt ->
        attempt.pairLine { line, pair -> areNumbers(pair) && line.tokens.any(TURNING::contains) }
    },
    HintCondition("lines swapped") { attempt ->
        attempt.differences.mapNotNull { difference ->
            (difference as? ProgramDifference.Extra)?.takeIf { extra ->
                !extra.mine.isEnd && attempt.missing.any { it.meant.tokens == extra.mine.tokens } &&
                    attempt.hasSameLines()
            }
        }.firstOrNull()?.takeIf { !attempt.hasSameOrder() }?.let { HintMatch(it.line) }
    },
    HintCondition("end in the wrong place") { attempt ->
        HintMatch(attempt.differences.firstOrNull()?.line).takeIf {
            attempt.differences.isNotEmpty() && attempt.hasSameLines() && attempt.hasSameOrder()
        }
    },
    HintCondition("too short") { attempt ->
        attempt.distanceLine { mine, meant -> mine < meant } ?: attempt.ifNothingDiffers { tooShort() }
    },
    HintCondition("too far") { attempt ->
        attempt.distanceLine { mine, meant -> mine > meant } ?: attempt.ifNothingDiffers { tooFar() }
    },
    HintCondition("wrong number") { attempt -> attempt.pairLine { _, pair -> areNumbers(pair) } },
    HintCondition("line missing") { attempt ->
        attempt.missing.firstOrNull()?.takeIf { attempt.extra.isEmpty() }?.let { HintMatch(it.line.takeIf { it > 0 }) }
    },
    HintCondition("line too many") { attempt ->
        attempt.extra.firstOrNull()?.takeIf {
            attempt.extra.size == attempt.differences.size
        }?.let { HintMatch(it.line) }
    },
)

private fun Attempt.distanceLine(isMeant: (Double, Double) -> Boolean): HintMatch? = pairLine { line, pair ->
    areNumbers(pair) && line.tokens.first() in DISTANCES && isMeant(pair.mine.toDouble(), pair.meant.toDouble())
}

/** What the run tells, if a comparison with the solution tells nothing, as where everybody draws something else. */
private fun Attempt.ifNothingDiffers(find: Attempt.() -> HintMatch?): HintMatch? =
    if (differences.isEmpty() || missedGoals.any { it.goal.condition is GoalCondition.InkLength }) find() else null

/** Whether the program has the lines of the solution, each as often, in any order. */
private fun Attempt.hasSameLines(): Boolean =
    lines.map { it.tokens.joinToString(" ") }.sorted() == solutionLines.map { it.tokens.joinToString(" ") }.sorted()

/** The same in the same order, apart from where blocks end. */
private fun Attempt.hasSameOrder(): Boolean =
    lines.filterNot { it.isEnd }.map { it.tokens } == solutionLines.filterNot { it.isEnd }.map { it.tokens }

/** The first line that asks a bumper which the solution does not ask there. */
private fun Attempt.otherBumper(): HintMatch? = changed.firstOrNull { change ->
    change.pairs.any { isSide(it) } && (bumpersIn(change.mine) - bumpersIn(change.meant)).isNotEmpty()
}?.let { HintMatch(it.line) }

private fun bumpersIn(line: CodeLine): Set<String> =
    line.tokens.zipWithNext().filter { (_, next) -> next == "bumper" }.map { (side, _) -> side }.toSet()

/** The first line about another sensor, if the program never asks the one that the solution asks. */
private fun Attempt.otherSense(): HintMatch? {
    val mine = withoutHeader(lines)
    val meant = withoutHeader(solutionLines)
    val isAsked = { code: List<CodeLine>, sense: String -> code.lineWith(listOf(sense)) != null }
    if (SENSES.none { isAsked(meant, it) && !isAsked(mine, it) }) return null
    return SENSES.filterNot {
        isAsked(meant, it)
    }.firstNotNullOfOrNull { mine.lineWith(listOf(it)) }?.let { HintMatch(it) }
}

private fun withoutHeader(lines: List<CodeLine>) = lines.filterNot { it.tokens.take(2) == listOf("light", "sensor") }

/** Both motors of a turn the other way, so that it turns to the other side. */
private fun Attempt.swappedMotors(): HintMatch? {
    val ways = changed.filter { change -> change.pairs.any { setOf(it.mine, it.meant) == WAYS } }
    val turns = ways.map { change -> change.mine.tokens.filter { it in WHEELS || it in WAYS } }
    val isTurn = SPINS.any { turns.containsAll(it) }
    return ways.firstOrNull()?.takeIf { isTurn }?.let { HintMatch(it.line) }
}

private fun isSide(pair: TokenPair): Boolean =
    setOf(pair.mine, pair.meant).let { it == SIDES || it == WHEELS || it == JAVA_SIDES }

private fun areNumbers(pair: TokenPair): Boolean = isNumber(pair.mine) && isNumber(pair.meant)

/** One second and two seconds are the same unit. */
private fun isSameUnit(pair: TokenPair): Boolean = pair.mine.removeSuffix("s") == pair.meant.removeSuffix("s")

private fun isTenfold(pair: TokenPair): Boolean {
    if (!areNumbers(pair)) return false
    val mine = pair.mine.toDouble()
    val meant = pair.meant.toDouble()
    return POWERS.any { abs(mine - meant * it) < CLOSE || abs(meant - mine * it) < CLOSE }
}

private fun isOpposite(mine: String, meant: String): Boolean =
    (mine in BELOW && meant in ABOVE) || (mine in ABOVE && meant in BELOW) || setOf(mine, meant) == EQUALITY

/** How many more than meant, in a line that counts; null for other numbers. */
private fun counts(line: CodeLine, pair: TokenPair): Double? {
    if (!areNumbers(pair) || '.' in pair.mine || '.' in pair.meant) return null
    if (line.tokens.first() in DISTANCES || line.tokens.any { it in TURNING || it in TIMES }) return null
    return pair.mine.toDouble() - pair.meant.toDouble()
}

private val UNITS = setOf("second", "seconds", "millisecond", "milliseconds")
private val SIDES = setOf("left", "right")
private val JAVA_SIDES = setOf("turnleft", "turnright")
private val WHEELS = setOf("a", "c")
private val WAYS = setOf("forward", "backward")
private val SPINS = listOf("forward" to "backward", "backward" to "forward").map { (left, right) ->
    listOf(listOf("a", left), listOf("c", right))
}
private val DISTANCES = setOf("forward", "backward", "drive")
private val TURNING = setOf("turn", "turnleft", "turnright")
private val TIMES = setOf("wait", "play", "sleep", "timer", "light", "power", "drive")
private val SENSES = listOf("light", "bumper", "timer", "button", "sensor", "battery")
private val BELOW = setOf("<", "<=")
private val ABOVE = setOf(">", ">=")
private val EQUALITY = setOf("==", "!=")
private val POWERS = listOf(10.0, 100.0, 1000.0)
private const val CLOSE = 1e-6
