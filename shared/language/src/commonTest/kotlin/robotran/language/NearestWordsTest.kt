package robotran.language

import kotlin.test.Test
import kotlin.test.assertEquals

class NearestWordsTest {
    @Test
    fun `the word with the fewest errors is meant, of these the one that begins alike`() {
        assertEquals(listOf("Off"), nearestWords("Of", listOf("On", "Off", "Float"), 1))
        assertEquals(listOf("OnFwd"), nearestWords("onfwd", listOf("OnFor", "OnFwd"), 1))
        assertEquals(listOf("forward"), nearestWords("forwrd", listOf("for", "forward", "wait"), 2))
    }

    @Test
    fun `words that are as near are all there, and others are not`() {
        assertEquals(listOf("wall", "walk"), nearestWords("wal", listOf("wall", "walk", "way1"), 1))
        assertEquals(emptyList(), nearestWords("qqqq", listOf("way1", "way2"), 1))
    }

    @Test
    fun `another one of a series is no typing error`() {
        val others = listOf("way3" to "way1", "OUT_D" to "OUT_A", "OUT_ABD" to "OUT_ABC", "pointB" to "pointA")
        for ((typed, name) in others) {
            assertEquals(emptyList(), nearestWords(typed, listOf(name), 2), typed)
        }
        assertEquals(listOf("way2"), nearestWords("wya2", listOf("way1", "way2"), 1))
        assertEquals(listOf("getX"), nearestWords("getx", listOf("getX", "getY"), 1))
        assertEquals(listOf("forward"), nearestWords("forwarD", listOf("forward"), 1))
    }

    @Test
    fun `the others of a series are known by what comes before their number`() {
        val ports = listOf("S1", "S2", "S3", "S4", "SPEED")
        assertEquals(ports.take(4), othersOfSeries("S5", ports))
        assertEquals(listOf("A", "B"), othersOfSeries("D", listOf("A", "B", "start")))
        val outputs = listOf("OUT_A", "OUT_AC", "OUT_AB", "OUT_ON")
        assertEquals(listOf("OUT_AB", "OUT_AC"), othersOfSeries("OUT_AD", outputs))
        assertEquals(emptyList(), othersOfSeries("speed", listOf("speed1")))
    }
}
