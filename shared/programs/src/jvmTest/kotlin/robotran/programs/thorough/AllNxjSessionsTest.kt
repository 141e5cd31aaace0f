package robotran.programs.thorough

import robotran.programs.NxjSessions
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class AllNxjSessionsTest {
    @Test
    fun `all programs print in a world what their comments say`() {
        assertTrue(NxjSessions.programs.size > 145, "${NxjSessions.programs.size} programs")
        assertEquals("", NxjSessions().differences(NxjSessions.programs))
    }
}
