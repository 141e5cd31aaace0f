package robotran.javacompiler

import robotran.javacompiler.ecj.BrickTarget
import robotran.javacompiler.ecj.TimedEcj
import robotran.javacompiler.messages.JavaMessages
import robotran.languagesupport.SourceFile
import robotran.lejoslibrary.LejosDifference

/** Compiles like [JavaCompiler], but beside the caller and within a time limit. */
class TimedJavaCompiler internal constructor(private val ecj: TimedEcj, private val messages: JavaMessages) {
    /** Returns this compiler with [messages] in another language. */
    fun withLanguage(messages: JavaMessages): TimedJavaCompiler = TimedJavaCompiler(ecj, messages)

    /**
     * The same as [JavaCompiler.compile]; null if it takes too long.
     *
     * @throws CompilerNotLoadedException if the compiler cannot be loaded.
     */
    suspend fun compile(
        sources: List<SourceFile>,
        library: Map<String, ByteArray>,
        missing: List<LejosDifference> = emptyList(),
        target: BrickTarget = BrickTarget.LEJOS_RCX,
    ): CompilationResult? = compilation(sources, library, missing, target, messages) { texts, gaps ->
        ecj.compile(texts, library, gaps, target) ?: return null
    }
}

/** The compiler cannot be loaded, for example because the browser is offline and has never fetched it. */
class CompilerNotLoadedException(message: String, cause: Throwable? = null) : Exception(message, cause)

/** The timed compiler of this platform; null where there is none, such as in a worker. */
expect fun timedJavaCompiler(messages: JavaMessages): TimedJavaCompiler?
