package robotran.programs

import robotran.languagesupport.ParsedSource

/** Compiles programs in one language for one robot. Not thread-safe. */
internal interface LanguageCompiler {
    /** Whether it tells by itself, as a mistake, that a program is for another brick. */
    val tellsOtherBrick: Boolean get() = false

    /** Compiles for somebody who waits; null if [compile] is fast enough for that. */
    val beside: CompilerBeside? get() = null

    /** Loads what [compile] needs. */
    suspend fun load() = Unit

    /** Compiles [program], after [load]. */
    fun compile(program: Program): ProgramResult

    /** The same for a program of which an editor has [read] the text. */
    fun compile(program: Program, read: ParsedSource): ProgramResult = compile(program)

    /** The class files of [program] for leJOS, with the compiler that [java] makes; only for languages of leJOS. */
    suspend fun compileToClasses(program: Program, java: suspend () -> TimedJavaProgramCompiler): CompiledSource =
        error("${program.name} is not for leJOS.")
}

/** A compiler that works beside the caller where it can, and within a time limit. */
internal interface CompilerBeside {
    /** Loads what [compile] cannot load itself. */
    suspend fun load()

    /** @throws robotran.javacompiler.CompilerNotLoadedException if it cannot load what it needs. */
    suspend fun compile(program: Program): ProgramResult
}
