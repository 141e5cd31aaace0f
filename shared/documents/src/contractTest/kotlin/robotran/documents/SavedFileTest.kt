package robotran.documents

import robotran.brick.controls.BrickButton
import robotran.language.Language
import robotran.projects.ProjectFileResult
import robotran.projects.ProjectLimits
import robotran.projects.readProject
import robotran.simulation.RecordedInput
import robotran.simulation.SessionInput
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

class SavedFileTest {
    @Test
    fun `a replay holds what was done to the run`() {
        val inputs = listOf(RecordedInput(5, SessionInput.Press(BrickButton.RUN)), RecordedInput(9, SessionInput.Stop))
        val replay = projectOf("beep").copy(inputs = inputs)
        val file = assertNotNull(projectFile(replay))
        assertEquals(ProjectFileResult.Success(replay), readProject(file, Language.ENGLISH))
    }

    @Test
    fun `what nobody could read again is not made a file`() {
        assertNull(projectFile(projectOf("beep\n".repeat(ProjectLimits.MAXIMUM_LINES + 1))))
    }

    @Test
    fun `a file that somebody else has changed is noticed before it is written`() {
        val before = byteArrayOf(1, 2, 3)
        val ours = byteArrayOf(4)
        val file = SaveTarget(FileReference("x", "x"), FileStamp.of(before))
        assertEquals(SavingCheck.FREE, checkBeforeSaving(file, before, ours))
        assertEquals(SavingCheck.FREE, checkBeforeSaving(file, null, ours))
        assertEquals(SavingCheck.FREE, checkBeforeSaving(file, ours, ours))
        assertEquals(SavingCheck.CHANGED, checkBeforeSaving(file, byteArrayOf(1, 2, 4), ours))
    }

    @Test
    fun `the stamp is FNV-1a`() {
        assertEquals("cbf29ce484222325", FileStamp.of(byteArrayOf()).text)
        assertEquals("85944171f73967e8", FileStamp.of("foobar").text)
        assertEquals(FileStamp.of("foobar".encodeToByteArray()), FileStamp.of("foobar"))
    }

    @Test
    fun `a work is kept at once, and then not more than twice a second`() {
        val times = AutosaveThrottle()
        assertTrue(times.isDue(0))
        assertFalse(times.begun(1_000).isDue(1_499))
        assertTrue(times.begun(1_000).isDue(1_500))
        assertTrue(AutosaveThrottle.INTERVAL + AutosaveThrottle.LOOK < 1_000)
    }

    @Test
    fun `a work whose keeping can be felt is kept when the keys rest, and every ten seconds`() {
        val times = AutosaveThrottle().begun(1_000).ended(1_200)
        assertFalse(times.changed(3_900).isDue(4_000))
        assertFalse(times.changed(2_000).isDue(2_900), "a second of ten has to be free")
        assertTrue(times.changed(2_000).isDue(3_000))
        assertTrue(times.changed(10_900).isDue(11_000))
    }
}
