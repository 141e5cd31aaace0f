package robotran.programs

import robotran.robolang.RobolangResult
import robotran.robolang.compileRobolang
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.robot.RobotTarget

internal class RobolangProgramCompiler(private val target: RobotTarget, private val messages: RobolangMessages) {
    fun read(source: ProgramSource.Robolang): ProgramResult =
        when (val result = compileRobolang(source.name, source.text, target, messages)) {
            is RobolangResult.Ready -> ProgramResult.Ready(result.program, result.warnings)
            is RobolangResult.HasErrors -> ProgramResult.HasErrors(result.diagnostics)
        }
}
