package robotran.programs

import robotran.legofirmware.assembly.AssemblyResult
import robotran.legofirmware.assembly.assemble

internal class LasmProgramCompiler(private val settings: CompilerSettings) : LanguageCompiler {
    override fun compile(program: Program): ProgramResult =
        when (val result = assemble(program.text, settings.language, settings.firmware.target)) {
            is AssemblyResult.Failure -> ProgramResult.Failure(result.diagnostics.map { named(program, it) })

            is AssemblyResult.Success -> ready(
                program.name,
                result.image,
                result.lines,
                result.warnings.map { named(program, it) },
                settings.language,
            )
        }
}
