package robotran.robolang

import robotran.language.Language
import robotran.language.source.Diagnostic
import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.call.RomCall
import robotran.rcxrom.call.RomCode
import robotran.robolang.messages.RobolangMessages

/** Compares a program's run with its expectations; returns each difference as a sentence with the program's path. */
internal fun differences(program: TestProgram): List<String> {
    val expected = Expectations(program.text)
    val differences = when (
        val result =
            compileRobolang(
                program.path,
                program.text,
                robotFor(program.text),
                messages = RobolangMessages.of(Language.ENGLISH),
            )
    ) {
        is RobolangResult.Failure -> differencesOfErrors(expected, result.diagnostics)

        is RobolangResult.Success -> differencesOfWarnings(expected, result.warnings)
            ?: differencesOfReady(expected, result.program)
    }
    return differences.map { "${program.path} $it" }
}

private fun differencesOfErrors(expected: Expectations, diagnostics: List<Diagnostic>): List<String> {
    val actual = diagnostics.map { "${it.range?.line}:${it.range?.column} ${it.message}" }
    return if (actual == expected.errors) {
        emptyList()
    } else {
        listOf("should have the mistakes\n${expected.errors.joinToString("\n")}\nbut has\n${actual.joinToString("\n")}")
    }
}

/** Null if the program expects no warnings; the caller then runs it. */
private fun differencesOfWarnings(expected: Expectations, warnings: List<Diagnostic>): List<String>? {
    if (expected.warnings.isEmpty()) return null
    val actual = warnings.map { "${it.range?.line}:${it.range?.column} ${it.message}" }
    if (actual == expected.warnings) return emptyList()
    return listOf(
        "should have the warnings\n${expected.warnings.joinToString("\n")}\nbut has\n${actual.joinToString("\n")}",
    )
}

private fun differencesOfReady(expected: Expectations, program: RobolangProgram): List<String> =
    if (expected.errors.isNotEmpty()) {
        listOf("has no mistakes, but should have ${expected.errors}")
    } else if (program is RobolangNxtProgram) {
        differencesOnNxt(expected, program)
    } else {
        program as RobolangRcxProgram
        val rom = RecordingRom(expected.sensors)
        val failure = runOn(rom, program)?.let { "${it.sourceLine} ${it.message}" }
        differencesOfRun(expected, rom) +
            listOfNotNull(
                "should fail with ${expected.failure} but does with $failure".takeIf {
                    failure != expected.failure
                },
            )
    }

private fun differencesOfRun(expected: Expectations, rom: RecordingRom): List<String> = buildList {
    if (expected.calls.isNotEmpty()) {
        val actual = rom.calls.groupBy({ it.sourceLine }, { it.call })
        for (line in (expected.calls.keys + actual.keys).sorted()) {
            val wanted = expected.calls[line].orEmpty().map(::textOf)
            val made = actual[line].orEmpty().map(::textOf)
            if (wanted != made) add("line $line should call $wanted but calls $made")
        }
    }
    for ((line, texts) in expected.shown) {
        val shown = rom.calls.filter { it.sourceLine == line }.mapNotNull { shownBy(it.call) }
        if (texts != shown) add("line $line should show $texts but shows $shown")
    }
    if (expected.log.isNotEmpty() && expected.log != rom.calls) {
        add("should call ${expected.log} but calls ${rom.calls}")
    }
    val end = expected.end
    if (end != null && end != rom.milliseconds) add("should end at $end but ends at ${rom.milliseconds}")
}

/** The number that [call] shows on the LCD, with its decimal point; null for other calls. */
private fun shownBy(call: RomCall): String? {
    if (call.address != RomAddress.SET_LCD_NUMBER) return null
    val (_, word, point) = call.arguments
    val value = word.toShort().toInt().coerceIn(-LCD_LARGEST, LCD_LARGEST)
    val decimals = point - RomCode.LCD_POINT_NONE
    val digits = (if (value < 0) -value else value).toString().padStart(decimals + 1, '0')
    val text = if (decimals == 0) digits else digits.dropLast(decimals) + "." + digits.takeLast(decimals)
    return if (value < 0) "-$text" else text
}

private const val LCD_LARGEST = 9999
