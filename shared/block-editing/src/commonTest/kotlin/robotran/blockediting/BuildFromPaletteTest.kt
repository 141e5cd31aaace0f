package robotran.blockediting

import robotran.blockediting.palette.Palette
import robotran.blockediting.palette.ownBlocks
import robotran.language.Language
import robotran.robolang.format.FormatResult
import robotran.robolang.format.formatRobolang
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.outline.NameRole
import robotran.robolang.outline.OutlineLine
import robotran.robolang.outline.PhrasePart
import robotran.robolang.words.LineForm
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class BuildFromPaletteTest {
    @Test
    fun `every example and every solution can be built from the palette`() {
        val programs = examplePrograms + tutorialPrograms
        assertTrue(programs.size > 30, "${programs.size} programs")
        for ((name, text) in programs) {
            val target =
                blocksOf(
                    (
                        formatRobolang(
                            text,
                            messages = RobolangMessages.of(Language.ENGLISH),
                        ) as FormatResult.Success
                    ).text,
                    messages = RobolangMessages.of(Language.ENGLISH),
                )
            val built = try {
                Builder(target).build()
            } catch (failure: IllegalStateException) {
                throw AssertionError(name, failure)
            }
            assertEquals(
                target.text,
                (
                    formatRobolang(
                        built.text,
                        messages = RobolangMessages.of(Language.ENGLISH),
                    ) as FormatResult.Success
                ).text,
                name,
            )
            assertTrue(built.all.none { it is Block.Loose }, name)
        }
    }
}

/** Builds the program [target] block by block, as a pupil does it who never types a line. */
private class Builder(private val target: BlockProgram) {
    private var program = blocksOf("", messages = RobolangMessages.of(Language.ENGLISH))

    fun build(): BlockProgram {
        // Names come first, so that the palette has blocks for them.
        val (routines, others) = target.blocks.indices.partition { target.blocks[it].head.form in ROUTINES }
        val (names, rest) = others.partition { target.blocks[it].head.form in DECLARATIONS }
        val built = mutableListOf<Int>()

        fun place(index: Int) = BlockPlace(null, 0, built.count { it < index })
        val headers = (names + routines).associateWith { index ->
            begin(target.blocks[index], place(index)).also { built += index }
        }
        for (index in routines) finish(target.blocks[index] as Block.Construct, headers.getValue(index))
        for (index in rest) {
            build(target.blocks[index], place(index))
            built += index
        }
        return program
    }

    private fun edit(edit: BlockEdit): List<BlockId> = program.done(edit).also { program = it.program }.selected

    private fun text(line: OutlineLine): String = line.span.textIn(target.text).trim()

    private fun build(block: Block, place: BlockPlace) {
        val id = begin(block, place)
        if (block is Block.Construct) finish(block, id)
    }

    /** Takes a block from the palette and fills in its first line. */
    private fun begin(block: Block, place: BlockPlace): BlockId = when (block) {
        is Block.Blank -> edit(BlockEdit.Insert("\n", place)).single()
        is Block.Comment -> edit(BlockEdit.Insert(text(block.head), place)).single()
        is Block.Loose -> error("a mistake: ${text(block.head)}")

        is Block.Command, is Block.Construct -> {
            val id = edit(BlockEdit.Insert(template(block.head, place), place)).single()
            construct(id)?.slots?.single()?.blocks?.forEach { edit(BlockEdit.Delete(setOf(it.id))) }
            id.also { fill(it, block.head, slot = 0) }
        }
    }

    private fun construct(id: BlockId): Block.Construct? = program[id] as? Block.Construct

    /** Adds the branches of a construct and what is inside. */
    private fun finish(construct: Block.Construct, id: BlockId) {
        construct.slots.forEachIndexed { index, slot ->
            if (slot.head.form == LineForm.ELSE) edit(BlockEdit.AddElse(id))
            if (slot.head.form == LineForm.ELSE_IF) edit(BlockEdit.AddElse(id, "left bumper"))
            if (index > 0) fill(id, slot.head, index)
            slot.blocks.forEachIndexed { inner, block -> build(block, BlockPlace(id, index, inner)) }
        }
        note(construct.foot?.comment?.textIn(target.text)) { checkNotNull(construct(id)?.foot) }
    }

    private fun template(line: OutlineLine, place: BlockPlace): String {
        val id = checkNotNull(line.form).name.lowercase().replace('_', '-')
        val blocks = ownBlocks(program, place) + Palette.blocks
        val name = line.parts.filterIsInstance<PhrasePart.NamePart>().firstOrNull()?.span?.textIn(target.text)
        val block = blocks.firstOrNull { it.id == id && it.template.substringBefore('(') == name }
            ?: blocks.first { it.id == id }
        return block.textFor(program)
    }

    /** Gives the line of a new block the words, names and values of [wanted]. */
    private fun fill(id: BlockId, wanted: OutlineLine, slot: Int) {
        fun line() = program[id].let { (it as? Block.Construct)?.slots?.get(slot)?.head ?: checkNotNull(it).head }
        val parameters = wanted.parts.drop(2).filterIsInstance<PhrasePart.NamePart>().map {
            it.span.textIn(target.text)
        }
        if (wanted.parts.any { it is PhrasePart.NamePart && it.role == NameRole.DECLARES_ROUTINE }) {
            while (line().parts.count { it is PhrasePart.NamePart } > 1) {
                edit(BlockEdit.RemoveParameter(line().parts[1].span, 0))
            }
            for (name in parameters) edit(BlockEdit.AddParameter(line().parts[1].span, program.freeName(name)))
        }
        wanted.parts.forEachIndexed { index, part ->
            val now = line().parts.getOrNull(index) ?: return@forEachIndexed
            val text = part.span.textIn(target.text)
            if (now.span.textIn(program.text) != text) edit(BlockEdit.Replace(now.span, text.removeSurrounding("\"")))
        }
        note(wanted.comment?.textIn(target.text), ::line)
    }

    private fun note(comment: String?, line: () -> OutlineLine) {
        if (comment != null) edit(BlockEdit.SetNote(line().index, comment.removePrefix("//")))
    }

    private companion object {
        val ROUTINES = setOf(LineForm.PROCEDURE, LineForm.FUNCTION)
        val DECLARATIONS = setOf(LineForm.DECLARE_VARIABLE, LineForm.DECLARE_CONSTANT)
    }
}
