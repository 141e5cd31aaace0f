package robotran.robolang.fuzz

import robotran.brick.program.ProgramStatus
import robotran.language.Language
import robotran.language.source.Diagnostic
import robotran.language.source.SourceRange
import robotran.rcxrom.call.RomCall
import robotran.rcxrom.memory.RcxMemory
import robotran.rcxrom.program.Rom
import robotran.rcxrom.sensors.SensorField
import robotran.rcxrom.sensors.SensorRequest
import robotran.robolang.RobolangRcxProgram
import robotran.robolang.RobolangResult
import robotran.robolang.compileRobolang
import robotran.robolang.format.FormatResult
import robotran.robolang.format.formatRobolang
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.robot.RobotTarget

/**
 * Checks that any text can be compiled, formatted and, if valid, run without a crash.
 *
 * @throws IllegalStateException if a check fails for [source].
 */
fun checkHarmless(source: String) {
    when (val result = compileRobolang("fuzz", source, CALIBRATION, messages = RobolangMessages.of(Language.ENGLISH))) {
        is RobolangResult.Success -> runFor(result.program as RobolangRcxProgram, STEPS)
        is RobolangResult.Failure -> checkDiagnostics(result.diagnostics, source.removePrefix("\uFEFF").lines())
    }
    val formatted =
        (formatRobolang(source, messages = RobolangMessages.of(Language.ENGLISH)) as? FormatResult.Success)?.text
            ?: return
    check(
        formatRobolang(formatted, messages = RobolangMessages.of(Language.ENGLISH)) == FormatResult.Success(formatted),
    ) {
        "Formatted again, it changes: $source"
    }
}

/**
 * Runs [program] for at most [steps], and advances the clock to the end of each wait. Returns its status and its ROM
 * calls.
 */
fun runFor(program: RobolangRcxProgram, steps: Int): Pair<ProgramStatus, List<String>> {
    val rom = CountingRom()
    val run = program.start(rom)
    var status: ProgramStatus = ProgramStatus.Running
    repeat(steps / STEPS_AT_ONCE) {
        status = run.resume(STEPS_AT_ONCE)
        check(run.callStack.isNotEmpty() && run.variables.isNotEmpty()) { "A run has a call stack." }
        when (val now = status) {
            is ProgramStatus.Waiting -> rom.milliseconds = maxOf(now.untilMilliseconds, rom.milliseconds + 1)

            is ProgramStatus.Failed -> check(now.failure.message.isNotBlank() && now.failure.sourceLine > 0) {
                "A failure has a place."
            }

            else -> rom.milliseconds++
        }
        if (status is ProgramStatus.Failed || status == ProgramStatus.Ended) return status to rom.calls
    }
    return status to rom.calls
}

private fun checkDiagnostics(diagnostics: List<Diagnostic>, lines: List<String>) {
    check(diagnostics.isNotEmpty()) { "Something must be wrong." }
    val ranges = diagnostics.map { checkNotNull(it.range) }
    check(ranges.zipWithNext().all { (first, second) -> first.line < second.line }) { "One a line, in their order." }
    for ((diagnostic, range) in diagnostics.zip(ranges)) {
        checkRange(range, lines)
        check(diagnostic.text == lines[range.line - 1].substring(range.column - 1, range.endColumn - 1)) {
            "$diagnostic has another text."
        }
        diagnostic.fix?.let { checkRange(it.range, lines) }
    }
}

private fun checkRange(range: SourceRange, lines: List<String>) {
    check(range.line in 1..lines.size) { "There is no line ${range.line}." }
    check(range.column in 1..range.endColumn && range.endColumn <= lines[range.line - 1].length + 1) {
        "$range is outside its line."
    }
}

private val CALIBRATION = RobotTarget.Rcx(millisecondsPerCentimetre = 50.0, millisecondsPerDegree = 5.0)
private const val STEPS = 200
private const val STEPS_AT_ONCE = 20

/** A ROM whose sensors return another value on each read. */
private class CountingRom : Rom {
    private var readings = 0
    val calls = mutableListOf<String>()

    override val memory = RcxMemory()

    override var milliseconds = 0L

    override fun call(call: RomCall, sourceLine: Int, sourceFile: String?) {
        calls += "$milliseconds $call $sourceLine"
    }

    override fun readSensor(port: Int, request: SensorRequest): Int =
        ++readings % (if (request == SensorRequest.BOOLEAN) 2 else 100)

    override fun setSensorTypeAndMode(port: Int, type: Int, mode: Int) = Unit

    override fun setSensorValue(port: Int, value: Int, field: SensorField) = Unit
}
