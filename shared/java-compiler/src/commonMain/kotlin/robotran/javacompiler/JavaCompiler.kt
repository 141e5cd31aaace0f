package robotran.javacompiler

import robotran.javacompiler.diagnose.Diagnosis
import robotran.javacompiler.diagnose.JavaSeverity
import robotran.javacompiler.ecj.Ecj
import robotran.javacompiler.ecj.JavaSource
import robotran.javacompiler.messages.EnglishJavaMessages
import robotran.javacompiler.messages.JavaMessages

/**
 * Compiles leJOS programs: Java as it was in version 1.3, for the virtual machine of a brick. The same class files on
 * every platform.
 */
class JavaCompiler internal constructor(private val ecj: Ecj, private val messages: JavaMessages) {
    /** The same compiler, telling mistakes in another language. */
    fun withLanguage(messages: JavaMessages): JavaCompiler = JavaCompiler(ecj, messages)

    /**
     * Compiles all [sources] together. Never throws, whatever they hold, and takes bounded time, since long sources are
     * refused.
     *
     * @param library the class files of the brick's class library by internal name, such as `java/lang/Object`. It must
     * not change; give the same map again and its classes are read only once.
     */
    fun compile(sources: List<JavaSource>, library: Map<String, ByteArray>): CompilationResult {
        val texts = sources.map { it.copy(text = it.text.removePrefix(BYTE_ORDER_MARK)) }
        val compilation = ecj.compile(texts, library)
        val diagnosis = Diagnosis(texts, library.keys, compilation, messages)
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

    private companion object {
        const val BYTE_ORDER_MARK = "\uFEFF"
    }
}

/**
 * The compiler of this platform: at once on the JVM and Android; in the browser it loads the compiler's module first,
 * and throws if it cannot.
 *
 * @param messages the language that mistakes are told in.
 */
expect suspend fun loadJavaCompiler(messages: JavaMessages = EnglishJavaMessages): JavaCompiler
