package robotran.blockediting

import robotran.language.source.SourceSpan
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs

class PartEditTest {
    @Test
    fun `a value, a word, a name and a text are replaced where they stand`() {
        assertEquals(SQUARE.replace("20", "35"), after(SQUARE) { BlockEdit.Replace(span("20"), "35") })
        assertEquals(SQUARE.replace("left", "right"), after(SQUARE) { BlockEdit.Replace(span("left"), "right") })
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
        assertEquals(
            "play 440 for beat seconds\n",
            after("play 440 for 1 second\n") {
                BlockEdit.Replace(span("1"), "beat")
            },
        )
        assertEquals("repeat n times\n", after("repeat 1 times\n") { BlockEdit.Replace(span("1"), "n") })
    }

    @Test
    fun `what does not fit is refused with the reason`() {
        assertEquals(BlockEditError.NumberNeeded, editError(SQUARE) { BlockEdit.Replace(span("20"), "left bumper") })
        assertEquals(
            BlockEditError.ConditionNeeded,
            editError("wait until timer > 5\n") {
                BlockEdit.Replace(span("timer > 5"), "5")
            },
        )
        assertEquals(
            BlockEditError.ListNeeded,
            editError("for each x in [1]\nend\n") {
                BlockEdit.Replace(span("[1]"), "5")
            },
        )
        assertEquals(
            BlockEditError.NumberNeeded,
            editError("var a = [1]\nforward 5\n") {
                BlockEdit.Replace(span("5"), "a")
            },
        )
        assertIs<BlockEditError.NoValue>(editError(SQUARE) { BlockEdit.Replace(span("20"), "2,5 +") })
        assertIs<BlockEditError.NoValue>(editError(SQUARE) { BlockEdit.Replace(span("20"), "20 // far") })
        assertIs<BlockEditError.NoValue>(editError(SQUARE) { BlockEdit.Replace(span("20"), "5\nbeep") })
        assertEquals(
            BlockEditError.NoChoice(listOf("left", "right")),
            editError(SQUARE) {
                BlockEdit.Replace(span("left"), "up")
            },
        )
        assertEquals(BlockEditError.NoName("end"), editError("var x = 1\n") { BlockEdit.Replace(span("x"), "end") })
        assertEquals(BlockEditError.NoText, editError("show \"HI\"\n") { BlockEdit.Replace(span("\"HI\""), "a\"b") })
        assertEquals(
            BlockEditError.NotFound,
            editError(SQUARE) {
                BlockEdit.Replace(span("forward"), "20").copy(part = SourceSpan(1, 4))
            },
        )
    }

    @Test
    fun `a value moves and leaves one that fits`() {
        assertEquals(
            "forward side * 2\nturn left 90\n",
            after("forward 5\nturn left side * 2\n") {
                BlockEdit.MoveValue(span("side * 2"), span("5"))
            },
        )
        assertEquals(
            "turn left 90\nforward side\n",
            after("turn left side\nforward 5\n") {
                BlockEdit.MoveValue(span("side"), span("5"))
            },
        )
        assertEquals("show b\n", after("show a + b\n") { BlockEdit.MoveValue(span("b"), span("a + b")) })
        assertEquals(
            BlockEditError.IntoItself,
            editError("show a + b\n") {
                BlockEdit.MoveValue(span("a + b"), span("b"))
            },
        )
        assertEquals("turn left 90\n", after("turn left side\n") { BlockEdit.ClearValue(span("side")) })
    }

    @Test
    fun `lists get and lose elements`() {
        val text = "var a = [1, 2]\n"
        assertEquals("var a = [1, 2, 9]\n", after(text) { BlockEdit.AddItem(span("[1, 2]"), 2, "9") })
        assertEquals("var a = [9, 1, 2]\n", after(text) { BlockEdit.AddItem(span("[1, 2]"), 0, "9") })
        assertEquals("var a = [2]\n", after(text) { BlockEdit.RemoveItem(span("[1, 2]"), 0) })
        assertEquals("var a = [1]\n", after(text) { BlockEdit.RemoveItem(span("[1, 2]"), 1) })
        assertEquals(BlockEditError.LastItem, editError("var a = [1]\n") { BlockEdit.RemoveItem(span("[1]"), 0) })
        assertIs<BlockEditError.NoValue>(editError(text) { BlockEdit.AddItem(span("[1, 2]"), 0, "+") })
    }
}
