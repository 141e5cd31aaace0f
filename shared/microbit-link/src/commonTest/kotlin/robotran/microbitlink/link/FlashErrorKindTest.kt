package robotran.microbitlink.link

import robotran.microbitlink.DaplinkNumbers
import robotran.microbitlink.FlashErrorKind
import robotran.microbitlink.MicrobitBoard
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class FlashErrorKindTest {
    @Test
    fun `the numbering has changed with one version`() {
        assertEquals(DaplinkNumbers.OLDER, DaplinkNumbers.of(MicrobitBoard.V1, 253))
        assertEquals(DaplinkNumbers.NEWER, DaplinkNumbers.of(MicrobitBoard.V1, 254))
        assertEquals(DaplinkNumbers.NEWER, DaplinkNumbers.of(MicrobitBoard.V2, null))
        for ((older, newer) in listOf(4 to 4, 10 to 12, 12 to 14, 15 to 17, 18 to 21, 22 to 25, 25 to 28, 33 to 37)) {
            val kind = DaplinkNumbers.OLDER.kindOf(older)
            assertEquals(kind, DaplinkNumbers.NEWER.kindOf(newer), "$older and $newer")
            assertTrue(kind != FlashErrorKind.UNKNOWN, "$older")
        }
    }

    @Test
    fun `numbers on a display are those of new boards`() {
        assertEquals(FlashErrorKind.TIMED_OUT, FlashErrorKind.ofDisplay(504))
        assertEquals(FlashErrorKind.CHECKSUM, FlashErrorKind.ofDisplay(521))
        assertEquals(FlashErrorKind.OTHER_BOARD, FlashErrorKind.ofDisplay(529))
        assertEquals(FlashErrorKind.UPDATE, FlashErrorKind.ofDisplay(537))
        for (other in listOf(
            0,
            20,
            500,
            599,
            927,
        )) {
            assertEquals(FlashErrorKind.UNKNOWN, FlashErrorKind.ofDisplay(other))
        }
    }
}
