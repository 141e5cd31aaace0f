package robotran.programs

/** Makes a program for a simulated brick of class files. */
internal fun interface ProgramLinker {
    fun link(program: CompiledProgram): ProgramResult
}
