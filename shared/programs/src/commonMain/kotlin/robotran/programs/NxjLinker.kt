package robotran.programs

import robotran.nxjlibrary.NxjLibrary
import robotran.tinyvm.NxjResult
import robotran.tinyvm.config.TinyVmSpeed
import robotran.tinyvm.linkNxj
import robotran.tinyvm.messages.TinyVmMessages

/** Links class files for an NXT with leJOS NXJ. */
internal class NxjLinker(
    private val library: NxjLibrary,
    private val speed: TinyVmSpeed,
    private val messages: TinyVmMessages,
) : ProgramLinker {
    override fun link(program: CompiledProgram): ProgramResult = with(program) {
        when (val result = linkNxj(name, classFiles, library.classFiles, mainClass, messages, speed)) {
            is NxjResult.Ready -> ProgramResult.Ready(result.program, warnings, mainClass)
            is NxjResult.Rejected -> ProgramResult.HasErrors(listOf(locate(result.refusal)))
        }
    }
}
