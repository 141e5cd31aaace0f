package robotran.programs

import robotran.javacompiler.support.JavaSupport
import robotran.language.source.Diagnostic
import robotran.language.source.Severity
import robotran.language.source.SourceRange
import robotran.programs.messages.ProgramMessages
import robotran.robolang.RobolangProgram
import robotran.robolang.translate.Translation
import robotran.robolang.translate.translateRobolang

/** Compiles the Java that Robolang programs become, and tells its mistakes at their lines. */
internal class TranslatedProgramCompiler(
    private val compiler: TimedJavaProgramCompiler,
    private val messages: ProgramMessages,
) {
    /**
     * @param name the Robolang program's file.
     * @param warnings about the program itself.
     */
    suspend fun compile(name: String, program: RobolangProgram, warnings: List<Diagnostic>): CompiledSource {
        val translation = translateRobolang(program)
        return when (val compiled = compiler.compile(sourceOf(translation))) {
            is CompiledSource.Failure -> CompiledSource.Failure(
                compiled.diagnostics.map { located(name, translation, it) }.distinct(),
            )

            is CompiledSource.Success -> CompiledSource.Success(
                with(compiled.program) {
                    // The compiler's warnings are about Java that the pupil did not write.
                    CompiledProgram(name, classFiles, mainClass, warnings) {
                        located(name, translation, locate(it))
                    }
                },
            )
        }
    }

    private fun sourceOf(translation: Translation) =
        Program(translation.fileName, JavaSupport.language, translation.java)

    /** A line that every translation has belongs to no line of the program. */
    private fun located(name: String, translation: Translation, diagnostic: Diagnostic): Diagnostic {
        val line = diagnostic.range?.let { translation.lineMap.sourceLineOf(it.line) }
        val range = line?.let { SourceRange(it, 1, 1) }
        return Diagnostic(Severity.ERROR, name, range, messages.inTranslation(diagnostic.message))
    }
}
