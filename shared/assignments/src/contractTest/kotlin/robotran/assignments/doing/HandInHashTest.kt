package robotran.assignments.doing

import kotlinx.coroutines.test.runTest
import robotran.assignments.ASSIGNMENT
import robotran.assignments.handIn
import robotran.language.Language
import robotran.projects.LinkCreation
import robotran.projects.LinkResult
import robotran.projects.ProjectFileResult
import robotran.projects.handInLinkOf
import robotran.projects.linkOf
import robotran.projects.openHandInLink
import robotran.projects.openLink
import robotran.projects.readProject
import robotran.projects.writeProject
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertIs
import kotlin.test.assertTrue

class HandInHashTest {
    private val anna = handIn("Anna")

    @Test
    fun `a file that was read back is intact, and a changed one is not`() {
        val text = writeProject(anna)
        assertTrue(isIntact(assertIs<ProjectFileResult.Success>(readProject(text, Language.ENGLISH)).project))
        val changed = text.replace("forward 12", "forward 13")
        assertFalse(isIntact(assertIs<ProjectFileResult.Success>(readProject(changed, Language.ENGLISH)).project))
        assertFalse(isIntact(anna.copy(handIn = anna.handIn?.copy(tries = 2))))
        assertFalse(isIntact(ASSIGNMENT))
    }

    @Test
    fun `a hand-in's link is short and needs the assignment`() = runTest {
        val link = assertIs<LinkCreation.Made>(handInLinkOf(anna, Language.ENGLISH)).fragment
        val whole = assertIs<LinkCreation.Made>(linkOf(anna, Language.ENGLISH)).fragment
        assertTrue(link.startsWith("#h=a") && link.length < whole.length - 100, "${link.length} of ${whole.length}")
        val opened = assertIs<LinkResult.OfProject>(openHandInLink(link, ASSIGNMENT.world, Language.ENGLISH)).project
        assertEquals(anna, opened)
        assertTrue(isIntact(opened))
        val alone = assertIs<LinkResult.Rejected>(openLink(link, Language.ENGLISH)).message
        assertTrue("This is what somebody has handed in." in alone, alone)
        assertEquals<LinkResult>(LinkResult.OfProject(anna), openHandInLink(whole, ASSIGNMENT.world, Language.ENGLISH))
    }

    @Test
    fun `a world that pupils may change goes with the link and counts for the hash`() = runTest {
        val free = anna.copy(assignment = anna.assignment?.copy(mayChangeWorld = true))
        val changed = sealedHandIn(free.copy(world = free.world.copy(title = "Mine")))
        val link = assertIs<LinkCreation.Made>(handInLinkOf(changed, Language.ENGLISH)).fragment
        val opened = assertIs<LinkResult.OfProject>(openHandInLink(link, ASSIGNMENT.world, Language.ENGLISH)).project
        assertEquals("Mine", opened.world.title)
        assertTrue(isIntact(opened))
        assertFalse(isIntact(opened.copy(world = ASSIGNMENT.world)))
    }
}
