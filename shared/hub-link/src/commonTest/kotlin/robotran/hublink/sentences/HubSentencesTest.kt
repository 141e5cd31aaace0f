package robotran.hublink.sentences

import robotran.hublink.HubError
import robotran.hublink.HubVersion
import robotran.hublink.UnseenCause
import robotran.hublink.output.ProgramError
import robotran.hublink.output.ProgramErrorKind
import robotran.language.Language
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class HubSentencesTest {
    private val errors = listOf(
        HubError.NotSeen(UnseenCause.entries),
        HubError.OutOfReach,
        HubError.Taken,
        HubError.NotAllowed,
        HubError.BluetoothNotAllowed,
        HubError.LegoFirmware,
        HubError.TooOld(null),
        HubError.TooOld(HubVersion(3, 1)),
        HubError.TooLarge(70_000, 52_300),
        HubError.NumberTooLarge("4000000000"),
        HubError.NotAProgram,
        HubError.Busy,
        HubError.DoesNotStop,
        HubError.NoProgram,
        HubError.BrokenOff,
        HubError.BadConnection,
        HubError.Refused(5),
        HubError.Refused(null),
    )

    @Test
    fun `every error has a sentence of its own in every language`() {
        val programErrors = ProgramErrorKind.entries.map { ProgramError(it, 3, "D", "ImportError: no") }
        for (language in Language.entries) {
            val sentences = errors.map { it.sentence(language) } + programErrors.map { it.sentence(language) }
            assertEquals(sentences.size, sentences.toSet().size, "$language")
            assertTrue(sentences.all { it.isNotBlank() && "(null" !in it && '{' !in it }, "$language: $sentences")
        }
    }

    @Test
    fun `both sizes and the port are told`() {
        val large = HubError.TooLarge(70_000, 52_300).sentence(Language.ENGLISH)
        assertEquals("The program is too large: it has 70,000 bytes, and the hub has room for 52,300.", large)
        val missing = ProgramError(ProgramErrorKind.MISSING_DEVICE, 3, "D", "OSError")
        assertTrue("at port D" in missing.sentence(Language.ENGLISH))
        assertTrue("a motor or sensor" in missing.copy(port = null).sentence(Language.ENGLISH))
    }

    @Test
    fun `a hub that is not seen gets a list of what to look at`() {
        val causes = listOf(UnseenCause.OFF, UnseenCause.PROGRAM_RUNS)
        assertEquals(3, HubError.NotSeen(causes).sentence(Language.GERMAN).lines().size)
    }
}
