package robotran.brick.controls

import robotran.brick.kind.BrickKind
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class BrickButtonTest {
    @Test
    fun `a brick has each of its buttons once, and each button is on a brick`() {
        for (kind in BrickKind.entries) assertEquals(kind.buttons.distinct(), kind.buttons)
        assertEquals(BrickButton.entries.toList(), BrickKind.allButtons)
        assertEquals(listOf("On-Off", "View", "Prgm", "Run"), BrickKind.RCX.buttons.map { it.label })
    }

    @Test
    fun `a brick is started with a button of its own`() {
        for (kind in BrickKind.entries) assertTrue(kind.startButton in kind.buttons)
    }
}
