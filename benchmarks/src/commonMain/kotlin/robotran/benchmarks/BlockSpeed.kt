package robotran.benchmarks

import robotran.blockediting.BlockEdit
import robotran.blockediting.BlockEditResult
import robotran.blockediting.BlockPlace
import robotran.blockediting.BlockProgram
import robotran.blockediting.BlockRun
import robotran.blockediting.apply
import robotran.blockediting.blocksOf
import robotran.language.Language
import robotran.robolang.messages.RobolangMessages
import kotlin.time.DurationUnit

/** The time to read a long program as blocks. */
internal suspend fun blocksTime(): Measurement {
    val program = longProgram()
    return milliseconds(program) { blocksOf(program.text, messages = RobolangMessages.of(Language.ENGLISH)) }
}

/** The time to move a block in a long program. */
internal suspend fun blockEditTime(): Measurement {
    val program = longProgram()
    val edit = BlockEdit.Move(BlockRun(program.blocks.last().id), BlockPlace(parent = null, slot = 0, index = 1))
    return milliseconds(program) { check(apply(program, edit) is BlockEditResult.Success) }
}

private fun milliseconds(program: BlockProgram, work: () -> Unit): Measurement {
    val time = median(RUNS, work).toDouble(DurationUnit.MILLISECONDS)
    return Measurement(time, "ms", "${program.outline.lines.size} lines, ${program.all.size} blocks")
}

private fun longProgram(): BlockProgram =
    blocksOf(programOfLines(LINES), messages = RobolangMessages.of(Language.ENGLISH))

/** As long as a file may be that the editor of texts is measured with. */
private const val LINES = 2_000

/** Enough for the JVM to compile what it runs. */
private const val RUNS = 100
