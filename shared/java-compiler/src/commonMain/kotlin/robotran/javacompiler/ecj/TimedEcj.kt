package robotran.javacompiler.ecj

/**
 * ECJ beside the caller, which is free meanwhile. No bound on a source is a bound on what a compiler makes of it, so this
 * ends a compilation that takes too long.
 */
internal interface TimedEcj {
    /**
     * The same as [Ecj.compile].
     *
     * @return null if it took too long, or more memory than there is.
     * @throws robotran.javacompiler.CompilerNotLoadedException if ECJ cannot be loaded.
     */
    suspend fun compile(
        sources: List<JavaSource>,
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
