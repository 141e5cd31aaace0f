package robotran.workshop.programs

import robotran.language.Language
import robotran.language.source.Diagnostic
import robotran.programs.ProgramResult
import robotran.programs.support
import robotran.workshop.state.InlineDiagnostic

/**
 * Quotes mistakes in the words that blocks show, where the program itself has others: the same program is compiled once
 * more, in those words, and what its mistakes say is what is told.
 */
internal class QuotesInBlocks {
    private var known: ProgramResult? = null
    private var knownWords: Language? = null
    private var told = emptyMap<Told, String>()

    /** Where a mistake is and what is said of it in the words of the program. */
    private data class Told(val file: String, val line: Int?, val message: String)

    /** The notes of the shown program of [robot], whose blocks show [words]. */
    fun notes(robot: RobotPrograms, words: Language): List<InlineDiagnostic> {
        if (robot.entry.notes.isNotEmpty()) look(robot, words)
        return robot.entry.notes.map { it.copy(diagnostic = told(it.diagnostic)) }
    }

    /** [diagnostic] as blocks quote it; as it is if nothing is known of it. */
    fun told(diagnostic: Diagnostic): Diagnostic =
        told[key(diagnostic)]?.let { diagnostic.copy(message = it) } ?: diagnostic

    private fun look(robot: RobotPrograms, words: Language) {
        val entry = robot.entry
        val result = entry.result ?: return
        if (known === result && knownWords == words) return
        known = result
        knownWords = words
        told = emptyMap()
        val support = entry.program.language.support
        if (diagnosticsOf(result).isEmpty() || support.wordsOf(entry.program.files.first().text) == words) return
        val written = diagnosticsOf(result)
        val shown = diagnosticsOf(robot.compiled(entry.program.inWords(words)))
        if (shown.size == written.size &&
            shown.zip(written).all { (one, other) -> one.range?.line == other.range?.line }
        ) {
            told = written.zip(shown).associate { (one, other) -> key(one) to other.message }
        }
    }

    private fun key(diagnostic: Diagnostic) = Told(diagnostic.file, diagnostic.range?.line, diagnostic.message)

    private fun diagnosticsOf(result: ProgramResult): List<Diagnostic> = when (result) {
        is ProgramResult.Success -> result.warnings
        is ProgramResult.Failure -> result.diagnostics
    }
}
