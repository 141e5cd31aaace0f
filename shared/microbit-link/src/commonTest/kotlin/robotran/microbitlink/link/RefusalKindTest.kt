package robotran.microbitlink.link

import robotran.microbitlink.DaplinkNumbers
import robotran.microbitlink.MicrobitBoard
import robotran.microbitlink.RefusalKind
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class RefusalKindTest {
    @Test
    fun `the numbering has changed with one version`() {
        assertEquals(DaplinkNumbers.OLDER, DaplinkNumbers.of(MicrobitBoard.V1, 253))
        assertEquals(DaplinkNumbers.NEWER, DaplinkNumbers.of(MicrobitBoard.V1, 254))
        assertEquals(DaplinkNumbers.NEWER, DaplinkNumbers.of(MicrobitBoard.V2, null))
        for ((older, newer) in listOf(4 to 4, 10 to 12, 12 to 14, 15 to 17, 18 to 21, 22 to 25, 25 to 28, 33 to 37)) {
            val kind = DaplinkNumbers.OLDER.kindOf(older)
            assertEquals(kind, DaplinkNumbers.NEWER.kindOf(newer), "$older and $newer")
            assertTrue(kind != RefusalKind.UNKNOWN, "$older")
        }
    }

    @Test
    fun `numbers on a display are those of new boards`() {
        assertEquals(RefusalKind.TIMED_OUT, RefusalKind.ofDisplay(504))
        assertEquals(RefusalKind.CHECKSUM, RefusalKind.ofDisplay(521))
        assertEquals(RefusalKind.OTHER_BOARD, RefusalKind.ofDisplay(529))
        assertEquals(RefusalKind.UPDATE, RefusalKind.ofDisplay(537))
        for (other in listOf(0, 20, 500, 599, 927)) assertEquals(RefusalKind.UNKNOWN, RefusalKind.ofDisplay(other))
    }
}
