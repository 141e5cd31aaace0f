package robotran.workshop.blocks

import robotran.workshop.event.BlockEvent
import robotran.workshop.event.RunEvent
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNull

/** Tests what is shown on the sheet while a number is edited. */
class SheetPreviewTest {
    private val OnBlocks.preview: SheetPreview? get() = workshop.state.sheetPreview

    private fun OnBlocks.way(line: String, number: String): SheetPreview.Way {
        open(line, number)
        return assertIs<SheetPreview.Way>(preview)
    }

    private fun OnBlocks.turn(line: String, number: String): SheetPreview.Turn {
        open(line, number)
        return assertIs<SheetPreview.Turn>(preview)
    }

    @Test
    fun `a length is shown where the robot stands, ahead or back`() = onBlocks(PROGRAM) {
        assertNull(preview)
        val ahead = way("forward 20", "20")
        assertEquals(workshop.state.session.robot.pose, ahead.pose)
        assertEquals(20.0, ahead.centimetres)
        assertEquals(-7.5, way("BACKWARD 7.5 cm", "7.5").centimetres)
        assertEquals(-5.0, way("forward -5", "-5").centimetres)
    }

    @Test
    fun `an angle is shown counter-clockwise`() = onBlocks(PROGRAM) {
        assertEquals(90.0, turn("turn left 90", "90").degrees)
        assertEquals(-45.0, turn("turn right 45 degrees", "45").degrees)
    }

    @Test
    fun `it follows the number, and ends with the sheet`() = onBlocks(PROGRAM) {
        way("forward 20", "20")
        send(BlockEvent.Put("35"))
        assertEquals(35.0, assertIs<SheetPreview.Way>(preview).centimetres)
        send(BlockEvent.DialogShown(null))
        assertNull(preview)
    }

    @Test
    fun `other numbers and values show nothing`() = onBlocks(PROGRAM) {
        for ((line, part) in listOf("forward side * 2" to "side * 2", "wait 2 seconds" to "2", "var side = 5" to "5")) {
            open(line, part)
            assertNull(preview, line)
        }
    }

    @Test
    fun `it follows the robot, but not while a program runs`() = onBlocks(PROGRAM) {
        val before = way("forward 20", "20")
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(300)
        assertNull(preview)
        workshop.handle(RunEvent.StopPressed)
        workshop.advance(500)
        assertEquals(false, before.pose == checkNotNull(preview).pose)
    }

    @Test
    fun `its end is dragged in whole centimetres and five degrees, in the direction of the line`() = onBlocks(PROGRAM) {
        val ahead = way("forward 20", "20")
        assertEquals(listOf(13, 0, 100), listOf(12.7, -4.0, 400.0).map(ahead::numberFor))
        assertEquals(13, way("BACKWARD 7.5 cm", "7.5").numberFor(-12.7))
        assertEquals(listOf(45, 315, 0), listOf(43.0, -44.0, 359.0).map(turn("turn left 90", "90")::numberFor))
        assertEquals(90, turn("turn right 45 degrees", "45").numberFor(-91.0))
    }

    private companion object {
        const val PROGRAM = "var side = 5\nforward 20\nBACKWARD 7.5 cm\nforward -5\nforward side * 2\n" +
            "turn left 90\nturn right 45 degrees\nwait 2 seconds\n"
    }
}
