package robotran.programs

/** The result of [ProgramCompiler.compile]. */
sealed interface TimedCompilation {
    data class Compiled(val result: ProgramResult) : TimedCompilation

    /** A compiler could not be loaded; see [CompilerLoading.Failure]. */
    class NotLoaded(val cause: Throwable) : TimedCompilation
}

/** The result of loading a compiler. */
sealed interface CompilerLoading {
    /** The compiler is loaded, or none is needed. */
    data object Success : CompilerLoading

    /**
     * Loading failed, for example because the browser is offline and has never fetched the Java compiler.
     *
     * @property cause the platform's exception.
     */
    class Failure(val cause: Throwable) : CompilerLoading
}
