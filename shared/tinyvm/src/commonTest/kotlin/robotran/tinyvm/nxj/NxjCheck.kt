package robotran.tinyvm.nxj

import robotran.tinyvm.NxjProgram
import robotran.tinyvm.NxjResult
import robotran.tinyvm.config.TinyVmSpeed
import robotran.tinyvm.linkNxj
import robotran.tinyvm.messages.EnglishTinyVmMessages

/**
 * The differences between the program at [path] and the expectations in the comments of its [source], one per line. It runs
 * on a brick as it is, for the display, the calls and the end, and three times with [PrintedLines]: at the speed of a brick,
 * with a debugger, and quickly.
 */
internal fun nxjDifferences(
    path: String,
    source: String,
    classes: Map<String, ByteArray>,
    library: Map<String, ByteArray>,
): List<String> {
    val expected = NxjExpectations(source)
    val mainClass = path.substringAfterLast('/').removeSuffix(".java")
    val program = when (val result = linkNxj(mainClass, classes, library, mainClass)) {
        is NxjResult.Ready -> result.program
        is NxjResult.Rejected -> return listOf("$path is refused: ${result.refusal}")
    }
    val run = NxjBrickRun(program, expected.inputs).apply { run(LONGEST) }
    val differences = brickDifferences(expected, run) + printDifferences(expected, classes, library, mainClass)
    return differences.map { "$path $it" }
}

private fun brickDifferences(expected: NxjExpectations, run: NxjBrickRun): List<String> {
    val failure = run.failure
    val failures = if (failure == null) emptyMap() else mapOf(failure.sourceLine to nameOf(failure.message))
    val made = run.calls.filter { it.sourceLine > 0 }.groupBy({ it.sourceLine }, { it.callText.trim() })
    return listOfNotNull(
        "fails with $failure instead of ${expected.failures}".takeIf { failures != expected.failures },
        "runs on".takeIf { run.endedAt < 0 },
        expected.screen?.let { "shows ${run.screen} instead of $it".takeIf { run.screen != expected.screen } },
        expected.endsAt?.let { "ends at ${run.endedAt} instead of $it".takeIf { _ -> run.endedAt !in it..it + MARGIN } },
    ) + expected.calls.mapNotNull { (line, wanted) ->
        "line $line makes the calls ${made[line]} instead of $wanted".takeIf { made[line].orEmpty() != wanted }
    }
}

private fun printDifferences(
    expected: NxjExpectations,
    classes: Map<String, ByteArray>,
    library: Map<String, ByteArray>,
    mainClass: String,
): List<String> {
    val runs = listOf(TinyVmSpeed.BRICK to false, TinyVmSpeed.BRICK to true, TinyVmSpeed.UNLIMITED to false)
    val ends = runs.map { (speed, isWatched) ->
        val printed = PrintedLines()
        val program = printed.link(mainClass, classes, library, speed)
        val run = NxjBrickRun(program, expected.inputs, isWatched).apply { run(LONGEST) }
        val where = speed.name.lowercase() + if (isWatched) ", watched" else ""
        val isSame = printed.byLine == expected.printed
        run.endedAt to "prints ${printed.byLine} instead of ${expected.printed}, $where".takeIf { !isSame }
    }
    return ends.mapNotNull { it.second } +
        listOfNotNull("ends at other times if watched: $ends".takeIf { ends[0].first != ends[1].first })
}

/** Links a program; fails if it is refused. */
internal fun PrintedLines.link(
    mainClass: String,
    classes: Map<String, ByteArray>,
    library: Map<String, ByteArray>,
    speed: TinyVmSpeed = TinyVmSpeed.BRICK,
): NxjProgram {
    val all = library + replacedClasses
    return when (val result = linkNxj(mainClass, classes, all, mainClass, EnglishTinyVmMessages, speed, ::find)) {
        is NxjResult.Ready -> result.program
        is NxjResult.Rejected -> throw AssertionError(result.refusal.toString())
    }
}

/** The name of the exception in the [message] of a failure. */
private fun nameOf(message: String): String = NAME.find(message)?.groupValues?.get(1) ?: message

private val NAME = Regex("""the (\w+)""")
private const val LONGEST = 120_000L
private const val MARGIN = 20
