package robotran.javacompiler.diagnose

import robotran.javacompiler.messages.JavaMessages
import robotran.language.source.Diagnostic
import robotran.language.source.Severity
import robotran.language.source.SourceSpan

/** Explains why a program that compiles has no main method. */
internal class MissingMainMethod(private val messages: JavaMessages) {
    /**
     * Returns a diagnostic at the method that is probably meant, else at the first class, else at the beginning; null
     * if there are no sources.
     */
    fun missing(sources: List<SourceText>): Diagnostic? {
        val meant = sources.firstNotNullOfOrNull { source -> misnamedMain(source)?.let { source to it } }
        val (source, span) = meant
            ?: sources.firstNotNullOfOrNull { source -> firstClassName(source)?.let { source to it } }
            ?: sources.firstOrNull()?.let { it to SourceSpan(0, 0) }
            ?: return null
        return Diagnostic(
            file = source.path,
            severity = Severity.ERROR,
            range = source.range(span),
            text = source.words(span.start, span.end),
            message = (if (meant == null) messages.noMain() else messages.wrongMain()) + " " + messages.writeMain(),
        )
    }

    private fun misnamedMain(source: SourceText): SourceSpan? = METHOD.find(source.code.text)?.let {
        SourceSpan(
            it.range.first,
            it.range.last + 1,
        )
    }

    private fun firstClassName(source: SourceText): SourceSpan? {
        val code = source.code.text
        val name = (CLASS.find(code) ?: return null).range.last + 1
        return SourceSpan(name, name + code.drop(name).takeWhile { it.isLetterOrDigit() || it == '_' }.length)
    }

    private companion object {
        val METHOD = Regex("""\b[Mm]ain(?=\s*\()""")
        val CLASS = Regex("""\b(?:class|interface)\s+""")
    }
}
