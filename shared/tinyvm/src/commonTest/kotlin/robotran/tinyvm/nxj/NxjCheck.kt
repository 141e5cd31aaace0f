package robotran.tinyvm.nxj

import robotran.language.Language
import robotran.nxt.log.NxtLogEntry
import robotran.nxt.program.NxtNative
import robotran.tinyvm.NxjResult
import robotran.tinyvm.config.TinyVmMode
import robotran.tinyvm.config.TinyVmSpeed
import robotran.tinyvm.linkNxj
import robotran.tinyvm.messages.TinyVmMessages

/**
 * The differences between the program at [path] and the expectations in the comments of its [source], one per line. It runs
 * three times: at the speed of a brick, with a debugger, and as quickly as possible, where calls may differ.
 */
internal fun nxjDifferences(
    path: String,
    source: String,
    classes: Map<String, ByteArray>,
    library: Map<String, ByteArray>,
): List<String> {
    val expected = NxjExpectations(source)
    val mode = if (path.startsWith("forgiving/")) TinyVmMode.FORGIVING else TinyVmMode.BRICK
    val mainClass = path.substringAfterLast('/').removeSuffix(".java")

    fun run(speed: TinyVmSpeed, isWatched: Boolean): NxjBrickRun? = when (
        val result = linkNxj(
            mainClass,
            classes,
            library,
            mainClass,
            TinyVmMessages.of(Language.ENGLISH),
            speed,
            mode,
        )
    ) {
        is NxjResult.Success -> NxjBrickRun(result.program, expected.inputs, isWatched).apply {
            run(expected.runsOnAfter ?: LONGEST)
        }

        is NxjResult.Failure -> throw AssertionError("$path is refused: ${result.refusal}")
    }
    val slow = run(TinyVmSpeed.BRICK, isWatched = false) ?: return emptyList()
    val watched = run(TinyVmSpeed.BRICK, isWatched = true) ?: return emptyList()
    val quick = run(TinyVmSpeed.UNLIMITED, isWatched = false) ?: return emptyList()
    val differences = resultDifferences(expected, slow) + callDifferences(expected, slow) +
        resultDifferences(expected, quick).map { "quickly: $it" } + listOfNotNull(
            "with a debugger, ends at ${watched.endedAt} instead of ${slow.endedAt}"
                .takeIf { watched.endedAt != slow.endedAt },
            "with a debugger, makes other calls"
                .takeIf { watched.calls.map { it.text } != slow.calls.map { it.text } },
        )
    return differences.map { "$path $it" }
}

private fun resultDifferences(expected: NxjExpectations, run: NxjBrickRun): List<String> {
    val failure = run.failure
    val wanted = expected.failures.firstOrNull()
    val isSame = if (failure == null || wanted == null) {
        failure == null && wanted == null
    } else {
        nameOf(failure.message) == wanted.first && (wanted.second == 0 || wanted.second == failure.sourceLine)
    }
    return listOfNotNull(
        "prints ${run.printed} instead of ${expected.printed}"
            .takeIf { expected.saysWhatIsPrinted && run.printed != expected.printed },
        "fails with $failure instead of ${expected.failures}".takeIf { !isSame },
        "runs on".takeIf { expected.runsOnAfter == null && run.endedAt < 0 },
        "has ended".takeIf { expected.runsOnAfter != null && run.endedAt >= 0 },
        expected.screen?.let { "shows ${run.screen} instead of $it".takeIf { run.screen != expected.screen } },
    )
}

private fun callDifferences(expected: NxjExpectations, run: NxjBrickRun): List<String> {
    val made = run.calls.filter { it.sourceLine > 0 && (it as? NxtLogEntry)?.call?.native != NxtNative.CONSOLE_LINE }
        .groupBy({ it.sourceLine }, { it.callText.trim() })
    return expected.calls.mapNotNull { (line, wanted) ->
        val calls = made[line].orEmpty()
        val isSame = calls.size == wanted.size && calls.indices.all { isSameCall(wanted[it], calls[it]) }
        "line $line makes the calls $calls instead of $wanted".takeIf { !isSame }
    } + listOfNotNull(
        expected.takes?.let { wanted ->
            "takes ${run.endedAt} ms instead of $wanted"
                .takeIf { run.endedAt !in wanted * 9 / 10 - MARGIN..wanted * 11 / 10 + MARGIN }
        },
    )
}

private fun isSameCall(wanted: String, made: String): Boolean {
    val words = made.split(' ')
    val wantedWords = wanted.split(' ')
    return words.size == wantedWords.size &&
        words.indices.all { wantedWords[it] == "?" || wantedWords[it] == words[it] }
}

/** The name of the exception in the [message] of a failure. */
private fun nameOf(message: String): String = NAME.find(message)?.groupValues?.get(1) ?: message

private val NAME = Regex("""the (\w+)""")
private const val LONGEST = 120_000L
private const val MARGIN = 20
