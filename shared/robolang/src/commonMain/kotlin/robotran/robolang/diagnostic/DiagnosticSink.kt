package robotran.robolang.diagnostic

import robotran.brick.kind.BrickKind
import robotran.language.source.Diagnostic
import robotran.language.source.Severity
import robotran.language.source.SourceFix
import robotran.language.source.SourceRange
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.words.Vocabulary
import robotran.robolang.words.quoted
import robotran.robolang.words.wordsOf
import robotran.robolang.words.written

/**
 * Collects the diagnostics of all phases for one source. Reports at most one error per line, since a second one often
 * follows from the first.
 *
 * @param file the name of the source; empty if it has none.
 */
internal class DiagnosticSink(val messages: RobolangMessages, private val file: String = "") {
    /** The brick that the program is for, known before it is parsed. */
    lateinit var brick: BrickKind

    /** The words that the program is written in. What is reported in those of English is turned into them. */
    var vocabulary: Vocabulary = Vocabulary.ENGLISH

    /** The names that the program seems to declare, in lower case, those of several words joined by `_`. */
    var declaredNames: Set<String> = emptySet()

    private val diagnostics = mutableListOf<Diagnostic>()
    private val errorLines = mutableSetOf<Int>()
    private val warnedLines = mutableSetOf<Int>()

    /** Keywords, in lower case, that the program declares as names, each with the lines of these declarations. */
    val takenWords = mutableMapOf<String, MutableSet<Int>>()

    /** Another one for the source [file], with what was reported so far. */
    fun copied(file: String): DiagnosticSink = DiagnosticSink(messages, file).also { copy ->
        copy.brick = brick
        copy.vocabulary = vocabulary
        copy.declaredNames = declaredNames
        copy.diagnostics += diagnostics.map { it.copy(file = file) }
        copy.errorLines += errorLines
        copy.warnedLines += warnedLines
    }

    val isEmpty: Boolean get() = errorLines.isEmpty()

    /** The lines with an error so far. */
    val lines: Set<Int> get() = errorLines

    fun report(code: DiagnosticCode, range: SourceRange, text: String, message: String, fix: SourceFix? = null) {
        if (errorLines.add(range.line)) add(Severity.ERROR, code, range, text, message, fix)
    }

    fun warn(code: DiagnosticCode, range: SourceRange, text: String, message: String, fix: SourceFix? = null) {
        if (warnedLines.add(range.line)) add(Severity.WARNING, code, range, text, message, fix)
    }

    private fun add(
        severity: Severity,
        code: DiagnosticCode,
        range: SourceRange,
        text: String,
        message: String,
        fix: SourceFix?,
    ) {
        val typed = if (vocabulary === Vocabulary.ENGLISH) emptySet() else wordsOf(text)
        val told = vocabulary.quoted(message) { it in typed || it in declaredNames }
        val written = fix?.let {
            SourceFix(it.range, vocabulary.written(it.replacement) { name -> name in declaredNames })
        }
        diagnostics += Diagnostic(severity, file, range, told, written, text, code)
    }

    /** Drops the errors on [lines], which follow from others, and ignores further ones there. */
    fun forgive(lines: Set<Int>) {
        diagnostics.removeAll { it.range?.line in lines }
    }

    /** The errors; the warnings if there are no errors. */
    fun errorsInSourceOrder(): List<Diagnostic> = inSourceOrder(Severity.ERROR)

    fun warningsInSourceOrder(): List<Diagnostic> = inSourceOrder(Severity.WARNING)

    private fun inSourceOrder(severity: Severity): List<Diagnostic> =
        diagnostics.filter { it.severity == severity }.sortedWith(compareBy({ it.range?.line }, { it.range?.column }))
}
