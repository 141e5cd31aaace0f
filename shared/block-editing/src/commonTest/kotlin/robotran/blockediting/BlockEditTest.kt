package robotran.blockediting

import robotran.robolang.outline.SourceSpan
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

class BlockEditTest {
    private val square = "pen down // start\n\nrepeat 4 times   // sides\n    forward  20\n    turn left 90\nend\nbeep\n"

    private fun BlockProgram.span(text: String): SourceSpan =
        this.text.indexOf(text).let { SourceSpan(it, it + text.length) }

    private fun after(text: String, edit: BlockProgram.() -> BlockEdit): String = blocksOf(text).let { it.done(it.edit()).program.text }

    private fun refusal(text: String, edit: BlockProgram.() -> BlockEdit): BlockRefusal = blocksOf(text).let { it.refusal(it.edit()) }

    @Test
    fun `a block of the palette goes before, behind and into other blocks`() {
        assertEquals("stop\nbeep\n", after("beep\n") { BlockEdit.Insert("stop", at("beep")) })
        assertEquals("beep\nstop\n", after("beep\n") { BlockEdit.Insert("stop", behind("beep")) })
        assertEquals("beep\nstop", after("beep") { BlockEdit.Insert("stop\n", behind("beep")) })
        assertEquals("repeat 4 times\n  beep\nend\n", after("repeat 4 times\nend\n") { BlockEdit.Insert("beep", inside("repeat")) })
        assertEquals("beep\n", after("") { BlockEdit.Insert("beep", BlockPlace(null, 0, 0)) })
        assertEquals("a()\r\nbeep\r\n", after("a()\r\n") { BlockEdit.Insert("beep", behind("a()")) })
    }

    @Test
    fun `an inserted block is indented like its neighbours, and nothing else changes`() {
        val expected = square.replace("    turn", "    repeat 2 times\n      beep\n    end\n    turn")
        val program = blocksOf(square)
        val result = program.done(BlockEdit.Insert("repeat 2 times\n  beep\nend", program.at("turn")))
        assertEquals(expected, result.program.text)
        assertEquals("repeat 2 times\n      beep\n    end", result.selection.textIn(expected))
        assertEquals(listOf(result.program.idOf("repeat 2")), result.selected)
    }

    @Test
    fun `one block moves alone, with its comment and its odd spaces`() {
        assertEquals(
            "pen down // start\n\nrepeat 4 times   // sides\n    turn left 90\nend\nforward  20\nbeep\n",
            after(square) { BlockEdit.Move(BlockRun(idOf("forward")), at("beep")) },
        )
        assertEquals(
            "\nrepeat 4 times   // sides\n    pen down // start\n    forward  20\n    turn left 90\nend\nbeep\n",
            after(square) { BlockEdit.Move(BlockRun(idOf("pen")), inside("repeat")) },
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
        val program = blocksOf("beep\nforward 1\nforward 2\nforward 3\n")
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
        assertEquals(BlockRefusal.IntoItself, refusal(square) { BlockEdit.Move(BlockRun(idOf("repeat")), inside("repeat")) })
        val program = blocksOf(square)
        assertTrue(program.done(BlockEdit.Move(BlockRun(program.idOf("turn")), program.behind("turn"))).changes.isEmpty())
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
        assertEquals(BlockRefusal.OnlyOutermost, refusal(text) { BlockEdit.Move(BlockRun(idOf("procedure")), inside("repeat")) })
        assertEquals(BlockRefusal.OnlyOutermost, refusal(text) { BlockEdit.Insert("whenever left bumper\nend", inside("repeat")) })
        val robot = "robot\n  light sensor on 2 facing down\nend\nbeep\n"
        assertEquals(BlockRefusal.OnlySettings, refusal(robot) { BlockEdit.Move(BlockRun(idOf("beep")), inside("robot")) })
        assertEquals(BlockRefusal.SettingOutsideRobot, refusal(robot) { BlockEdit.Move(BlockRun(idOf("light")), at("beep")) })
        assertEquals(BlockRefusal.SettingOutsideRobot, refusal(robot) { BlockEdit.Unwrap(idOf("robot")) })
        assertEquals(BlockRefusal.SecondRobot, refusal(robot) { BlockEdit.Duplicate(BlockRun(idOf("robot"))) })
    }

    @Test
    fun `a loose end is not put where it would close another block`() {
        val text = "end\nrepeat 2 times\n  beep\nend\n"
        assertEquals(BlockRefusal.LooseEnd, refusal(text) { BlockEdit.Move(BlockRun(idOf("end")), inside("repeat")) })
    }

    @Test
    fun `blocks nested too deeply are refused`() {
        val text = "repeat 2 times\n".repeat(100) + "beep\n" + "end\n".repeat(100)
        assertEquals(BlockRefusal.TooDeep, refusal(text) { BlockEdit.Insert("repeat 2 times\nend", at("beep")) })
    }

    @Test
    fun `blocks are duplicated and deleted`() {
        assertEquals("beep // hi\nbeep // hi\n", after("beep // hi\n") { BlockEdit.Duplicate(BlockRun(idOf("beep"))) })
        assertEquals("pen down // start\n\n", after(square) { BlockEdit.Delete(setOf(idOf("repeat"), idOf("turn"), idOf("beep"))) })
        assertEquals("", after("beep\n") { BlockEdit.Delete(setOf(idOf("beep"))) })
    }

    @Test
    fun `blocks are wrapped in a construct, and unwrapped`() {
        val text = "beep\nforward 20 // far\nstop\n"
        val wrapped = "beep\nif left bumper\n  forward 20 // far\n  stop\nelse\nend\n"
        assertEquals(wrapped, after(text) { BlockEdit.Wrap(BlockRun(idOf("forward"), 2), "if left bumper\nelse\nend") })
        assertEquals(text, after(wrapped) { BlockEdit.Unwrap(idOf("if")) })
        assertEquals("// four\n  beep\n// done\n".replace("  beep", "beep"), after("repeat 4 times // four\n  beep\nend // done\n") { BlockEdit.Unwrap(idOf("repeat")) })
    }

    @Test
    fun `an if gets and loses its else`() {
        val text = "if left bumper\n  beep\nend\n"
        val both = "if left bumper\n  beep\nelse if light < 40\nelse\nend\n"
        val otherwise = after(text) { BlockEdit.AddElse(idOf("if")) }
        assertEquals("if left bumper\n  beep\nelse\nend\n", otherwise)
        assertEquals(both, after(otherwise) { BlockEdit.AddElse(idOf("if"), "light < 40") })
        assertEquals(otherwise, after(both) { BlockEdit.RemoveElse(idOf("if"), 1) })
        assertEquals(BlockRefusal.ElseExists, refusal(both) { BlockEdit.AddElse(idOf("if")) })
        assertEquals(BlockRefusal.ConditionNeeded, refusal(both) { BlockEdit.AddElse(idOf("if"), "5") })
        assertEquals(BlockRefusal.NoSuchConstruct, refusal(square) { BlockEdit.AddElse(idOf("repeat")) })
    }

    @Test
    fun `a value, a word, a name and a text are replaced where they stand`() {
        assertEquals(square.replace("20", "35"), after(square) { BlockEdit.Replace(span("20"), "35") })
        assertEquals(square.replace("left", "right"), after(square) { BlockEdit.Replace(span("left"), "right") })
        assertEquals("var y = 1\n", after("var x = 1\n") { BlockEdit.Replace(span("x"), "y") })
        assertEquals("show \"BYE\"\n", after("show \"HI\"\n") { BlockEdit.Replace(span("\"HI\""), "BYE") })
        assertEquals("motor B  float // m\n", after("motor A  float // m\n") { BlockEdit.Replace(span("A"), "b") })
    }

    @Test
    fun `an operand gets brackets where it needs them`() {
        assertEquals("show 2 * (1 + 3)\n", after("show 2 * 5\n") { BlockEdit.Replace(span("5"), "1 + 3") })
        assertEquals("show 2 + 1 * 3\n", after("show 2 + 5\n") { BlockEdit.Replace(span("5"), "1 * 3") })
        assertEquals("show (2 * 5) - 1\n", after("show 2 * 5\n") { BlockEdit.Replace(span("2 * 5"), "(2 * 5) - 1") })
    }

    @Test
    fun `a unit follows its number`() {
        assertEquals("wait 1 second\n", after("wait 2 seconds\n") { BlockEdit.Replace(span("2"), "1") })
        assertEquals("wait 3 seconds\n", after("wait 1 second\n") { BlockEdit.Replace(span("1"), "3") })
        assertEquals("repeat n times\n", after("repeat 1 times\n") { BlockEdit.Replace(span("1"), "n") })
    }

    @Test
    fun `what does not fit is refused with the reason`() {
        assertEquals(BlockRefusal.NumberNeeded, refusal(square) { BlockEdit.Replace(span("20"), "left bumper") })
        assertEquals(BlockRefusal.ConditionNeeded, refusal("wait until timer > 5\n") { BlockEdit.Replace(span("timer > 5"), "5") })
        assertEquals(BlockRefusal.ListNeeded, refusal("for each x in [1]\nend\n") { BlockEdit.Replace(span("[1]"), "5") })
        assertEquals(BlockRefusal.NumberNeeded, refusal("var a = [1]\nforward 5\n") { BlockEdit.Replace(span("5"), "a") })
        assertIs<BlockRefusal.NoValue>(refusal(square) { BlockEdit.Replace(span("20"), "2,5 +") })
        assertIs<BlockRefusal.NoValue>(refusal(square) { BlockEdit.Replace(span("20"), "20 // far") })
        assertIs<BlockRefusal.NoValue>(refusal(square) { BlockEdit.Replace(span("20"), "5\nbeep") })
        assertEquals(BlockRefusal.NoChoice(listOf("left", "right")), refusal(square) { BlockEdit.Replace(span("left"), "up") })
        assertEquals(BlockRefusal.NoName("end"), refusal("var x = 1\n") { BlockEdit.Replace(span("x"), "end") })
        assertEquals(BlockRefusal.NoText, refusal("show \"HI\"\n") { BlockEdit.Replace(span("\"HI\""), "a\"b") })
        assertEquals(BlockRefusal.NotFound, refusal(square) { BlockEdit.Replace(span("forward"), "20").copy(part = SourceSpan(1, 4)) })
    }

    @Test
    fun `a value moves and leaves one that fits`() {
        assertEquals("forward side * 2\nturn left 90\n", after("forward 5\nturn left side * 2\n") { BlockEdit.MoveValue(span("side * 2"), span("5")) })
        assertEquals("turn left 90\nforward side\n", after("turn left side\nforward 5\n") { BlockEdit.MoveValue(span("side"), span("5")) })
        assertEquals("show b\n", after("show a + b\n") { BlockEdit.MoveValue(span("b"), span("a + b")) })
        assertEquals(BlockRefusal.IntoItself, refusal("show a + b\n") { BlockEdit.MoveValue(span("a + b"), span("b")) })
        assertEquals("turn left 90\n", after("turn left side\n") { BlockEdit.ClearValue(span("side")) })
    }

    @Test
    fun `a comment is written, changed and deleted`() {
        assertEquals("beep  // hi\n", after("beep\n") { BlockEdit.SetNote(0, "hi") })
        assertEquals("beep   // ho\n", after("beep   // hi\n") { BlockEdit.SetNote(0, "ho") })
        assertEquals("beep\nstop\n", after("beep   // hi\nstop\n") { BlockEdit.SetNote(0, null) })
        assertEquals("stop\n", after("  // hi\nstop\n") { BlockEdit.SetNote(0, null) })
        assertEquals("  // hi\n", after("  \n") { BlockEdit.SetNote(0, "hi") })
        assertEquals("beep  // one two\n", after("beep\n") { BlockEdit.SetNote(0, "one\r\ntwo") })
        assertEquals(BlockRefusal.NoNote, refusal("show \"HI\n") { BlockEdit.SetNote(0, "hi") })
    }

    @Test
    fun `a loose line becomes what the pupil types, and its fix can be applied`() {
        assertEquals("  forward 20\n", after("  forwrd 20\n") { BlockEdit.ReplaceLine(0, "forward 20") })
        assertEquals("  beep\r\n  stop\r\n", after("  bep\r\n") { BlockEdit.ReplaceLine(0, "beep\nstop") })
        assertEquals("  forward 20\n", after("  forwrd 20\n") { BlockEdit.ApplyFix(0) })
        assertEquals("\uFEFFrepeat 2 times\r\n  beep\r\nend", after("\uFEFFrepeat 2 times\r\n  beep") { BlockEdit.ApplyFix(0) })
        assertEquals(BlockRefusal.NoFix, refusal("beep\n") { BlockEdit.ApplyFix(0) })
    }

    @Test
    fun `a name is renamed wherever it is used, and nowhere else`() {
        val text = "var side = 5 // side\nprocedure p(side)\n  forward side\nend\nforward SIDE\nforwrd side\np(side)\n"
        val program = blocksOf(text)
        val expected = "var length2 = 5 // side\nprocedure p(side)\n  forward side\nend\nforward length2\nforwrd length2\np(length2)\n"
        val declared = program.span("side")
        assertEquals(expected, program.done(BlockEdit.Rename(declared, "length2")).program.text)
        assertEquals(BlockRefusal.NoName("2x"), program.refusal(BlockEdit.Rename(declared, "2x")))
        assertEquals(BlockRefusal.NameTaken("max"), program.refusal(BlockEdit.Rename(declared, "max")))
        assertEquals(BlockRefusal.NameTaken("max"), program.refusal(BlockEdit.Rename(program.span("p(").let { it.copy(end = it.start + 1) }, "max")))
    }

    @Test
    fun `copied blocks are Robolang, and pasted they are the same blocks`() {
        val program = blocksOf("repeat 2 times\r\n\tif left bumper // hit\r\n\t\tbeep\r\n\tend\r\nend\r\n")
        val copy = copied(program, BlockRun(program.idOf("if")))
        assertEquals("if left bumper // hit\n\tbeep\nend\n", copy)
        val pasted = program.done(BlockEdit.Insert(checkNotNull(copy), program.at("repeat"))).program
        assertEquals("if left bumper // hit\r\n\tbeep\r\nend\r\n" + program.text, pasted.text)
        val open = blocksOf("repeat 2 times\n  beep\n")
        assertEquals("repeat 2 times\n  beep\nend\n", copied(open, BlockRun(open.idOf("repeat"))))
    }

    @Test
    fun `nothing is inserted by nothing, and unknown blocks are not found`() {
        assertEquals(BlockRefusal.NothingToInsert, refusal("beep\n") { BlockEdit.Insert("", at("beep")) })
        assertEquals(BlockRefusal.NotFound, refusal("beep\n") { BlockEdit.Delete(setOf(BlockId(99))) })
        assertEquals(BlockRefusal.NotFound, refusal("beep\n") { BlockEdit.Insert("stop", BlockPlace(null, 0, 7)) })
        assertEquals(BlockRefusal.NotFound, refusal("beep\n") { BlockEdit.SetNote(1, "x") })
    }
}
