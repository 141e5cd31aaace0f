package robotran.robolang

import robotran.brick.program.ProgramFailure
import robotran.brick.program.ProgramStatus
import robotran.language.Language
import robotran.language.source.Diagnostic
import robotran.rcxrom.program.RcxProgram
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.robot.RobotTarget

/** A calibration that gives round durations: 50 ms per centimetre and 5 ms per degree. */
internal val testTarget = RobotTarget.Rcx(millisecondsPerCentimetre = 50.0, millisecondsPerDegree = 5.0)

internal fun read(source: String, calibration: RobotTarget = testTarget): RobolangResult =
    compileRobolang("test", source, calibration, messages = RobolangMessages.of(Language.ENGLISH))

/** The errors of [source]; empty if it can run. */
internal fun errorsOf(source: String): List<Diagnostic> = when (val result = read(source)) {
    is RobolangResult.Success -> emptyList()
    is RobolangResult.Failure -> result.diagnostics
}

/** A robot with an NXT, on the wheels of its construction kit. */
internal val testNxt = RobotTarget.Nxt(wheelDiameter = 5.6, track = 11.4)

/** The robot for a test program: one with an NXT if the header of [text] says so. */
internal fun robotFor(text: String): RobotTarget = if (NXT_HEADER.containsMatchIn(text)) testNxt else testTarget

private val NXT_HEADER = Regex("""(^|\n)\s*brick nxt\b""")

internal val RobolangResult.Success.rcxProgram: RobolangRcxProgram get() = program as RobolangRcxProgram

internal fun programOf(source: String, calibration: RobotTarget = testTarget): RcxProgram =
    when (val result = read(source, calibration)) {
        is RobolangResult.Success -> result.rcxProgram
        is RobolangResult.Failure -> throw AssertionError(result.diagnostics.joinToString("\n") { it.message })
    }

/** Runs [program] to its end; advances the clock to the end of each wait. */
internal fun runToEnd(program: RcxProgram): RecordingRom {
    val rom = RecordingRom()
    runOn(rom, program)?.let { throw AssertionError(it.message) }
    return rom
}

/**
 * Runs [program] on [rom], [steps] at a time, and advances the clock to the end of each wait. Returns its failure; null
 * if it ends normally.
 */
internal fun runOn(rom: RecordingRom, program: RcxProgram, steps: Int = STEPS): ProgramFailure? {
    val run = program.start(rom)
    repeat(MAX_RESUMES) {
        when (val status = run.resume(steps)) {
            ProgramStatus.Running -> Unit

            is ProgramStatus.Paused, is ProgramStatus.ThreadFailed -> throw AssertionError(
                "A pause or a thread: $status",
            )

            ProgramStatus.Ended -> return null
            is ProgramStatus.Waiting -> rom.milliseconds = status.untilMilliseconds
            is ProgramStatus.ThreadFailed -> throw AssertionError("Robolang has no threads.")
            is ProgramStatus.Failed -> return status.failure
        }
    }
    throw AssertionError("${program.name} does not come to an end")
}

private const val STEPS = 1000
private const val MAX_RESUMES = 100_000
