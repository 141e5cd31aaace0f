package robotran.learning.hint

/** What is asked before lines are compared. */
internal val firstConditions: List<HintCondition> = listOf(
    HintCondition("nothing changed") { attempt ->
        HintMatch().takeIf { attempt.lines.map { it.tokens } == attempt.givenLines.map { it.tokens } }
    },
    HintCondition(HintCondition.AGAIN) { if (it.hasPassed) HintMatch() else null },
    HintCondition("program failed") { if (it.hasFailed) HintMatch() else null },
    HintCondition("wrong port") { attempt ->
        if (attempt.run.missingSensors != null) {
            HintMatch()
        } else {
            attempt.pairLine { line, pair ->
                pair.mine in JAVA_PORTS || line.tokens.getOrNull(pair.index - 1) == "sensor"
            }
        }
    },
    HintCondition("pen never down") { attempt ->
        HintMatch().takeIf { attempt.run.ink.lengthCentimetres < LITTLE && attempt.drawsInSolution() }
    },
    HintCondition("pen never up") { attempt ->
        HintMatch().takeIf { attempt.lacks(listOf("pen", "up")) }
    },
    HintCondition("no wait") { attempt ->
        val lacksOnlyWaits = attempt.missing.all { "wait" in it.meant.tokens || "sleep" in it.meant.tokens }
        attempt.missing.firstOrNull()?.takeIf { lacksOnlyWaits && attempt.extra.isEmpty() && attempt.changed.isEmpty() }
            ?.let { HintMatch(it.line) }
    },
    HintCondition(WORD_MISSING) { attempt ->
        KEYWORDS.firstOrNull { attempt.lacks(listOf(it)) }?.let { HintMatch(word = it) }
    },
)

/** `word missing: W`: the program does not have these words one after the other. */
internal fun wordMissing(phrase: String, words: String) = HintCondition(phrase) { attempt ->
    if (attempt.lines.lineWith(tokensOf(words)) == null) HintMatch(word = words) else null
}

/** `word used: W`: the program has these words one after the other. */
internal fun wordUsed(phrase: String, words: String) = HintCondition(phrase) { attempt ->
    attempt.lines.lineWith(tokensOf(words))?.let { HintMatch(it) }
}

/** Whether the solution has [words] and the program does not. */
internal fun Attempt.lacks(words: List<String>): Boolean =
    lines.lineWith(words) == null && solutionLines.lineWith(words) != null

/** The first line with a token that differs from the solution's in a way that [isMeant] is about. */
internal fun Attempt.pairLine(isMeant: (CodeLine, TokenPair) -> Boolean): HintMatch? =
    changed.firstOrNull { change -> change.pairs.any { isMeant(change.mine, it) } }?.let { HintMatch(it.line) }

private fun Attempt.drawsInSolution(): Boolean =
    world.template != null || solutionLines.lineWith(listOf("pen", "down")) != null

/** Less than this, in centimetres, is nothing. */
internal const val LITTLE = 0.5
private val JAVA_PORTS = setOf("s1", "s2", "s3")

/** Words whose absence is worth a hint: what a lesson is about, not what it can be written without. */
private val KEYWORDS = listOf(
    "repeat",
    "for",
    "procedure",
    "function",
    "whenever",
    "if",
    "else",
    "until",
    "forever",
    "random",
    "return",
    "show",
    "beep",
    "play",
    "stop",
    "halt",
    "while",
    "extends",
    "synchronized",
)
