package robotran.workshop.blocks

import robotran.assignments.doing.forbiddenWords
import robotran.blockediting.palette.Palette
import robotran.blockediting.palette.PaletteBlock
import robotran.brick.kind.BrickKind
import robotran.programs.Program
import robotran.programs.blockLanguage
import robotran.projects.Assignment
import robotran.projects.ProjectProgram
import robotran.robolang.words.BlockGroup

/** The ids of the palette's blocks that [assignment] allows; null for all. */
fun allowedBlocks(assignment: Assignment): Set<String>? {
    if (assignment.words.isEmpty()) return null
    return BrickKind.entries.flatMap(Palette::blocksFor).filter {
        forbiddenWords(assignment, listOf(programOf(it))).isEmpty()
    }.mapTo(mutableSetOf()) { it.id }
}

/** The words with which an assignment allows all blocks of [group]; empty if the group has none that can be forbidden. */
fun wordsOf(group: BlockGroup): Set<String> = WORDS.getValue(group)

private val WORDS: Map<BlockGroup, Set<String>> by lazy {
    // Nothing is allowed, so that all words of a block are forbidden.
    val nothing = Assignment("", words = listOf(""))
    BlockGroup.entries.associateWith { group ->
        forbiddenWords(nothing, Palette.blocksOf(group, BrickKind.default).map(::programOf)).toSet()
    }
}

private fun programOf(block: PaletteBlock) = ProjectProgram(Program("", blockLanguage, block.template))
