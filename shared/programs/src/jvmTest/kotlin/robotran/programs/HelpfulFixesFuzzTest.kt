package robotran.programs

import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.language.fuzz.Fuzzing
import robotran.language.source.Diagnostic
import robotran.language.source.Severity
import robotran.language.source.SourceFix
import robotran.language.source.SourceRange
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

/** A fix that is offered leaves a program with fewer mistakes, and with none that is new. */
class HelpfulFixesFuzzTest {
    private val compiler = ProgramCompiler(testTarget, language = Language.ENGLISH)

    @Test
    fun `a fix of Robolang helps`() = assertHelpful(robolangPrograms + robolangExamples) { name, text ->
        Program(name, ProgramLanguage.ROBOLANG, text)
    }

    @Test
    fun `a fix of NQC helps`() = assertHelpful(nqcExamples + nqcPrograms) { name, text ->
        Program(name, ProgramLanguage.NQC, text)
    }

    @Test
    fun `the languages seldom suggest a fix that has to be dropped`() {
        val java = JavaToolchain(testTarget.kind, JavaSettings(), Language.ENGLISH, LoadedJava(compilesBeside = true))
        val settings = CompilerSettings(testTarget, Language.ENGLISH, java, FirmwareSettings())
        val robolang = RobolangProgramCompiler(settings)
        val ofRobolang = HelpfulFixes(robolangPrograms + robolangExamples, Fuzzing.seed)
        ofRobolang.check(count, { name, text -> Program(name, ProgramLanguage.ROBOLANG, text) }) {
            robolang.compile(it as Program)
        }
        val nqc = NqcProgramCompiler(settings)
        val ofNqc = HelpfulFixes(nqcExamples + nqcPrograms, Fuzzing.seed)
        ofNqc.check(count, { name, text -> Program(name, ProgramLanguage.NQC, text) }) {
            nqc.compile(it as Program)
        }
        for (fixes in listOf(ofRobolang, ofNqc)) {
            val rate = fixes.harmful.size.toDouble() / fixes.offered
            val shown = fixes.harmful.take(SHOWN).joinToString("\n\n")
            println("$rate of ${fixes.offered} fixes would be dropped, such as\n$shown")
            assertTrue(rate < MAX_DROPPED, "$rate of ${fixes.offered}")
        }
    }

    @Test
    fun `a fix that only moves a mistake is not offered`() {
        val unhelpful = FixVerification { ProgramResult.Failure(listOf(error(2), error(3))) }
        assertNull(verifiedFix(unhelpful))
        val harmful = FixVerification { ProgramResult.Failure(emptyList<Diagnostic>() + error(3, "new")) }
        assertNull(verifiedFix(harmful))
        val helpful = FixVerification { ProgramResult.Failure(listOf(error(3))) }
        assertNotNull(verifiedFix(helpful))
    }

    private fun verifiedFix(verification: FixVerification): SourceFix? {
        val source = Program("a.robo", ProgramLanguage.ROBOLANG, "beep\nbep\nbep")
        val fixable = error(2).copy(fix = SourceFix(SourceRange(2, 1, 4), "beep"))
        val result = verification.verified(source, ProgramResult.Failure(listOf(fixable, error(3))))
        return (result as ProgramResult.Failure).diagnostics.first().fix
    }

    private fun error(line: Int, message: String = "wrong") =
        Diagnostic(Severity.ERROR, "a.robo", SourceRange(line, 1, 2), message)

    private fun assertHelpful(programs: Map<String, String>, sourceOf: (String, String) -> ProgramSource) {
        val fixes = HelpfulFixes(programs, Fuzzing.seed)
        fixes.check(count, sourceOf) { compiler.compileNow(it) }
        assertTrue(fixes.offered > count / 5, "${fixes.offered}")
        assertEquals(emptyList(), fixes.harmful)
    }

    private companion object {
        val count = Fuzzing.share(1_500, atLeast = 300)
        const val MAX_DROPPED = 0.4

        /** Fixes that are printed. */
        const val SHOWN = 60
    }
}
