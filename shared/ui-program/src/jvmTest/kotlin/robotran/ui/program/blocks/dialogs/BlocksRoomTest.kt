package robotran.ui.program.blocks.dialogs

import androidx.compose.ui.unit.dp
import robotran.workshop.blocks.BlockDialog
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

/** Tests how blocks, palette and sheets share a pane. */
class BlocksRoomTest {
    @Test
    fun `the largest phones upright have no rail, panes of tablets have one`() {
        for (width in listOf(320, 360, 411, 440)) assertFalse(room(width, 600).hasGroups, "$width")
        for (width in listOf(456, 486, 820)) assertTrue(room(width, 600).hasGroups, "$width")
    }

    @Test
    fun `large text needs a wider pane for the rail, and a wider rail`() {
        assertFalse(room(486, 600, textScale = 2f).hasGroups)
        val large = room(820, 600, textScale = 2f)
        assertTrue(large.railWidth > room(820, 600).railWidth)
    }

    @Test
    fun `a sheet leaves the row that is edited visible`() {
        for (height in 345..1200 step 5) {
            val left = height.dp - room(411, height).sheetHeight
            assertTrue(left >= 52.dp, "of $height only $left are left")
        }
    }

    @Test
    fun `in low panes sheets are beside the blocks, and over them if there is room for nothing else`() {
        assertEquals(SheetPlace.BELOW, room(411, 528).dialogs)
        assertEquals(SheetPlace.BESIDE, room(820, 290).dialogs)
        assertEquals(SheetPlace.OVER, BlocksRoom.of(640.dp, 90.dp, textScale = 1f, isVeryLow = true).dialogs)
    }

    @Test
    fun `a sheet beside the blocks leaves room for them, also with large text`() {
        for (width in 320..1400 step 20) {
            for (scale in listOf(1f, 1.5f, 2f)) {
                val room = room(width, 350, scale)
                val left = width.dp - room.railWidth - room.keptFree
                assertTrue(left >= 190.dp, "of $width at $scale only $left are left")
            }
        }
        assertEquals(SheetPlace.BELOW, room(742, 359, textScale = 2f).dialogs)
    }

    @Test
    fun `a sheet over all blocks has the groups in it, and a button beside the blocks opens it`() {
        for (width in listOf(568, 640, 891)) {
            val room = BlocksRoom.of(width.dp, 90.dp, textScale = 1f, isVeryLow = true)
            assertFalse(room.hasGroups)
            assertTrue(room.railWidth > 0.dp)
            assertEquals(width.dp, room.sheetWidth)
        }
    }

    @Test
    fun `small phones and tablets in portrait are low, and phones in landscape or below a lesson very low`() {
        for ((height, expected) in listOf(
            750 to PaneHeight.HIGH,
            670 to PaneHeight.HIGH,
            436 to PaneHeight.LOW,
            354 to PaneHeight.LOW,
            330 to PaneHeight.VERY_LOW,
            237 to PaneHeight.VERY_LOW,
            186 to PaneHeight.VERY_LOW,
        )) {
            assertEquals(expected, PaneHeight.of(height.dp, textScale = 1f), "$height")
        }
        assertEquals(PaneHeight.LOW, PaneHeight.of(670.dp, textScale = 2f))
    }

    @Test
    fun `a sheet beside the blocks covers none of them`() {
        val beside = room(820, 290)
        assertEquals(0.dp, beside.coveredBy(BlockDialog.Palette))
        assertEquals(beside.sheetWidth, beside.keptFree)
        val below = room(411, 528)
        assertEquals(below.paletteHeight, below.coveredBy(BlockDialog.Palette))
        assertEquals(0.dp, below.keptFree)
        assertEquals(0.dp, below.coveredBy(null))
    }

    private fun room(width: Int, height: Int, textScale: Float = 1f): BlocksRoom =
        BlocksRoom.of(width.dp, height.dp, textScale)
}
