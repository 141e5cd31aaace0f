package robotran.tinyvm.nxj

import robotran.brick.program.ProgramFailure
import robotran.brick.program.ProgramStatus
import robotran.brick.program.StatementWatch
import robotran.tinyvm.NxjResult
import robotran.tinyvm.NxjRun
import robotran.tinyvm.config.NxtCosts
import robotran.tinyvm.config.TinyVmSpeed
import robotran.tinyvm.linkNxj
import robotran.tinyvm.messages.EnglishTinyVmMessages

/** What a program for an NXT did. */
internal class NxjOutcome(
    val printed: List<String>,
    val failures: List<ProgramFailure>,
    val milliseconds: Long,
    val hasEnded: Boolean,
    val run: NxjRun,
)

/** Runs [program] until it ends, for at most [longest] milliseconds; with a debugger that never pauses if [isWatched]. */
internal fun runNxj(
    program: Map<String, ByteArray>,
    library: Map<String, ByteArray>,
    speed: TinyVmSpeed = TinyVmSpeed.BRICK,
    longest: Long = 60_000,
    isWatched: Boolean = false,
    steps: Int = NxtCosts.STEPS_PER_MILLISECOND,
): NxjOutcome {
    val peripherals = PrintingPeripherals()
    val result = linkNxj(
        "Program",
        program,
        library + peripherals.classes,
        null,
        EnglishTinyVmMessages,
        speed,
        peripherals::find,
    )
    val linked = when (result) {
        is NxjResult.Ready -> result.program
        is NxjResult.Rejected -> throw AssertionError(result.refusal.toString())
    }
    val run = linked.start(peripherals)
    if (isWatched) run.watch = StatementWatch { false }
    val failures = ArrayList<ProgramFailure>()
    var hasEnded = false
    var status: ProgramStatus = ProgramStatus.Running
    while (peripherals.milliseconds < longest && !hasEnded) {
        peripherals.milliseconds++
        val waiting = status as? ProgramStatus.Waiting
        if (waiting != null && waiting.untilMilliseconds > peripherals.milliseconds) continue
        var left = NxtCosts.STEPS_PER_MILLISECOND
        while (left > 0 && !hasEnded) {
            status = run.resume(minOf(left, steps))
            left -= steps
            (status as? ProgramStatus.ThreadFailed)?.let { failures += it.failure }
            (status as? ProgramStatus.Failed)?.let { failures += it.failure }
            hasEnded = status == ProgramStatus.Ended || status is ProgramStatus.Failed
            if (status is ProgramStatus.Waiting) break
        }
    }
    return NxjOutcome(peripherals.lines, failures, peripherals.milliseconds, hasEnded, run)
}

/** The differences between the program and what the comments of its [source] say, one per line. */
internal fun nxjDifferences(
    path: String,
    source: String,
    program: Map<String, ByteArray>,
    library: Map<String, ByteArray>,
): List<String> {
    val expected = NxjExpectations(source)
    val longest = expected.runsOnAfter ?: LONGEST
    val outcomes = listOf(
        "slow" to runNxj(program, library, longest = longest),
        "quick" to runNxj(program, library, TinyVmSpeed.UNLIMITED, longest),
        "watched" to runNxj(program, library, longest = longest, isWatched = true),
    )
    val (slow, _, watched) = outcomes.map { it.second }
    val differences = outcomes.flatMap { (name, outcome) -> differences(expected, outcome).map { "$path, $name: $it" } }
    return differences + listOfNotNull(
        "$path: takes ${watched.milliseconds} ms with a debugger instead of ${slow.milliseconds}"
            .takeIf { watched.milliseconds != slow.milliseconds },
        expected.takes?.let { wanted ->
            "$path: takes ${slow.milliseconds} ms instead of $wanted"
                .takeIf { slow.milliseconds !in wanted * 9 / 10 - MARGIN..wanted * 11 / 10 + MARGIN }
        },
    )
}

private fun differences(expected: NxjExpectations, outcome: NxjOutcome): List<String> {
    val failures = outcome.failures.map { (NAME.find(it.message)?.groupValues?.get(1) ?: it.message) to it.sourceLine }
    val areFailuresSame = failures.size == expected.failures.size && failures.indices.all {
        val (name, line) = expected.failures[it]
        name == failures[it].first && (line == 0 || line == failures[it].second)
    }
    return listOfNotNull(
        "prints ${outcome.printed} instead of ${expected.printed}".takeIf { outcome.printed != expected.printed },
        "fails with ${outcome.failures} instead of ${expected.failures}".takeIf { !areFailuresSame },
        "runs on".takeIf { expected.runsOnAfter == null && !outcome.hasEnded },
        "has ended at ${outcome.milliseconds}".takeIf { expected.runsOnAfter != null && outcome.hasEnded },
    )
}

/** The differences between a program that acts on the brick and what the comments of its [source] say, one per line. */
internal fun brickDifferences(
    path: String,
    source: String,
    program: Map<String, ByteArray>,
    library: Map<String, ByteArray>,
): List<String> {
    val expected = NxjExpectations(source)
    val linked = when (val result = linkNxj(path, program, library)) {
        is NxjResult.Ready -> result.program
        is NxjResult.Rejected -> return listOf("$path is refused: ${result.refusal}")
    }
    val brick = NxjBrickRun(linked, expected.presses, expected.analog)
    brick.run(expected.runsOnAfter ?: LONGEST)
    val made = brick.calls.filter { it.sourceLine > 0 }.groupBy({ it.sourceLine }, { it.callText.trim() })
    val failure = brick.failure
    val failures = listOfNotNull(failure?.let { (NAME.find(it.message)?.groupValues?.get(1) ?: it.message) to it.sourceLine })
    return listOfNotNull(
        "shows ${brick.screen} instead of ${expected.screen}".takeIf { brick.screen != expected.screen },
        "fails with $failures instead of ${expected.failures}".takeIf { failures != expected.failures },
        "runs on".takeIf { expected.runsOnAfter == null && brick.endedAt < 0 && failure == null },
        "has ended at ${brick.endedAt}".takeIf { expected.runsOnAfter != null && brick.endedAt >= 0 },
        expected.takes?.let { wanted ->
            "takes ${brick.endedAt} ms instead of $wanted"
                .takeIf { brick.endedAt !in wanted * 9 / 10 - MARGIN..wanted * 11 / 10 + MARGIN }
        },
    ).map { "$path $it" } + expected.calls.mapNotNull { (line, wanted) ->
        val calls = made[line].orEmpty()
        val isSame = calls.size == wanted.size && calls.indices.all { isSameCall(wanted[it], calls[it]) }
        "$path, line $line makes the calls $calls instead of $wanted".takeIf { !isSame }
    }
}

private fun isSameCall(wanted: String, made: String): Boolean {
    val words = made.split(' ')
    val wantedWords = wanted.split(' ')
    return words.size == wantedWords.size &&
        words.indices.all { wantedWords[it] == "?" || wantedWords[it] == words[it] }
}

private val NAME = Regex("""the (\w+)""")
private const val LONGEST = 60_000L
private const val MARGIN = 20
