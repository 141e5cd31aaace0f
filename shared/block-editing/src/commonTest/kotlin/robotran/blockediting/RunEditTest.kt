package robotran.blockediting

import robotran.language.Language
import robotran.robolang.messages.RobolangMessages
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class RunEditTest {
    @Test
    fun `a block of the palette goes before, behind and into other blocks`() {
        assertEquals("stop\nbeep\n", after("beep\n") { BlockEdit.Insert("stop", at("beep")) })
        assertEquals("beep\nstop\n", after("beep\n") { BlockEdit.Insert("stop", behind("beep")) })
        assertEquals("beep\nstop", after("beep") { BlockEdit.Insert("stop\n", behind("beep")) })
        assertEquals(
            "repeat 4 times\n  beep\nend\n",
            after("repeat 4 times\nend\n") {
                BlockEdit.Insert("beep", inside("repeat"))
            },
        )
        assertEquals("beep\n", after("") { BlockEdit.Insert("beep", BlockPlace(null, 0, 0)) })
        assertEquals("a()\r\nbeep\r\n", after("a()\r\n") { BlockEdit.Insert("beep", behind("a()")) })
    }

    @Test
    fun `an inserted block is indented like its neighbours, and nothing else changes`() {
        val expected = SQUARE.replace("    turn", "    repeat 2 times\n      beep\n    end\n    turn")
        val program = blocksOf(SQUARE, messages = RobolangMessages.of(Language.ENGLISH))
        val result = program.done(BlockEdit.Insert("repeat 2 times\n  beep\nend", program.at("turn")))
        assertEquals(expected, result.program.text)
        assertEquals("repeat 2 times\n      beep\n    end", result.selection.textIn(expected))
        assertEquals(listOf(result.program.idOf("repeat 2")), result.selected)
    }

    @Test
    fun `one block moves alone, with its comment and its odd spaces`() {
        assertEquals(
            "pen down // start\n\nrepeat 4 times   // sides\n    turn left 90\nend\nforward  20\nbeep\n",
            after(SQUARE) { BlockEdit.Move(BlockRun(idOf("forward")), at("beep")) },
        )
        assertEquals(
            "\nrepeat 4 times   // sides\n    pen down // start\n    forward  20\n    turn left 90\nend\nbeep\n",
            after(SQUARE) { BlockEdit.Move(BlockRun(idOf("pen")), inside("repeat")) },
        )
    }

    @Test
    fun `a stack moves with all behind it`() {
        assertEquals(
            "repeat 2 times\n  beep\n  if left bumper\n    stop\n  end\n  buzz\nend\n",
            after("repeat 2 times\n  beep\nend\nif left bumper\n  stop\nend\nbuzz\n") {
                BlockEdit.Move(BlockRun.stack(idOf("if")), behind("beep"))
            },
        )
    }

    @Test
    fun `each moved line is a change of its own, so that those between keep their places`() {
        val program =
            blocksOf("beep\nforward 1\nforward 2\nforward 3\n", messages = RobolangMessages.of(Language.ENGLISH))
        val result = program.done(BlockEdit.Move(BlockRun(program.idOf("beep")), program.behind("forward 3")))
        assertEquals(listOf("beep\n" to "", "" to "beep\n"), result.changes.map { it.removed to it.inserted })
    }

    @Test
    fun `the last line moves although it has no line break`() {
        assertEquals("stop\nbeep", after("beep\nstop") { BlockEdit.Move(BlockRun(idOf("stop")), at("beep")) })
        assertEquals("stop\nbeep", after("beep\nstop") { BlockEdit.Move(BlockRun(idOf("beep")), behind("stop")) })
        assertEquals("beep", after("beep\nstop") { BlockEdit.Delete(setOf(idOf("stop"))) })
    }

    @Test
    fun `a block cannot move into itself, and stays where it is next to itself`() {
        assertEquals(
            BlockEditError.IntoItself,
            editError(SQUARE) {
                BlockEdit.Move(BlockRun(idOf("repeat")), inside("repeat"))
            },
        )
        val program = blocksOf(SQUARE, messages = RobolangMessages.of(Language.ENGLISH))
        assertTrue(
            program.done(BlockEdit.Move(BlockRun(program.idOf("turn")), program.behind("turn"))).changes.isEmpty(),
        )
    }

    @Test
    fun `a block that lacks its end gets it when something goes behind it`() {
        assertEquals(
            "repeat 4 times\n  beep\nend\nstop",
            after("repeat 4 times\n  beep") { BlockEdit.Insert("stop", behind("repeat")) },
        )
        assertEquals(
            "stop\nrepeat 4 times\n  beep\nend\n",
            after("repeat 4 times\n  beep\n") { BlockEdit.Insert("stop", at("repeat")) }.let {
                after(it) { BlockEdit.Duplicate(BlockRun(idOf("repeat"))) }
            }.substringBeforeLast("repeat"),
        )
    }

    @Test
    fun `blocks that stand outside of others cannot go inside`() {
        val text = "procedure p()\nend\nrepeat 2 times\nend\n"
        assertEquals(
            BlockEditError.OnlyOutermost,
            editError(text) {
                BlockEdit.Move(BlockRun(idOf("procedure")), inside("repeat"))
            },
        )
        assertEquals(
            BlockEditError.OnlyOutermost,
            editError(text) {
                BlockEdit.Insert("whenever left bumper\nend", inside("repeat"))
            },
        )
        val robot = "robot\n  light sensor on 2 facing down\nend\nbeep\n"
        assertEquals(
            BlockEditError.OnlySettings,
            editError(robot) {
                BlockEdit.Move(BlockRun(idOf("beep")), inside("robot"))
            },
        )
        assertEquals(
            BlockEditError.SettingOutsideRobot,
            editError(robot) {
                BlockEdit.Move(BlockRun(idOf("light")), at("beep"))
            },
        )
        assertEquals(BlockEditError.SettingOutsideRobot, editError(robot) { BlockEdit.Unwrap(idOf("robot")) })
        assertEquals(BlockEditError.SecondRobot, editError(robot) { BlockEdit.Duplicate(BlockRun(idOf("robot"))) })
    }

    @Test
    fun `a loose end is not put where it would close another block`() {
        val text = "end\nrepeat 2 times\n  beep\nend\n"
        assertEquals(
            BlockEditError.LooseEnd,
            editError(text) {
                BlockEdit.Move(BlockRun(idOf("end")), inside("repeat"))
            },
        )
    }

    @Test
    fun `blocks nested too deeply are refused`() {
        val text = "repeat 2 times\n".repeat(100) + "beep\n" + "end\n".repeat(100)
        assertEquals(BlockEditError.TooDeep, editError(text) { BlockEdit.Insert("repeat 2 times\nend", at("beep")) })
    }

    @Test
    fun `blocks are duplicated and deleted`() {
        assertEquals("beep // hi\nbeep // hi\n", after("beep // hi\n") { BlockEdit.Duplicate(BlockRun(idOf("beep"))) })
        assertEquals(
            "pen down // start\n\n",
            after(SQUARE) {
                BlockEdit.Delete(setOf(idOf("repeat"), idOf("turn"), idOf("beep")))
            },
        )
        assertEquals("", after("beep\n") { BlockEdit.Delete(setOf(idOf("beep"))) })
    }

    @Test
    fun `copied blocks are Robolang, and pasted they are the same blocks`() {
        val program =
            blocksOf(
                "repeat 2 times\r\n\tif left bumper // hit\r\n\t\tbeep\r\n\tend\r\nend\r\n",
                messages = RobolangMessages.of(Language.ENGLISH),
            )
        val copy = copied(program, BlockRun(program.idOf("if")))
        assertEquals("if left bumper // hit\n\tbeep\nend\n", copy)
        val pasted = program.done(BlockEdit.Insert(checkNotNull(copy), program.at("repeat"))).program
        assertEquals("if left bumper // hit\r\n\tbeep\r\nend\r\n" + program.text, pasted.text)
        val open = blocksOf("repeat 2 times\n  beep\n", messages = RobolangMessages.of(Language.ENGLISH))
        assertEquals("repeat 2 times\n  beep\nend\n", copied(open, BlockRun(open.idOf("repeat"))))
    }

    @Test
    fun `nothing is inserted by nothing, and unknown blocks are not found`() {
        assertEquals(BlockEditError.NothingToInsert, editError("beep\n") { BlockEdit.Insert("", at("beep")) })
        assertEquals(BlockEditError.NotFound, editError("beep\n") { BlockEdit.Delete(setOf(BlockId(99))) })
        assertEquals(BlockEditError.NotFound, editError("beep\n") { BlockEdit.Insert("stop", BlockPlace(null, 0, 7)) })
        assertEquals(BlockEditError.NotFound, editError("beep\n") { BlockEdit.SetNote(1, "x") })
    }
}
