package robotran.blockediting

import robotran.blockediting.describe.BlockRole
import robotran.blockediting.describe.describe
import robotran.blockediting.describe.describeChange
import robotran.blockediting.messages.BlockMessages
import robotran.language.Language
import robotran.robolang.messages.RobolangMessages
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNull

class DescriptionTest {
    private val english = BlockMessages.of(Language.ENGLISH)
    private val text =
        "beep\nif left bumper\n  repeat 4 times // sides\n    forward 20\n    turn  left 90\n    beep\n  end\n" +
            "else\n  forwrd 5\nend\n"

    private fun said(line: String, language: Language): String? {
        val program = blocksOf(text, RobolangMessages.of(language))
        return describe(program, program.idOf(line), BlockMessages.of(language))?.sentence
    }

    @Test
    fun `a block says its line, its level and how many are inside`() {
        assertEquals("repeat 4 times, level 2, 3 blocks inside, note: sides", said("repeat", Language.ENGLISH))
        assertEquals("repeat 4 times, Ebene 2, 3 Blöcke darin, Notiz: sides", said("repeat", Language.GERMAN))
        assertEquals("repeat 4 times, nivel 2, 3 bloques dentro, nota: sides", said("repeat", Language.SPANISH))
        assertEquals("forward 20 cm, level 3", said("forward", Language.ENGLISH))
        assertEquals("turn left 90 degrees, level 3", said("turn", Language.ENGLISH))
    }

    @Test
    fun `a loose line says its mistake`() {
        val sentence =
            "line with a mistake: forwrd 5. There is no command \"forwrd\". Did you mean \"forward\"?, level 2"
        assertEquals(sentence, said("forwrd", Language.ENGLISH))
    }

    @Test
    fun `a block says where it is`() {
        val program = blocksOf(text, messages = RobolangMessages.of(Language.ENGLISH))
        val turn = checkNotNull(describe(program, program.idOf("turn"), BlockMessages.of(Language.ENGLISH)))
        assertEquals(listOf(3, 2, 3), listOf(turn.level, turn.position, turn.siblings))
        assertEquals("in repeat 4 times", turn.context)
        assertEquals("turn left 90 degrees", turn.words)
        assertEquals(BlockRole.TREE_ITEM, turn.role)
        val loose = checkNotNull(describe(program, program.idOf("forwrd"), BlockMessages.of(Language.GERMAN)))
        assertEquals("in else", loose.context)
    }

    @Test
    fun `a branch says its line and how many blocks are in it`() {
        val program = blocksOf(text, messages = RobolangMessages.of(Language.ENGLISH))
        val branch = describe(program, program.idOf("if"), slot = 1, BlockMessages.of(Language.GERMAN))
        assertEquals("else, Ebene 1, 1 Block darin", branch?.sentence)
        assertEquals("else, 1 Block darin", branch?.words)
        assertEquals("in if left bumper", branch?.context)
        assertNull(describe(program, program.idOf("if"), slot = 2, BlockMessages.of(Language.GERMAN)))
    }

    @Test
    fun `an edit is told with what it was about and where that is now`() {
        val program = blocksOf(text, messages = RobolangMessages.of(Language.ENGLISH))

        fun described(edit: BlockEdit, language: Language = Language.ENGLISH) =
            describe(program, edit, program.done(edit), BlockMessages.of(language))
        val beep = BlockRun(program.idOf("beep"))
        val inRepeat = BlockPlace(program.idOf("repeat"), 0, 1)
        assertEquals("Moved: beep, 2 of 4 in repeat 4 times", described(BlockEdit.Move(beep, inRepeat)))
        assertEquals(
            "Verschoben: beep, 2 von 4 in repeat 4 times",
            described(BlockEdit.Move(beep, inRepeat), Language.GERMAN),
        )
        assertEquals("Added: 2 blocks, 1 of 4", described(BlockEdit.Insert("buzz\nstop\n", BlockPlace(null, 0, 0))))
        assertEquals("Duplicated: beep, 2 of 3", described(BlockEdit.Duplicate(beep)))
        assertEquals("Deleted: forward 20 cm", described(BlockEdit.Delete(setOf(program.idOf("forward")))))
        assertEquals("Now: forward 35 cm", described(BlockEdit.Replace(program.span("20"), "35")))
    }

    @Test
    fun `what undo has changed is told, with the place where it is now`() {
        val program = blocksOf(text, messages = RobolangMessages.of(Language.ENGLISH))

        /** What is told when [edit] is undone, and when it is redone. */
        fun described(edit: BlockEdit): Pair<String?, String?> {
            val edited = program.done(edit).program
            val undone = blocksOf(program.text, previous = edited, messages = RobolangMessages.of(Language.ENGLISH))
            return describeChange(edited, undone, english) to
                describeChange(
                    undone,
                    blocksOf(edited.text, previous = undone, messages = RobolangMessages.of(Language.ENGLISH)),
                    english,
                )
        }
        val beep = BlockRun(program.idOf("beep"))
        assertEquals(
            "Now: beep, 1 of 2" to "Now: beep, 2 of 4 in repeat 4 times",
            described(BlockEdit.Move(beep, BlockPlace(program.idOf("repeat"), 0, 1))),
        )
        assertEquals("Now: beep, 1 of 2" to "Gone: beep", described(BlockEdit.Delete(setOf(program.idOf("beep")))))
        val two = BlockEdit.Insert("buzz\nstop\n", BlockPlace(null, 0, 0))
        assertEquals("Gone: 2 blocks" to "Now: 2 blocks, 1 of 4", described(two))
        assertEquals(
            "Now: forward 20 cm, 1 of 3 in repeat 4 times" to "Now: forward 35 cm, 1 of 3 in repeat 4 times",
            described(BlockEdit.Replace(program.span("20"), "35")),
        )
        assertEquals(
            "Now: if left bumper, 2 of 2" to "Gone: if left bumper",
            described(BlockEdit.Delete(setOf(program.idOf("if")))),
        )
        val loop = program.idOf("repeat")
        assertEquals("Gone: else" to "Now: else", toldOfElse())
        assertEquals("Now: repeat 4 times, 1 of 1 in if left bumper", described(BlockEdit.Delete(setOf(loop))).first)
        assertNull(
            describeChange(
                program,
                blocksOf(
                    text.replace("beep\nif", "  beep\nif"),
                    previous = program,
                    messages = RobolangMessages.of(Language.ENGLISH),
                ),
                english,
            ),
        )
    }

    private fun toldOfElse(): Pair<String?, String?> {
        val plain = blocksOf("if left bumper\n  beep\nend\n", messages = RobolangMessages.of(Language.ENGLISH))
        val branched = plain.done(BlockEdit.AddElse(plain.idOf("if"))).program
        val undone = blocksOf(plain.text, previous = branched, messages = RobolangMessages.of(Language.ENGLISH))
        return describeChange(branched, undone, english) to
            describeChange(
                undone,
                blocksOf(branched.text, previous = undone, messages = RobolangMessages.of(Language.ENGLISH)),
                english,
            )
    }

    @Test
    fun `parts of a line say what they are and what can be chosen`() {
        val program = blocksOf("turn left 90\n", messages = RobolangMessages.of(Language.ENGLISH))
        val said = program.blocks.single().head.parts.map { describe(program, it, BlockMessages.of(Language.ENGLISH)) }
        assertEquals(listOf("turn", "left, choose left or right", "90 degrees, number"), said.map { it.sentence })
        assertEquals(listOf(BlockRole.TEXT, BlockRole.MENU, BlockRole.INPUT), said.map { it.role })
    }
}
