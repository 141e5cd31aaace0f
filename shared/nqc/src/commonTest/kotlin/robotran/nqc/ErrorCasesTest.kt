package robotran.nqc

import robotran.language.Language
import robotran.language.source.Diagnostic
import robotran.nqc.diagnostic.NqcDiagnosticCode
import robotran.nqc.messages.NqcMessages
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class ErrorCasesTest {
    @Test
    fun `there are 62 cases`() = assertEquals(62, ErrorCase.all.size)

    @Test
    fun `each program has the mistake of the original compiler in its line`() {
        val failures = ErrorCase.all.mapNotNull { case ->
            val found = diagnosticsOf(case)
            val isEqual = if (case.errors.isEmpty()) {
                found.all { originalOf(it) == null }
            } else {
                case.errors.distinctBy { it.second }.all { (text, line) ->
                    found.any { matches(it, text) && (line == 0 || it.range?.line == (OTHER_LINES[case.name] ?: line)) }
                }
            }
            val said = found.joinToString("\n  ") {
                "${it.range?.line}:${it.range?.column} ${it.code?.id} ${it.message}"
            }
            if (isEqual) null else "${case.name} ${case.errors}\n${case.source}  $said"
        }
        assertTrue(failures.isEmpty(), failures.joinToString("\n"))
    }

    @Test
    fun `a program fails if and only if the original compiler fails`() {
        for (case in ErrorCase.all) {
            val fails = compileNqc(
                FILE,
                case.source,
                NqcOptions(case.target),
                messages = NqcMessages.of(Language.ENGLISH),
            ) is NqcResult.Failure
            val failed = case.errors.any { (text, _) -> text !in WARNINGS }
            assertEquals(failed, fails, case.name)
        }
    }

    @Test
    fun `every language says something else`() {
        for (case in ErrorCase.all) {
            val messages = Language.entries.map {
                diagnosticsOf(case, NqcMessages.of(it)).map { found ->
                    found.message
                }
            }
            if (messages.first().isNotEmpty()) {
                assertEquals(
                    Language.entries.size,
                    messages.distinct().size,
                    "${case.name} $messages",
                )
            }
        }
    }

    private fun originalOf(diagnostic: Diagnostic) = (diagnostic.code as NqcDiagnosticCode).original

    private fun matches(diagnostic: Diagnostic, text: String): Boolean {
        val pattern = originalOf(diagnostic)?.split("%s")?.joinToString(".*") { Regex.escape(it) } ?: return false
        return Regex(pattern).matches(text)
    }

    private fun diagnosticsOf(case: ErrorCase, messages: NqcMessages = NqcMessages.of(Language.ENGLISH)) =
        when (val result = compileNqc(FILE, case.source, NqcOptions(case.target), messages)) {
            is NqcResult.Success -> result.warnings
            is NqcResult.Failure -> result.diagnostics
        }

    private companion object {
        const val FILE = "e.nqc"

        val WARNINGS = setOf("preprocessor #warning directive", "illegal #pragma")

        /**
         * Where ours names another line, since it helps more: where an `#if` and a comment begin that do not end, where a
         * semicolon is missing, and where the program itself calls a function of the API.
         */
        val OTHER_LINES = mapOf("e32" to 1, "e38" to 1, "e41" to 1, "e54" to 1)
    }
}
