package robotran.language

import kotlin.test.Test
import kotlin.test.assertEquals

class EditDistanceTest {
    @Test
    fun `slips are counted`() {
        assertEquals(0, editDistance("turn", "turn"))
        assertEquals(1, editDistance("tunr", "turn"))
        assertEquals(1, editDistance("tur", "turn"))
        assertEquals(1, editDistance("tuurn", "turn"))
        assertEquals(1, editDistance("tern", "turn"))
        assertEquals(4, editDistance("", "turn"))
        assertEquals(3, editDistance("kitten", "sitting"))
    }

    @Test
    fun `neighbours that changed places count once, and a letter that was moved is not touched again`() {
        assertEquals(1, editDistance("fowrard", "forward"))
        assertEquals(3, editDistance("ca", "abc"))
    }
}
