package robotran.programs

import robotran.javacompiler.JavaCompiler
import robotran.javacompiler.loadJavaCompiler
import robotran.nxjlibrary.NxjLibrary

/** What compiling Java needs, as far as it has been loaded. */
internal class LoadedJava {
    /** With messages in any language. */
    var compiler: JavaCompiler? = null
        private set

    var nxj: NxjLibrary? = null
        private set

    suspend fun loadCompiler() {
        if (compiler == null) compiler = loadJavaCompiler()
    }

    suspend fun loadNxj() {
        if (nxj == null) nxj = NxjLibrary.load()
    }
}
