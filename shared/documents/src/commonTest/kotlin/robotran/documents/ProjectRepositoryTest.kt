package robotran.documents

import kotlinx.coroutines.test.runTest
import robotran.projects.Project
import robotran.projects.ProjectLimits
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

class ProjectRepositoryTest {
    private val store = MemoryKeyValueStore()
    private val repository = ProjectRepository(store)

    @Test
    fun `a work comes back as it was kept`() = runTest {
        val file = SaveTarget(FileReference("/home/ann/maze.robotran", "maze.robotran"), FileStamp.of("x"))
        val work = workOf(
            "beep\n\t// ñ🤖 \"end \"\nend 0123456789abcdef\n",
        ).copy(name = "Ann's \"Maze\" \uD83E", file = file, saved = true)
        assertEquals(SaveResult.Saved, repository.save(work))
        assertEquals(SavedProjectResult.Found(work, isPartial = false), ProjectRepository(store).read("one"))
    }

    @Test
    fun `the last of many copies comes back and no more than two are there`() = runTest {
        for (number in 1..7) repository.save(workOf("forward $number"))
        assertEquals("forward 7", store.work().work.text)
        ProjectRepository(store).save(workOf("forward 8"))
        assertEquals("forward 8", store.work().work.text)
        assertEquals(2, store.names().size)
    }

    @Test
    fun `being killed at any byte of a write leaves the copy before it`() = runTest {
        repository.save(workOf("forward 1"))
        repository.save(workOf("forward 2"))
        val whole = SavedProjectText.write(workOf("forward 3"), order = 3)
        for (room in 0..whole.length) {
            val disk = MemoryKeyValueStore(store.texts)
            val kept =
                runCatching { ProjectRepository(CuttingStore(disk, room, kills = true)).save(workOf("forward 3")) }
            assertEquals(
                if (room == whole.length) {
                    "forward 3"
                } else {
                    "forward 2"
                },
                disk.work().work.text,
                "killed after $room",
            )
            assertEquals(kept.isSuccess, room == whole.length)
        }
    }

    @Test
    fun `a work that was cut off while it was written says so`() = runTest {
        repository.save(workOf("forward 1"))
        runCatching { ProjectRepository(CuttingStore(store, room = 40, kills = true)).save(workOf("forward 2")) }
        assertTrue(store.work().isPartial)
    }

    @Test
    fun `any one character changed makes a copy count for nothing`() = runTest {
        repository.save(workOf("forward 1"))
        repository.save(workOf("forward 2"))
        val (name, text) = store.texts.entries.single { "forward 2" in it.value }
        for (place in text.indices) {
            val disk = MemoryKeyValueStore(
                store.texts + (
                    name to text.replaceRange(
                        place,
                        place + 1,
                        if (text[place] == '7') {
                            "8"
                        } else {
                            "7"
                        },
                    )
                ),
            )
            assertEquals("forward 1", disk.work().work.text, "changed at $place")
        }
    }

    @Test
    fun `a full disk is told and the work before stays`() = runTest {
        repository.save(workOf("forward 1"))
        for (room in listOf(0, 1, 100)) {
            assertEquals(
                SaveResult.Full,
                ProjectRepository(CuttingStore(store, room, kills = false)).save(workOf("forward 2")),
            )
            assertEquals("forward 1", store.work().work.text)
        }
        assertEquals(SaveResult.Saved, ProjectRepository(store).save(workOf("forward 2")))
        assertEquals("forward 2", store.work().work.text)
    }

    @Test
    fun `a work that could not be read again is not written over one that can`() = runTest {
        repository.save(workOf("forward 1"))
        assertEquals(SaveResult.TooLong, repository.save(workOf("beep\n".repeat(ProjectLimits.MAXIMUM_LINES + 1))))
        assertEquals("forward 1", store.work().work.text)
    }

    @Test
    fun `works are listed with the newest first and without broken ones`() = runTest {
        repository.save(workOf("beep", id = "old", keptAt = 5))
        repository.save(workOf("beep", id = "new", keptAt = 7).copy(name = "Town"))
        store.write("work-broken.a", "robotran-work 1\n{")
        store.write("settings", "language=de")
        assertEquals(
            listOf(ProjectSummary("new", "Town", 7), ProjectSummary("old", "Maze", 5)),
            repository.projects(),
        )
    }

    @Test
    fun `a deleted work is gone with both copies`() = runTest {
        repeat(2) { repository.save(workOf("beep")) }
        assertEquals(StoreResult.Done, repository.delete("one"))
        assertEquals(emptyList(), store.names())
        assertEquals(SavedProjectResult.Missing, repository.read("one"))
    }

    @Test
    fun `what a newer Robotran has kept is not used and not broken`() = runTest {
        repository.save(workOf("beep"))
        val sealed = "robotran-work 2\n{}\n"
        store.write("work-one.b", "${sealed}end ${FileStamp.of(sealed).text}\n")
        assertIs<SavedProjectResult.Unusable>(repository.read("one"))
    }

    @Test
    fun `two windows cannot have the same work`() = runTest {
        val claim = assertNotNull(repository.claim("one"))
        assertNull(ProjectRepository(store).claim("one"))
        claim.release()
        assertNotNull(ProjectRepository(store).claim("one"))
    }

    @Test
    fun `a project with nothing but a world is kept too`() = runTest {
        val work = SavedProject("bare", "Bare", 1, Project(projectOf("").world))
        repository.save(work)
        assertEquals(work, store.work("bare").work)
    }
}
