package robotran.programs

import robotran.language.ProgramLanguage
import robotran.language.source.SourceFix
import robotran.language.source.SourceRange
import robotran.languagesupport.SourceFile
import kotlin.test.Test
import kotlin.test.assertEquals

class ApplyFixTest {
    @Test
    fun `a fix replaces what it names`() {
        assertEquals(
            "beep\nforward 3\nbeep",
            "beep\nforwrd 3\nbeep".withFix(SourceFix(SourceRange(2, 1, 7), "forward")),
        )
    }

    @Test
    fun `a fix without width puts something in, also at the end of the text`() {
        assertEquals("wait 3 seconds", "wait 3".withFix(SourceFix(SourceRange(1, 7, 7), " seconds")))
    }

    @Test
    fun `a fix for a place that is no longer there changes nothing`() {
        assertEquals("beep", "beep".withFix(SourceFix(SourceRange(2, 1, 3), "x")))
        assertEquals("beep", "beep".withFix(SourceFix(SourceRange(1, 3, 9), "x")))
    }

    @Test
    fun `only the file of a fix changes`() {
        val program =
            Program("a", ProgramLanguage.NQC, listOf(SourceFile("a.nqc", "x"), SourceFile("b.nqh", "\uFEFFy")))
        val fixed = program.withFix("b.nqh", SourceFix(SourceRange(1, 1, 2), "z"))
        assertEquals(listOf("x", "z"), fixed?.files?.map { it.text })
        assertEquals(null, program.withFix("c.nqh", SourceFix(SourceRange(1, 1, 2), "z")))
    }
}
