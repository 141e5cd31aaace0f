package robotran.language.history

import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertNull

class HistoryTest {
    /** The states 0, 1 .. [last], each with a step of its own; now is [last]. */
    private fun upTo(last: Int) = (0..<last).fold(History<Int>()) { history, state -> history.recorded(state) }

    @Test
    fun `each state comes back and again`() {
        val (before, undone) = checkNotNull(upTo(3).undone { 3 })
        assertEquals(2, before)
        val (after, redone) = checkNotNull(undone.redone { before })
        assertEquals(3, after)
        assertEquals(upTo(3), redone)
    }

    @Test
    fun `nothing is undone or redone where nothing was done`() {
        assertNull(History<Int>().undone { 0 })
        assertNull(upTo(3).redone { 3 })
    }

    @Test
    fun `what was undone is gone after another step`() {
        val (before, undone) = checkNotNull(upTo(3).undone { 3 })
        assertFalse(undone.recorded(before).canRedo)
    }

    @Test
    fun `parts of one change are one step until it ends`() {
        val typed = upTo(1).recorded(1, "title").recorded(2, "title")
        assertEquals(listOf(0, 1), typed.past)
        assertEquals(listOf(0, 1, 3), typed.mergeEnded().recorded(3, "title").past)
        assertEquals(listOf(0, 1, 3), typed.recorded(3, "task").past)
    }

    @Test
    fun `the oldest steps are dropped`() =
        assertEquals((5..<History.MAX_STEPS + 5).toList(), upTo(History.MAX_STEPS + 5).past)
}
