package robotran.ui.program.editor

import robotran.language.Language
import robotran.language.source.Diagnostic
import robotran.language.source.Severity
import robotran.language.source.SourceFix
import robotran.language.source.SourceRange
import robotran.projects.PENBOT_TARGET
import robotran.robolang.RobolangResult
import robotran.robolang.compileRobolang
import robotran.robolang.messages.RobolangMessages
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNotNull

class FixLabelTest {
    private fun labelOf(source: String): FixLabel {
        val diagnostic = assertIs<RobolangResult.Failure>(
            compileRobolang("a.robo", source, PENBOT_TARGET, messages = RobolangMessages.of(Language.ENGLISH)),
        ).diagnostics.first()
        val fix = assertNotNull(diagnostic.fix, source)
        return fixLabelOf(
            diagnostic,
            fix,
            source.lines()[
                fix.range.line -
                    1,
            ],
        )
    }

    @Test
    fun `a button says what its fix does`() {
        assertEquals(FixLabel.Space("forward 5"), labelOf("forward5"))
        assertEquals(FixLabel.Change("forward"), labelOf("forwrd 20"))
        assertEquals(FixLabel.Remove("quickly"), labelOf("forward 20 quickly"))
        assertEquals(FixLabel.NewLine, labelOf("beep beep"))
        assertEquals(FixLabel.Add("end"), labelOf("repeat 4 times\n  beep"))
        assertEquals(FixLabel.Add("seconds"), labelOf("wait 2"))
        assertEquals(FixLabel.Add("var"), labelOf("x = 2\nshow x"))
    }

    @Test
    fun `a fix of special blanks speaks of them, not of what is between them`() {
        for ((line, replaced, replacement) in listOf(
            Triple("forward\u200920", "\u2009", " "),
            Triple("n = 5\u00a0- 2;", "n = 5\u00a0-", "n = 5 -"),
            Triple("n = 5\u00a0+ 2;", "\u00a0+", " +"),
        )) {
            val from = line.indexOf(replaced) + 1
            val fix = SourceFix(SourceRange(1, from, from + replaced.length), replacement)
            val diagnostic = Diagnostic(Severity.ERROR, "a.nqc", fix.range, "", fix)
            assertEquals(FixLabel.NormalSpaces, fixLabelOf(diagnostic, fix, line), line)
        }
    }

    @Test
    fun `several lines are added in one`() {
        val fix = SourceFix(SourceRange(1, 1, 1), "task main()\n{\n    \n}\n")
        val diagnostic = Diagnostic(Severity.ERROR, "a.nqc", SourceRange(1, 1, 1), "", fix)
        assertEquals(FixLabel.Add("task main() { }"), fixLabelOf(diagnostic, fix, ""))
    }

    @Test
    fun `a semicolon is added, whatever the line is meanwhile`() {
        val fix = SourceFix(SourceRange(1, 6, 6), ";")
        val diagnostic = Diagnostic(Severity.ERROR, "A.java", SourceRange(1, 6, 6), "", fix)
        assertEquals(FixLabel.Add(";"), fixLabelOf(diagnostic, fix, "i = 5"))
        assertEquals(FixLabel.Add(";"), fixLabelOf(diagnostic, fix, ""))
    }
}
