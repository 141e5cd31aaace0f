package robotran.microbitlink.sentences

import robotran.language.Language
import robotran.microbitlink.BoardError
import robotran.microbitlink.FlashErrorKind
import robotran.microbitlink.ImageError
import robotran.microbitlink.MicrobitBoard
import robotran.microbitlink.Remains
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class MicrobitSentencesTest {
    private val imageErrors = listOf(
        ImageError.NotHex,
        ImageError.Damaged(3),
        ImageError.Damaged(null),
        ImageError.Incomplete,
        ImageError.NoMicroPython,
        ImageError.OtherBoard(null),
        ImageError.OtherBoard(MicrobitBoard.V1),
        ImageError.OtherBoard(MicrobitBoard.V2),
        ImageError.TooOld,
        ImageError.BrokenFiles,
        ImageError.TooLarge(30_000, 28_214),
        ImageError.EmptyFile("main.py"),
        ImageError.BadName("main.py"),
    )

    private val boardErrors = listOf(
        BoardError.OutOfReach,
        BoardError.Taken,
        BoardError.NotAllowed,
        BoardError.InterfaceTooOld,
        BoardError.NotAMicrobit,
        BoardError.BrokenOff,
        BoardError.BadConnection,
        BoardError.Refused(21, FlashErrorKind.CHECKSUM),
        BoardError.NoPython,
        BoardError.NoRoom,
        BoardError.NotAsSent,
    )

    @Test
    fun `every error has a sentence of its own in every language`() {
        for (language in Language.entries) {
            val sentences = imageErrors.map { it.sentence(language) } + boardErrors.map { it.sentence(language) } +
                Remains.entries.map { it.sentence(language) }
            assertEquals(sentences.size, sentences.toSet().size, "$language")
            val refusals = FlashErrorKind.entries.map { it.sentence(language) }
            assertTrue((sentences + refusals).all { it.isNotBlank() && '{' !in it && "null" !in it }, "$language")
            assertTrue(refusals.toSet().size >= 10, "$language: $refusals")
        }
    }

    @Test
    fun `sizes numbers and boards are told`() {
        val large = BoardError.BadFile(ImageError.TooLarge(30_000, 28_214)).sentence(Language.ENGLISH)
        assertEquals("The program is too large: it has 30,000 bytes, and the micro:bit has room for 28,214.", large)
        assertTrue("21" in BoardError.Refused(21, FlashErrorKind.CHECKSUM).sentence(Language.GERMAN))
        assertTrue("V2" in ImageError.OtherBoard(MicrobitBoard.V2).sentence(Language.SPANISH))
    }
}
