package robotran.workshop.programs

import robotran.blockediting.BlockEditError
import robotran.blockediting.SnippetProgram
import robotran.blockediting.snippetOf
import robotran.brick.program.BrickProgram
import robotran.programs.Program
import robotran.programs.ProgramCompiler
import robotran.programs.ProgramResult
import robotran.programs.blockLanguage
import robotran.workshop.blocks.BlocksState
import robotran.workshop.blocks.DragPayload

/** The result of [compileSnippet]. */
internal sealed interface SnippetResult {
    class Success(val program: BrickProgram) : SnippetResult

    class Failure(val reason: BlockEditError) : SnippetResult
}

/** Compiles a program of [load] alone, as the program [name]. */
internal fun ProgramCompiler.compileSnippet(load: DragPayload, blocks: BlocksState, name: String): SnippetResult {
    val trial = when (load) {
        is DragPayload.Blocks -> snippetOf(blocks.program, load.run)
        is DragPayload.New -> snippetOf(blocks.program, load.block.textFor(blocks.program))
        is DragPayload.Value -> SnippetProgram.Failure(BlockEditError.NothingToTry)
    }
    if (trial is SnippetProgram.Failure) return SnippetResult.Failure(trial.reason)
    val text = (trial as SnippetProgram.Success).text
    return when (val result = compileNow(Program(name, blockLanguage, text))) {
        is ProgramResult.Success -> SnippetResult.Success(result.program)

        is ProgramResult.Failure -> with(result.diagnostics.first()) {
            SnippetResult.Failure(BlockEditError.CompileError(range?.line ?: 0, message))
        }
    }
}
