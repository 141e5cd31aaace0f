package robotran.robolang.syntax

import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNull

class SuggestionTest {
    private val candidates = listOf("forward", "backward", "end", "repeat")

    @Test
    fun `one slip is forgiven for every three letters`() {
        assertEquals("end", suggestion("edn", candidates))
        assertEquals("backward", suggestion("bakwards", candidates))
        assertEquals("forward", suggestion("FARWERD", candidates))
        assertNull(suggestion("reset", candidates))
        assertNull(suggestion("it", candidates))
    }

    @Test
    fun `a very long word is like nothing`() {
        val long = "x".repeat(RobolangLimits.SUGGESTION_CHARACTERS + 1)
        assertNull(suggestion(long, listOf(long)))
    }
}
