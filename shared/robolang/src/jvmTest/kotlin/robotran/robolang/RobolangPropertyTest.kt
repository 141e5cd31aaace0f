package robotran.robolang

import io.kotest.common.ExperimentalKotest
import io.kotest.core.spec.style.StringSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldBeSortedWith
import io.kotest.matchers.ints.shouldBeInRange
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.PropTestConfig
import io.kotest.property.arbitrary.byte
import io.kotest.property.arbitrary.byteArray
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.map
import io.kotest.property.arbitrary.string
import io.kotest.property.checkAll
import robotran.robolang.format.FormatResult
import robotran.robolang.format.checkFormatting
import robotran.robolang.format.formatRobolang
import robotran.robolang.syntax.NumberReading
import robotran.robolang.syntax.NumberValue
import robotran.robolang.syntax.readNumber
import robotran.rom.ProgramStatus

@OptIn(ExperimentalKotest::class)
class RobolangPropertyTest : StringSpec({
    val config = PropTestConfig(seed = 2005, iterations = 25_000)

    "arbitrary text is read without harm" {
        checkAll(config, Arb.string(0..200)) { checkReading(it) }
    }

    "arbitrary bytes are read without harm" {
        checkAll(config, Arb.byteArray(Arb.int(0..200), Arb.byte())) { checkReading(it.decodeToString()) }
    }

    "pieces of the language in any order are read without harm" {
        checkAll(config, Arb.list(Arb.element(PIECES), 0..60).map { it.joinToString("") }) { checkReading(it) }
    }

    "a program with something changed is read without harm" {
        checkAll(config, validProgram(), Arb.int(0..10_000), Arb.int(0..5), Arb.element(PIECES)) { program, place, length, piece ->
            val start = place % (program.length + 1)
            checkReading(program.replaceRange(start, minOf(start + length, program.length), piece))
        }
    }

    "a valid program can be formatted" {
        checkAll(PropTestConfig(seed = 2005, iterations = 2_000), validProgram()) { source ->
            (formatRobolang(source) is FormatResult.Formatted) shouldBe true
            checkFormatting(source)
        }
    }

    "a valid program has no mistakes and comes to its end" {
        checkAll(PropTestConfig(seed = 2005, iterations = 500), validProgram()) { source ->
            mistakesOf(source).shouldBeEmpty()
            val first = runToEnd(programOf(source)).calls
            runToEnd(programOf(source)).calls shouldBe first
        }
    }

    "a decimal number is the one that Java reads" {
        checkAll(config, Arb.int(0..999_999_999), Arb.string(1..6, DIGITS)) { whole, fraction ->
            val text = "$whole.$fraction"
            readNumber(text, negative = false) shouldBe NumberReading.Read(NumberValue.Decimal(text.toFloat()))
        }
    }

    "ten thousand wrong lines are all told" {
        val wrongLines = List(10_000) { "repaet $it tmes quikly if" }.joinToString("\n")
        mistakesOf(wrongLines).map { it.range.line } shouldBe (1..10_000).toList()
    }

    "the longest programs are read without harm" {
        val half = RobolangLimits.SOURCE_CHARACTERS / 2
        val worst = listOf(
            " repeat 1 time\n".repeat(half / 15) + "end\n".repeat(half / 4),
            "repeat 1 time\n".repeat(half / 14) + " end\n".repeat(half / 14 - 1),
            "end\n".repeat(half / 4),
            "9".repeat(half),
            "x".repeat(half),
            "# ".repeat(half),
            "beep ".repeat(half / 5),
            "\r".repeat(half),
            "show " + "(".repeat(half),
            "show " + "1 + ".repeat(half / 4),
            "show " + "not ".repeat(half / 4),
            "show " + "- ".repeat(half / 2),
            "show x" + "[0]".repeat(half / 3),
            "if true\n".repeat(half / 8) + "else\n".repeat(half / 5),
            "repeat 1 time\nif true\nelse\n".repeat(half / 27),
            "procedure p()\n".repeat(half / 14),
            "show " + "x".repeat(20) + "\nshow y".repeat(half / 7),
            "var x = [" + "1,".repeat(half / 2),
        )
        for (source in worst) {
            checkReading(source)
        }
    }
})

private fun checkReading(source: String) {
    checkFormatting(source)
    val result = read(source)
    read(source).let { again ->
        if (result is RobolangResult.Mistaken) again shouldBe result
    }
    when (result) {
        is RobolangResult.Ready -> {
            val status = result.program.start(RecordingRom()).resume(100)
            (status is ProgramStatus.Failed) shouldBe false
        }

        is RobolangResult.Mistaken -> {
            checkDiagnostics(result.diagnostics, source.removePrefix("\uFEFF").lines())
        }
    }
}

private fun checkDiagnostics(diagnostics: List<Diagnostic>, lines: List<String>) {
    diagnostics.isEmpty() shouldBe false
    diagnostics.shouldBeSortedWith(compareBy({ it.range.line }, { it.range.column }))
    for (diagnostic in diagnostics) {
        checkRange(diagnostic.range, lines)
        diagnostic.text shouldBe lines[diagnostic.range.line - 1].substring(diagnostic.range.column - 1, diagnostic.range.endColumn - 1)
        diagnostic.fix?.let { checkRange(it.range, lines) }
    }
}

private fun checkRange(range: SourceRange, lines: List<String>) {
    range.line shouldBeInRange 1..lines.size
    range.column shouldBeInRange 1..lines[range.line - 1].length + 1
    range.endColumn shouldBeInRange range.column..lines[range.line - 1].length + 1
}
