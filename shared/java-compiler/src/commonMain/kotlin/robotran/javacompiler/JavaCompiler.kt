package robotran.javacompiler

import robotran.javacompiler.diagnose.Diagnosis
import robotran.javacompiler.diagnose.Diamonds
import robotran.javacompiler.diagnose.MissingMembers
import robotran.javacompiler.diagnose.PastedCharacters
import robotran.javacompiler.ecj.BrickTarget
import robotran.javacompiler.ecj.Ecj
import robotran.javacompiler.ecj.EcjCompilation
import robotran.javacompiler.ecj.ProblemId
import robotran.javacompiler.messages.JavaMessages
import robotran.language.source.Diagnostic
import robotran.language.source.Severity
import robotran.languagesupport.SourceFile
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
        sources: List<SourceFile>,
        library: Map<String, ByteArray>,
        missing: List<LejosDifference> = emptyList(),
        target: BrickTarget = BrickTarget.LEJOS_RCX,
    ): CompilationResult = compilation(sources, library, missing, target, messages) { texts, gaps ->
        ecj.compile(texts, library, gaps, target)
    }
}

/**
 * What [ecj] and we make of [sources].
 *
 * @param ecj compiles sources and refuses the use of gaps in the library.
 */
internal inline fun compilation(
    sources: List<SourceFile>,
    library: Map<String, ByteArray>,
    missing: List<LejosDifference>,
    target: BrickTarget,
    messages: JavaMessages,
    ecj: (texts: List<SourceFile>, gaps: Set<String>) -> EcjCompilation,
): CompilationResult {
    val texts = sources.map { it.copy(text = it.text.removePrefix(BYTE_ORDER_MARK)) }
    val gaps = MissingMembers(missing)
    val compilation = compiled(texts, target) { ecj(it, gaps.keys) }
    val diagnosis = Diagnosis(texts, library, compilation, messages, gaps, target)
    val diagnostics = diagnosis.diagnostics()
    val errors = diagnostics.filter { it.severity == Severity.ERROR }
    if (errors.isEmpty()) {
        return CompilationResult.Success(
            compilation.classes,
            diagnostics,
            compilation.mainClasses,
            diagnosis.missingMain(),
        )
    }
    val pasted = pastedCharacters(texts, errors) ?: return CompilationResult.Failure(errors)
    val plain = pasted.values.map { it.plain() }
    val plainCompilation = compiled(plain, target) { ecj(it, gaps.keys) }
    val others = Diagnosis(plain, library, plainCompilation, messages, gaps, target).diagnostics()
    return CompilationResult.Failure(withPastedCharacters(pasted, others, messages))
}

/** What [ecj] makes of [texts], with mistakes beside empty diamonds. */
internal inline fun compiled(
    texts: List<SourceFile>,
    target: BrickTarget,
    ecj: (texts: List<SourceFile>) -> EcjCompilation,
): EcjCompilation {
    val first = ecj(texts)
    if (target != BrickTarget.LEJOS_NXJ || first.problems.none { it.isError }) return first
    val diamonds = Diamonds(texts)
    return if (diamonds.isEmpty) first else withDiamonds(first, diamonds, ecj(diamonds.blanked()))
}

/** The problems of [first], which tells little beside a diamond, and of [second], which did not see the [diamonds]. */
internal fun withDiamonds(first: EcjCompilation, diamonds: Diamonds, second: EcjCompilation): EcjCompilation {
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

/** The characters that no keyboard writes in the lines of [errors], by path; null if there are none. */
internal fun pastedCharacters(texts: List<SourceFile>, errors: List<Diagnostic>): Map<String, PastedCharacters>? =
    texts.associate { text ->
        val lines = errors.filter { it.file == text.name }.mapNotNull { it.range?.line }
        text.name to PastedCharacters(text, lines.toSet())
    }.takeIf { pasted -> pasted.values.any { it.lines.isNotEmpty() } }

/** A mistake for each line with [pasted] characters, and the errors among [others], of the texts without them. */
internal fun withPastedCharacters(
    pasted: Map<String, PastedCharacters>,
    others: List<Diagnostic>,
    messages: JavaMessages,
): List<Diagnostic> {
    val kept = others.filter {
        it.severity == Severity.ERROR && it.range?.line !in pasted.getValue(it.file).lines
    }.groupBy { it.file }
    return pasted.flatMap { (path, characters) ->
        (characters.diagnostics(messages) + kept[path].orEmpty()).sortedBy { it.range?.line }
    }
}

internal const val BYTE_ORDER_MARK = "\uFEFF"

/**
 * Returns the compiler of this platform: at once on the JVM and Android. A browser loads the compiler's module first,
 * and the call throws if that fails.
 *
 * @param messages the messages for pupils, in one language.
 */
expect suspend fun loadJavaCompiler(messages: JavaMessages): JavaCompiler
