package robotran.workshop.programs

import robotran.blockediting.BlockEditError
import robotran.blockediting.TrialResult
import robotran.blockediting.trialOf
import robotran.brick.program.BrickProgram
import robotran.programs.Program
import robotran.programs.ProgramCompiler
import robotran.programs.ProgramResult
import robotran.programs.blockLanguage
import robotran.workshop.blocks.BlockLoad
import robotran.workshop.blocks.BlocksState

/** The result of [compileAlone]. */
internal sealed interface ImmediateResult {
    class Ready(val program: BrickProgram) : ImmediateResult

    class Refused(val reason: BlockEditError) : ImmediateResult
}

/** Compiles a program of [load] alone, as the program [name]. */
internal fun ProgramCompiler.compileAlone(load: BlockLoad, blocks: BlocksState, name: String): ImmediateResult {
    val trial = when (load) {
        is BlockLoad.Blocks -> trialOf(blocks.program, load.run)
        is BlockLoad.New -> trialOf(blocks.program, load.block.textFor(blocks.program))
        is BlockLoad.Value -> TrialResult.Refused(BlockEditError.NothingToTry)
    }
    if (trial is TrialResult.Refused) return ImmediateResult.Refused(trial.reason)
    val text = (trial as TrialResult.Ready).text
    return when (val result = compileNow(Program(name, blockLanguage, text))) {
        is ProgramResult.Ready -> ImmediateResult.Ready(result.program)

        is ProgramResult.HasErrors -> with(result.diagnostics.first()) {
            ImmediateResult.Refused(BlockEditError.Mistaken(range?.line ?: 0, message))
        }
    }
}
