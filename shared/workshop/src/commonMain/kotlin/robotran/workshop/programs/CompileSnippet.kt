package robotran.workshop.programs

import robotran.blockediting.BlockEditError
import robotran.blockediting.SnippetProgram
import robotran.blockediting.snippetOf
import robotran.programs.Program
import robotran.programs.ProgramResult
import robotran.programs.blockLanguage
import robotran.programs.support
import robotran.projects.target
import robotran.workshop.blocks.DragPayload
import robotran.workshop.state.Snippet
import robotran.workshop.state.asSnippet

/** The program that does [load] of the shown one alone; null if there can be none, and then the blocks say why. */
internal fun AllPrograms.compileSnippet(load: DragPayload): Snippet? {
    val robot = shown
    val now = robot.editorState
    val blocks =
        now.blocks?.takeIf { now.view.hasBlocks && robot.entry.program.language.support.hasBlocks } ?: return null

    fun refused(reason: BlockEditError): Snippet? {
        val said = now.copy(blocks = blocks.copy(error = reason))
        robot.list.change(robot.shownProgram, robot.entry.with(robot.shownFile, said))
        return null
    }
    val snippet = when (load) {
        is DragPayload.Blocks -> snippetOf(blocks.program, load.run)
        is DragPayload.New -> snippetOf(blocks.program, load.block.textFor(blocks.program))
        is DragPayload.Value -> SnippetProgram.Failure(BlockEditError.NothingToTry)
    }
    val text = when (snippet) {
        is SnippetProgram.Success -> snippet.text
        is SnippetProgram.Failure -> return refused(snippet.reason)
    }
    val program = Program(robot.entry.program.name, blockLanguage, text)
    return when (val result = compiler.forTarget(robot.placement.description.target).compileNow(program)) {
        is ProgramResult.Success ->
            asSnippet(result.program, robot.placement.name, robot.shownProgram, now.draft.text)

        is ProgramResult.Failure -> with(result.diagnostics.first()) {
            refused(BlockEditError.CompileError(range?.line ?: 0, message))
        }
    }
}
