package robotran.javacompiler

import robotran.javacompiler.diagnose.Diagnosis
import robotran.javacompiler.diagnose.Diamonds
import robotran.javacompiler.diagnose.JavaDiagnostic
import robotran.javacompiler.diagnose.JavaSeverity
import robotran.javacompiler.diagnose.MissingMembers
import robotran.javacompiler.diagnose.PastedCharacters
import robotran.javacompiler.ecj.BrickTarget
import robotran.javacompiler.ecj.Ecj
import robotran.javacompiler.ecj.EcjCompilation
import robotran.javacompiler.ecj.JavaSource
import robotran.javacompiler.ecj.ProblemId
import robotran.javacompiler.messages.EnglishJavaMessages
import robotran.javacompiler.messages.JavaMessages
import robotran.lejoslibrary.LejosDifference

/**
 * Compiles leJOS programs for the virtual machine of a brick, see [BrickTarget]. The class files are the same on every
 * platform.
 */
class JavaCompiler internal constructor(private val ecj: Ecj, private val messages: JavaMessages) {
    /** Returns this compiler with [messages] in another language. */
    fun withLanguage(messages: JavaMessages): JavaCompiler = JavaCompiler(ecj, messages)

    /**
     * Compiles all [sources] together. Never throws for any input. Takes bounded time, because it rejects long sources.
     *
     * @param library the class files of the brick's class library by internal name, such as `java/lang/Object`. The map
     * must not change. If the caller passes the same map again for a target, its classes are not read again.
     * @param missing what a program must not use although it is in [library], since a real brick lacks it.
     */
    fun compile(
        sources: List<JavaSource>,
        library: Map<String, ByteArray>,
        missing: List<LejosDifference> = emptyList(),
        target: BrickTarget = BrickTarget.LEJOS_RCX,
    ): CompilationResult {
        val texts = sources.map { it.copy(text = it.text.removePrefix(BYTE_ORDER_MARK)) }
        val gaps = MissingMembers(missing)
        val compilation = compile(texts, library, gaps, target)
        val diagnosis = Diagnosis(texts, library, compilation, messages, gaps, target)
        val diagnostics = diagnosis.diagnostics()
        val errors = withPastedCharacters(texts, diagnostics.filter { it.severity == JavaSeverity.ERROR }) { plain ->
            Diagnosis(plain, library, compile(plain, library, gaps, target), messages, gaps, target).diagnostics()
        }
        return if (errors.isEmpty()) {
            CompilationResult.Compiled(
                compilation.classes,
                diagnostics,
                compilation.mainClasses,
                diagnosis.missingMain(),
            )
        } else {
            CompilationResult.Rejected(errors)
        }
    }

    /**
     * [errors], or if [texts] have characters that no keyboard writes, a mistake for each line with them and what else
     * [diagnosed] finds in the texts without them.
     */
    private fun withPastedCharacters(
        texts: List<JavaSource>,
        errors: List<JavaDiagnostic>,
        diagnosed: (List<JavaSource>) -> List<JavaDiagnostic>,
    ): List<JavaDiagnostic> {
        if (errors.isEmpty()) return errors
        val pasted = texts.associate { text ->
            val lines = errors.filter { it.path == text.path }.map { it.range.line }
            text.path to PastedCharacters(text, lines.toSet())
        }
        if (pasted.values.all { it.lines.isEmpty() }) return errors
        val others = diagnosed(pasted.values.map { it.plain() }).filter {
            it.severity == JavaSeverity.ERROR && it.range.line !in pasted.getValue(it.path).lines
        }.groupBy { it.path }
        return pasted.flatMap { (path, characters) ->
            (characters.diagnostics(messages) + others[path].orEmpty()).sortedBy { it.range.line }
        }
    }

    private fun compile(
        texts: List<JavaSource>,
        library: Map<String, ByteArray>,
        gaps: MissingMembers,
        target: BrickTarget,
    ): EcjCompilation {
        val first = ecj.compile(texts, library, gaps.keys, target)
        if (target != BrickTarget.LEJOS_NXJ || first.problems.none { it.isError }) return first
        val diamonds = Diamonds(texts)
        if (diamonds.isEmpty) return first
        val second = ecj.compile(diamonds.blanked(), library, gaps.keys, target)
        val syntaxErrors = second.problems.filter { it.isSyntax }
        if (syntaxErrors.isEmpty() && first.problems.none { it.isSyntax }) return first
        val others = first.problems.filterNot { it.isSyntax || it.number == ProblemId.DIAMOND }
        return EcjCompilation(
            first.classes,
            first.mainClasses,
            diamonds.problems() + syntaxErrors + others,
            first.completed,
        )
    }

    private companion object {
        const val BYTE_ORDER_MARK = "\uFEFF"
    }
}

/**
 * Returns the compiler of this platform: at once on the JVM and Android. A browser loads the compiler's module first,
 * and the call throws if that fails.
 *
 * @param messages the messages for pupils, in one language.
 */
expect suspend fun loadJavaCompiler(messages: JavaMessages = EnglishJavaMessages): JavaCompiler
