package robotran.programs

/** What came of loading a compiler. */
sealed interface CompilerLoading {
    /** It is there, or none is needed. */
    data object Loaded : CompilerLoading

    /**
     * It could not be loaded, as when a browser is offline before the compiler for Java was ever fetched.
     *
     * @property cause what the platform says.
     */
    class Failed(val cause: Throwable) : CompilerLoading
}
