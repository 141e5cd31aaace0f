package robotran.editing

import kotlin.test.Test
import kotlin.test.assertEquals

class FiguresTest {
    @Test
    fun `figures are written as people write them`() {
        assertEquals(listOf("12", "0.5", "-3.25", "0"), listOf(12.0, 0.5, -3.25, 0.0001).map(::written))
    }

    @Test
    fun `figures are read with a point or a comma, and what is none is not`() {
        val read = listOf("12", " 0,5 ", ".5", "-3.25", "007", "4.", "−2").map(::parseDecimal)
        assertEquals(listOf(12.0, 0.5, 0.5, -3.25, 7.0, 4.0, -2.0), read)
        assertEquals(List(6) { null }, listOf("", "-", "a", "1e3", "1.2.3", "9".repeat(30)).map(::parseDecimal))
    }
}
