package robotran.documents

import kotlinx.coroutines.test.runTest
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

class OpenProjectsTest {
    private val store = MemoryKeyValueStore()
    private val repository = ProjectRepository(store)
    private val open = OpenProjects(store, repository)

    @Test
    fun `of the works whose windows are gone the last one comes back and the others are counted`() = runTest {
        for (id in listOf("first", "second", "third")) repository.save(workOf(id, id))
        open.opened("first", now = 1)
        open.opened("second", now = 2)
        open.closed("third", now = 0, comesBack = true)
        val back = assertNotNull(open.takeBack())
        assertEquals("second", back.work.id)
        assertEquals(1, back.others)
        assertNull(open.takeBack())
        assertEquals(3, repository.projects().size)
    }

    @Test
    fun `a window that was killed is told from one that was closed`() = runTest {
        repository.save(workOf("beep"))
        open.opened("one", now = 1)
        val killed = assertNotNull(open.takeBack())
        assertTrue(killed.endedAbnormally)
        killed.claim.release()
        open.closed("one", now = 2, comesBack = true)
        assertFalse(assertNotNull(open.takeBack()).endedAbnormally)
    }

    @Test
    fun `a window that could not write any more that it ended is believed`() = runTest {
        repository.save(workOf("beep"))
        open.opened("one", now = 1)
        val left = assertNotNull(open.takeBack(hasEnded = { it == "one" }))
        assertFalse(left.endedAbnormally)
        assertFalse(assertNotNull(open.takeBack("one", left.claim, hasEnded = true)).endedAbnormally)
        assertTrue(assertNotNull(open.takeBack("one", left.claim, hasEnded = false)).endedAbnormally)
        assertNull(open.takeBack("gone", left.claim, hasEnded = true))
    }

    @Test
    fun `a work that was put away does not come back by itself`() = runTest {
        repository.save(workOf("beep"))
        open.opened("one", now = 1)
        open.closed("one", now = 2, comesBack = false)
        assertNull(open.takeBack())
        assertEquals("one", repository.projects().single().id)
    }

    @Test
    fun `a work that another window has is left to it`() = runTest {
        repository.save(workOf("beep"))
        open.opened("one", now = 1)
        assertNotNull(ProjectRepository(store).claim("one"))
        assertNull(open.takeBack())
    }

    @Test
    fun `works that are broken or gone are passed over`() = runTest {
        repository.save(workOf("beep"))
        store.write("work-broken.a", "nothing")
        open.opened("one", now = 1)
        open.opened("broken", now = 2)
        open.opened("gone", now = 3)
        assertEquals("one", open.takeBack()?.work?.id)
        assertEquals(setOf("work-one.a", "work-broken.a", "open-one", "open-broken"), store.names().toSet())
    }

    @Test
    fun `what a window has left of a work that was never kept comes back under a name of its own`() = runTest {
        repository.save(workOf("beep", id = "other"))
        assertTrue(open.saveHandover("one", handoverText(workOf("forward 7"))))
        val back = assertNotNull(open.takeBack())
        assertFalse(back.endedAbnormally)
        assertEquals("one" to "Maze 2", back.work.id to back.work.name)
        assertEquals(projectOf("forward 7"), back.work.project)
    }

    @Test
    fun `of what was left and what was kept the newer one counts`() = runTest {
        repository.save(workOf("forward 1", keptAt = 2_000))
        assertTrue(open.saveHandover("one", handoverText(workOf("forward 2", keptAt = 1_999))))
        assertEquals(projectOf("forward 1"), store.work().work.project)
        assertTrue(open.saveHandover("one", handoverText(workOf("forward 3", keptAt = 2_000))))
        assertEquals(projectOf("forward 3"), store.work().work.project)
        assertTrue(
            open.saveHandover("one", handoverText(workOf("forward 4", keptAt = 9_000)).dropLast(3)),
            "what is torn is of no use",
        )
        assertEquals(projectOf("forward 3"), store.work().work.project)
    }

    @Test
    fun `what was left stays where it is as long as it cannot be kept`() = runTest {
        val full = object : KeyValueStore by store {
            override suspend fun write(name: String, text: String): StoreResult = StoreResult.Full
        }
        assertFalse(OpenProjects(full, ProjectRepository(full)).saveHandover("one", handoverText(workOf("forward 1"))))
        val newer = handoverText(
            workOf("forward 1"),
        ).replaceFirst("robotran-work 1", "robotran-work 2").substringBeforeLast("end ")
        assertFalse(open.saveHandover("one", "${newer}end ${FileStamp.of(newer).text}\n"), "of a newer Robotran")
    }
}
