package robotran.nxt

import robotran.nxt.hardware.EventTable
import robotran.nxt.hardware.EventView
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

class EventTableTest {
    private val table = EventTable()
    private val view = View()

    @Test
    fun `buttons that are pressed and released happen once`() {
        val number = table.register(EventTable.BUTTONS, 0xF0F, period = 10, view)
        assertEquals(emptyList(), pass(10))
        view.held = 5
        assertEquals(listOf(number to 0x005), pass(10))
        assertEquals(emptyList(), pass(10))
        view.held = 4
        assertEquals(listOf(number to 0x100), pass(10))
    }

    @Test
    fun `only bits of the filter happen`() {
        table.register(EventTable.BUTTONS, 0x002, period = 1, view)
        view.held = 13
        assertEquals(emptyList(), pass(5))
        view.held = 2
        assertEquals(listOf(0 to 2), pass(5))
        view.held = 0
        assertEquals(emptyList(), pass(5))
    }

    @Test
    fun `what changes between two looks and back does not happen`() {
        table.register(EventTable.ANALOG_PORTS, 15, period = 4, view)
        pass(1)
        view.values[2] = 300
        pass(1)
        view.values[2] = 1023
        assertEquals(emptyList(), pass(8))
        view.values[2] = 300
        view.values[3] = 5
        assertEquals(listOf(0 to 12), pass(4))
    }

    @Test
    fun `the end of the program happens once to everybody who waits for it`() {
        val one = table.register(EventTable.SYSTEM, 1, period = 1, view)
        val two = table.register(EventTable.SYSTEM, 1, period = 3, view)
        assertTrue(table.has(EventTable.SYSTEM))
        view.isToEnd = true
        assertEquals(listOf(one to 1, two to 1), pass(10))
    }

    @Test
    fun `there is room for sixteen`() {
        repeat(EventTable.CAPACITY) { assertEquals(it, table.register(EventTable.BUTTONS, 1, 10, view)) }
        assertEquals(-1, table.register(EventTable.BUTTONS, 1, 10, view))
        assertTrue(table.unregister(7))
        assertFalse(table.unregister(7))
        assertFalse(table.unregister(16))
        assertEquals(7, table.register(EventTable.SYSTEM, 1, 10, view))
    }

    @Test
    fun `it says when it wants to look`() {
        assertEquals(null, table.nextLook)
        table.register(EventTable.BUTTONS, 1, period = 10, view)
        pass(3)
        table.register(EventTable.ANALOG_PORTS, 1, period = 4, view)
        assertEquals(7L, table.nextLook)
        pass(5)
        assertEquals(10L, table.nextLook)
        table.unregister(0)
        table.unregister(1)
        assertEquals(null, table.nextLook)
    }

    private fun pass(milliseconds: Int): List<Pair<Int, Int>> = buildList {
        repeat(milliseconds) {
            view.milliseconds++
            table.poll(view) { number, bits -> add(number to bits) }
        }
    }

    private class View : EventView {
        override var milliseconds = 0L
        override var isToEnd = false
        val values = IntArray(4) { 1023 }
        var held = 0

        override fun analog(port: Int): Int = values[port]

        override fun buttons(): Int = held
    }
}
