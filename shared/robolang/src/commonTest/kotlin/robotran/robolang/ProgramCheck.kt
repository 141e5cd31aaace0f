package robotran.robolang

/** Compares what a program does with what its comments say; each difference is a sentence with the program's path. */
internal fun differences(program: TestProgram): List<String> {
    val expected = Expectations(program.text)
    val differences = when (val result = readRobolang(program.path, program.text, testCalibration)) {
        is RobolangResult.Mistaken -> differencesOfMistakes(expected, result.diagnostics)
        is RobolangResult.Ready -> differencesOfReady(expected, result.program)
    }
    return differences.map { "${program.path} $it" }
}

private fun differencesOfMistakes(expected: Expectations, diagnostics: List<Diagnostic>): List<String> {
    val actual = diagnostics.map { "${it.range.line}:${it.range.column} ${it.message}" }
    return if (actual == expected.errors) {
        emptyList()
    } else {
        listOf("should have the mistakes\n${expected.errors.joinToString("\n")}\nbut has\n${actual.joinToString("\n")}")
    }
}

private fun differencesOfReady(expected: Expectations, program: RobolangProgram): List<String> =
    if (expected.errors.isEmpty()) {
        differencesOfRun(expected, runToEnd(program))
    } else {
        listOf("has no mistakes, but should have ${expected.errors}")
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
    if (expected.log.isNotEmpty() && expected.log != rom.calls) add("should call ${expected.log} but calls ${rom.calls}")
    val end = expected.end
    if (end != null && end != rom.milliseconds) add("should end at $end but ends at ${rom.milliseconds}")
}
