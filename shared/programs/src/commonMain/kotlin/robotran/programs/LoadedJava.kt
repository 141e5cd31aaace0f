package robotran.programs

import robotran.javacompiler.JavaCompiler
import robotran.javacompiler.TimedJavaCompiler
import robotran.javacompiler.loadJavaCompiler
import robotran.javacompiler.messages.JavaMessages
import robotran.javacompiler.timedJavaCompiler
import robotran.language.Language
import robotran.nxjlibrary.NxjLibrary

/**
 * What compiling Java needs, as far as it has been loaded.
 *
 * @param compilesBeside whether a compiler may work beside the caller.
 */
internal class LoadedJava(private val compilesBeside: Boolean) {
    /** With messages in any language. */
    var compiler: JavaCompiler? = null
        private set

    /** Compiles beside the caller; null where only the caller can. */
    val timedCompiler: TimedJavaCompiler? by lazy {
        if (compilesBeside) timedJavaCompiler(messages = JavaMessages.of(Language.ENGLISH)) else null
    }

    var nxj: NxjLibrary? = null
        private set

    suspend fun loadCompiler(): JavaCompiler =
        compiler ?: loadJavaCompiler(messages = JavaMessages.of(Language.ENGLISH)).also { compiler = it }

    suspend fun loadNxj() {
        if (nxj == null) nxj = NxjLibrary.load()
    }
}
