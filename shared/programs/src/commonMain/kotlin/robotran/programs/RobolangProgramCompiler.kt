package robotran.programs

import robotran.robolang.RobolangResult
import robotran.robolang.compileRobolang
import robotran.robolang.diagnostic.Diagnostic
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.robot.RobotTarget

internal class RobolangProgramCompiler(private val target: RobotTarget, private val messages: RobolangMessages) {
    fun read(source: ProgramSource.Robolang): ProgramResult =
        when (val result = compileRobolang(source.name, source.text, target, messages)) {
            is RobolangResult.Ready -> ProgramResult.Ready(
                result.program,
                result.warnings.map {
                    diagnosticOf(source.name, it)
                },
            )

            is RobolangResult.HasErrors -> ProgramResult.HasErrors(
                result.diagnostics.map {
                    diagnosticOf(source.name, it)
                },
            )
        }
}

internal fun diagnosticOf(file: String, diagnostic: Diagnostic) = ProgramDiagnostic(
    file,
    diagnostic.range,
    diagnostic.message,
    diagnostic.fix,
)
