package robotran.programs

import robotran.javacompiler.messages.JavaMessages
import robotran.nxjlibrary.NxjLibrary
import robotran.tinyvm.NxjResult
import robotran.tinyvm.config.TinyVmMode
import robotran.tinyvm.linkNxj
import robotran.tinyvm.messages.TinyVmMessages

/** Links class files for an NXT with leJOS NXJ. */
internal class NxjLinker(
    private val library: NxjLibrary,
    private val java: JavaSettings,
    private val messages: TinyVmMessages,
) : ProgramLinker {
    /** Links what another compiler made, unless it uses what leJOS NXJ lacks and the [mode] is true to the brick. */
    fun link(source: ProgramSource.CompiledClasses, mode: TinyVmMode, messages: JavaMessages): ProgramResult {
        val result = link(compiledOf(source))
        if (result !is ProgramResult.Success || mode == TinyVmMode.FORGIVING) return result
        val errors = CompiledNxjGaps(library, messages).find(source.classFiles)
        return if (errors.isEmpty()) result else ProgramResult.Failure(errors)
    }

    override fun link(program: CompiledProgram): ProgramResult = with(program) {
        when (val result = linkNxj(name, classFiles, library.classFiles, mainClass, messages, java.speed, java.mode)) {
            is NxjResult.Success -> ProgramResult.Success(result.program, warnings, mainClass)
            is NxjResult.Failure -> ProgramResult.Failure(listOf(locate(result.refusal)))
        }
    }
}
