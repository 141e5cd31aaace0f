package robotran.programs

import robotran.language.source.Diagnostic
import robotran.language.source.Severity
import robotran.language.source.SourceRange
import robotran.tinyvm.diagnostic.LinkError

/**
 * The class files of a program, ready to link.
 *
 * @property mainClass with slashes; null for the first class with a main method.
 * @property locate turns a mistake that a linker finds into one for the pupil.
 */
internal class CompiledProgram(
    val name: String,
    val classFiles: Map<String, ByteArray>,
    val mainClass: String?,
    val warnings: List<Diagnostic>,
    val locate: (LinkError) -> Diagnostic,
) {
    /** What [errors] say to the pupil, each once: several places in the Java may be one in the program, or none. */
    fun diagnosticsOf(errors: List<LinkError>): List<Diagnostic> = errors.map(locate).distinct()
}

/** The result of compiling a program without linking it. */
internal sealed interface CompiledSource {
    class Success(val program: CompiledProgram) : CompiledSource

    class Failure(val diagnostics: List<Diagnostic>) : CompiledSource
}

/** What another compiler made. */
internal fun compiledOf(source: ProgramSource.CompiledClasses) =
    CompiledProgram(source.name, source.classFiles, source.mainClass, emptyList()) {
        diagnosticOf(it, it.sourceFile)
    }

/** [error] in [file]; null if its file is unknown. */
internal fun diagnosticOf(error: LinkError, file: String?): Diagnostic {
    val place = listOfNotNull(error.className.ifEmpty { null }, error.methodName).joinToString(".")
    return Diagnostic(
        severity = Severity.ERROR,
        file = file ?: place,
        range = rangeOf(error.sourceLine),
        message = if (file == null || place.isEmpty()) error.message else "$place: ${error.message}",
    )
}

/** The range of [sourceLine]; null if it is 0. A class file has line numbers, but no columns. */
internal fun rangeOf(sourceLine: Int): SourceRange? = sourceLine.takeIf { it > 0 }?.let { SourceRange(it, 1, 1) }
