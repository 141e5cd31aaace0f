package robotran.ui.sheet

import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class WheelTreadsTest {
    @Test
    fun `only the upper half of the wheel is seen`() {
        val places = treadPlaces(turn = 0.0, treads = 12, radius = 2f)
        assertEquals(6, places.size)
        assertTrue(places.all { it in -2f..2f })
    }

    @Test
    fun `treads move forwards as the wheel turns`() {
        val before = treadPlaces(turn = 0.0, treads = 4, radius = 2f)
        val after = treadPlaces(turn = 0.1, treads = 4, radius = 2f)
        assertTrue(before.zip(after).all { (earlier, later) -> later > earlier })
    }

    @Test
    fun `a wheel that has turned backwards shows treads as well`() {
        assertEquals(
            treadPlaces(turn = 0.75, treads = 12, radius = 2f),
            treadPlaces(turn = -3.25, treads = 12, radius = 2f),
        )
    }
}
