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
        assertEquals(listOf("way1", "way2"), nearestWords("way3", listOf("way1", "way2", "wall"), 1))
        assertEquals(emptyList(), nearestWords("qqqq", listOf("way1", "way2"), 1))
    }
}
