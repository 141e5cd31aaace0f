package robotran.javacompiler.ecj

import kotlinx.coroutines.sync.Mutex
import kotlinx.coroutines.sync.withLock
import robotran.languagesupport.SourceFile

/**
 * ECJ beside the caller, which is free meanwhile. No bound on a source is a bound on what a compiler makes of it, so this
 * ends a compilation that takes too long. A compiler takes only one program at a time, and those who wait lose none of
 * their time.
 */
internal abstract class TimedEcj {
    private val compiling = Mutex()

    /**
     * The same as [Ecj.compile].
     *
     * @return null if it took too long, or more memory than there is.
     * @throws robotran.javacompiler.CompilerNotLoadedException if ECJ cannot be loaded.
     */
    suspend fun compile(
        sources: List<SourceFile>,
        library: Map<String, ByteArray>,
        gaps: Set<String>,
        target: BrickTarget,
    ): EcjCompilation? = compiling.withLock { compileNow(sources, library, gaps, target) }

    /** The same as [compile], while no other program is compiled. */
    protected abstract suspend fun compileNow(
        sources: List<SourceFile>,
        library: Map<String, ByteArray>,
        gaps: Set<String>,
        target: BrickTarget,
    ): EcjCompilation?

    companion object {
        /**
         * In milliseconds. A hundred times what a long program takes on a fast machine, and ten times on the slowest
         * tablet.
         */
        const val MAX_TIME = 20_000L
    }
}
