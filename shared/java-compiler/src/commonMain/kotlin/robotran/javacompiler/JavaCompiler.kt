package robotran.javacompiler

import robotran.javacompiler.diagnose.Diagnosis
import robotran.javacompiler.diagnose.Diamonds
import robotran.javacompiler.diagnose.JavaSeverity
import robotran.javacompiler.diagnose.MissingMembers
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
    sources: List<JavaSource>,
    library: Map<String, ByteArray>,
    missing: List<LejosDifference>,
    target: BrickTarget,
    messages: JavaMessages,
    ecj: (texts: List<JavaSource>, gaps: Set<String>) -> EcjCompilation,
): CompilationResult {
    val texts = sources.map { it.copy(text = it.text.removePrefix(BYTE_ORDER_MARK)) }
    val gaps = MissingMembers(missing)
    val first = ecj(texts, gaps.keys)
    val diamonds = if (target == BrickTarget.LEJOS_NXJ && first.problems.any { it.isError }) Diamonds(texts) else null
    val compilation = if (diamonds == null || diamonds.isEmpty) {
        first
    } else {
        withDiamonds(first, diamonds, ecj(diamonds.blanked(), gaps.keys))
    }
    return told(compilation, Diagnosis(texts, library, compilation, messages, gaps, target))
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

internal fun told(compilation: EcjCompilation, diagnosis: Diagnosis): CompilationResult {
    val diagnostics = diagnosis.diagnostics()
    val errors = diagnostics.filter { it.severity == JavaSeverity.ERROR }
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

internal const val BYTE_ORDER_MARK = "\uFEFF"

/**
 * Returns the compiler of this platform: at once on the JVM and Android. A browser loads the compiler's module first,
 * and the call throws if that fails.
 *
 * @param messages the messages for pupils, in one language.
 */
expect suspend fun loadJavaCompiler(messages: JavaMessages = EnglishJavaMessages): JavaCompiler
