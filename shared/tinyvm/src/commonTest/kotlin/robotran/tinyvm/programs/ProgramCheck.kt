package robotran.tinyvm.programs

import robotran.language.Language
import robotran.lejoslibrary.LejosLibrary
import robotran.rcxrom.display.LcdGlass
import robotran.rcxrom.display.TextLcd
import robotran.rcxrom.memory.RcxMemory
import robotran.tinyvm.TinyVmResult
import robotran.tinyvm.compiledPrograms
import robotran.tinyvm.config.TinyVmLimits
import robotran.tinyvm.config.TinyVmMode
import robotran.tinyvm.config.TinyVmSpeed
import robotran.tinyvm.linkTinyVm
import robotran.tinyvm.messages.Counted
import robotran.tinyvm.messages.TinyVmMessages
import robotran.tinyvm.messages.UnsupportedFeature
import robotran.tinyvm.testPrograms
import kotlin.io.encoding.Base64
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** The class files of the library by internal name. */
internal val libraryClassFiles: Map<String, ByteArray> by lazy {
    LejosLibrary.classNames.associateWith { checkNotNull(LejosLibrary.classFile(it)) }
}

/** The class files of the test program at [path], by name. */
internal fun classFilesOf(path: String): Map<String, ByteArray> =
    compiledPrograms.filterKeys { it.startsWith("$path/") }
        .entries.associate { it.key.removePrefix("$path/").removeSuffix(".class") to Base64.decode(it.value) }

internal fun link(
    path: String,
    classes: Map<String, ByteArray> = classFilesOf(path),
    mode: TinyVmMode = TinyVmMode.BRICK,
    speed: TinyVmSpeed = TinyVmSpeed.UNLIMITED,
): TinyVmResult = linkTinyVm(
    path,
    classes,
    libraryClassFiles,
    path.substringAfterLast('/').removeSuffix(".java"),
    mode,
    speed = speed,
    messages = TinyVmMessages.of(Language.ENGLISH),
)

/** Fails if a test program in [folder] does anything else than its comments say. */
internal fun doWhatTheySay(folder: String) {
    val programs = testPrograms.filterKeys { it.startsWith("$folder/") }
    assertTrue(programs.isNotEmpty(), "There are no programs in $folder.")
    assertEquals("", programs.flatMap { (path, source) -> differences(path, source) }.joinToString("\n"))
}

/** The differences between the program at [path] and the expectations in the comments of its [source], one per line. */
internal fun differences(
    path: String,
    source: String,
    classes: Map<String, ByteArray> = classFilesOf(path),
): List<String> {
    val runs = Expectations.ofRuns(source)
    if (runs.any { it.hasErrors }) return emptyList()
    return runs.flatMap { expected ->
        TinyVmSpeed.entries.flatMap { speed ->
            val where = "$path, ${expected.mode.name.lowercase()}, ${speed.name.lowercase()}"
            differences(expected, link(path, classes, expected.mode, speed), speed).map { "$where: $it" }
        }
    }
}

private fun differences(expected: Expectations, result: TinyVmResult, speed: TinyVmSpeed): List<String> =
    when (result) {
        is TinyVmResult.Success -> differences(expected, RecordingBrick(result.program, expected.events), speed)

        is TinyVmResult.Failure -> if (isExpected(
                expected,
                result,
            )
        ) {
            emptyList()
        } else {
            listOf("it is refused: ${result.refusal}")
        }
    }

private fun isExpected(expected: Expectations, result: TinyVmResult.Failure): Boolean =
    expected.refused.any { (line, instruction) ->
        (line == 0 || line == result.refusal.sourceLine) && result.refusal.methodName != null &&
            result.refusal.message in messagesFor(instruction)
    }

private fun messagesFor(instruction: String): List<String> = when {
    instruction.endsWith("switch") -> listOf(UnsupportedFeature.SWITCH)
    instruction.endsWith("rem") && instruction != "lrem" -> listOf(UnsupportedFeature.DECIMAL_REMAINDER)
    instruction == "ldc_w" -> listOf(UnsupportedFeature.MANY_CONSTANTS)
    instruction == "checkcast" || instruction == "instanceof" -> listOf(UnsupportedFeature.ARRAY_TEST)
    instruction == "wide" -> return listOf(
        TinyVmMessages.of(Language.ENGLISH).tooMany(Counted.LOCALS, TinyVmLimits.LOCALS),
    )
    else -> listOf(UnsupportedFeature.LONG_ARITHMETIC)
}.map { TinyVmMessages.of(Language.ENGLISH).unsupportedFeature(it) }

/** Skips the end of the run at brick speed, because the expectations do not say how long a brick computes. */
private fun differences(expected: Expectations, brick: RecordingBrick, speed: TinyVmSpeed): List<String> {
    if (expected.refused.isNotEmpty()) return listOf("it is not refused")
    brick.run(expected.runsOnAfter ?: LONGEST_MILLISECONDS)
    val calls = brick.romCalls
    val lines = calls.keys + expected.romCalls?.keys.orEmpty() + expected.shown.keys
    val differences = lines.sorted().mapNotNull { line ->
        callDifference(line, expected, calls[line].orEmpty())
            ?: showDifference(line, expected, brick.shown.filter { it.line == line })
    }
    return if (speed == TinyVmSpeed.BRICK) differences else differences + endDifferences(expected, brick)
}

private fun callDifference(line: Int, expected: Expectations, made: List<String>): String? {
    val wanted = (expected.romCalls ?: return null)[line].orEmpty()
    val isSame = made.size == wanted.size && made.indices.all { isSameCall(wanted[it], made[it]) }
    return if (isSame) {
        null
    } else {
        "line $line makes the calls ${made.joinToString(" | ")} instead of ${wanted.joinToString(" | ")}"
    }
}

private fun isSameCall(wanted: String, made: String): Boolean {
    val words = made.split(' ')
    val wantedWords = wanted.split(' ')
    return words.size == wantedWords.size &&
        words.indices.all { wantedWords[it] == "?" || wantedWords[it] == words[it] }
}

private fun showDifference(line: Int, expected: Expectations, shown: List<Shown>): String? {
    val wanted =
        expected.shown[line]
            ?: return if (isAllowedToShow(line, expected) || shown.isEmpty()) null else "line $line shows something"
    val isSame = shown.size == wanted.size && shown.indices.all { isShown(wanted[it], shown[it]) }
    return if (isSame) {
        null
    } else {
        "line $line shows ${shown.map {
            if (it.isNumber) it.glass.number else it.glass.characters
        }} instead of $wanted"
    }
}

private fun isAllowedToShow(line: Int, expected: Expectations) =
    expected.shown.isEmpty() || line in expected.romCalls.orEmpty()

private fun isShown(wanted: String, shown: Shown): Boolean {
    if (shown.isNumber) return withoutZeros(shown.glass.number) == wanted
    val memory = RcxMemory()
    TextLcd.print(wanted.replace('_', ' '), memory)
    val glass = LcdGlass.of(memory)
    return (0 until TextLcd.CHARACTERS).all { glass.digit(it) == shown.glass.digit(it) }
}

/** `0042` as `42`, `-0.5` as it is. */
private fun withoutZeros(number: String): String = number.replace(Regex("""^(-?)0+(?=\d)"""), "$1")

private fun endDifferences(expected: Expectations, brick: RecordingBrick): List<String> {
    val failures = brick.failures
    val areFailuresSame = failures.size == expected.failures.size &&
        failures.indices.all { expected.failures[it].matches(failures[it]) }
    val time = brick.milliseconds
    return listOfNotNull(
        "it fails with $failures instead of ${expected.failures}".takeIf { !areFailuresSame },
        "it runs on".takeIf { expected.runsOnAfter == null && brick.isRunning },
        "it does not run on".takeIf { expected.runsOnAfter != null && !brick.isRunning },
        expected.endsAt?.let { end ->
            "it ends at $time instead of $end".takeIf {
                time !in
                    end..end + COMPUTING_MILLISECONDS
            }
        },
    )
}

private const val LONGEST_MILLISECONDS = 60_000L
private const val COMPUTING_MILLISECONDS = 20
