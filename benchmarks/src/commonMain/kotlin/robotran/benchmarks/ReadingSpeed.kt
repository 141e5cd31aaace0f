package robotran.benchmarks

import robotran.language.Language
import robotran.robolang.RobolangProgram
import robotran.robolang.RobolangResult
import robotran.robolang.compileRobolang
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.robot.RobotTarget
import robotran.robolang.syntax.RobolangLimits

/** An arbitrary robot; no benchmark depends on it. */
internal val ANY_TARGET = RobotTarget.Rcx(millisecondsPerCentimetre = 50.0, millisecondsPerDegree = 5.0)

/** The time to scan, parse and check a program of max length. */
internal suspend fun readingSpeed(): Measurement {
    val source = FIRST_LINE + PIECE.repeat((RobolangLimits.SOURCE_CHARACTERS - FIRST_LINE.length) / PIECE.length)
    val seconds = seconds { programOf(source) }
    val megabytes = source.length / 1e6
    return Measurement(megabytes / seconds, "MB/s", "${rounded(megabytes)} MB in ${rounded(seconds)} s")
}

/** The time to report ten thousand errors. */
internal suspend fun mistakesTime(): Measurement {
    val source = "repaet 4 tmes quikly\n".repeat(WRONG_LINES)
    var told = 0
    val seconds = seconds {
        told =
            (
                compileRobolang(
                    "mistakes",
                    source,
                    ANY_TARGET,
                    messages = RobolangMessages.of(Language.ENGLISH),
                ) as RobolangResult.Failure
            ).diagnostics.size
    }
    check(told == WRONG_LINES) { "Only $told of $WRONG_LINES mistakes were told." }
    return Measurement(seconds, "s", "$told mistakes on as many lines")
}

/** The valid program [source]. */
internal fun programOf(source: String, target: RobotTarget = ANY_TARGET): RobolangProgram =
    when (val result = compileRobolang("benchmark", source, target, messages = RobolangMessages.of(Language.ENGLISH))) {
        is RobolangResult.Success -> result.program
        is RobolangResult.Failure -> error(result.diagnostics.first().message)
    }

/** A program with all language features of about [lines] lines. */
internal fun programOfLines(lines: Int): String = FIRST_LINE + PIECE.repeat(lines / PIECE.count { it == '\n' })

/** Declared once: the brick has no room for thousands of variables. */
private const val FIRST_LINE = "var side = 0.0\n"

/** A sample of all language features. */
private val PIECE =
    """
    repeat 4 times // a square
      side = 2.5 * random(4, 8)
      forward side cm
      turn left 90 degrees
      if light < 40 and not left bumper
        show abs(side - 3.25)
      end
      wait 1.5 seconds
    end
    """.trimIndent() + "\n"

private const val WRONG_LINES = 10_000
