package robotran.ui.platform

import kotlinx.coroutines.test.runTest
import robotran.documents.ProjectRepository
import robotran.documents.SaveResult
import robotran.documents.SavedProjectResult
import robotran.documents.StoreResult
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.deleteRecursively
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.readText
import kotlin.io.path.writeText
import kotlin.test.AfterTest
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFailsWith
import kotlin.test.assertIs
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

@OptIn(kotlin.io.path.ExperimentalPathApi::class)
class FolderKeyValueStoreTest {
    private val folder: Path = Files.createTempDirectory("store")
    private val store = FolderKeyValueStore(folder.resolve("not/there/yet"))

    @AfterTest
    fun clean() = folder.deleteRecursively()

    @Test
    fun `texts come back as they were written`() = runTest {
        assertEquals(emptyList(), store.names())
        assertNull(store.read("settings"))
        assertEquals(StoreResult.Done, store.write("settings", "ñ🤖\r\n\u0000"))
        assertEquals("ñ🤖\r\n\u0000", FolderKeyValueStore(folder.resolve("not/there/yet")).read("settings"))
        assertEquals(listOf("settings"), store.names())
        assertEquals(StoreResult.Done, store.remove("settings"))
        assertEquals(StoreResult.Done, store.remove("settings"))
        assertEquals(emptyList(), store.names())
    }

    @Test
    fun `names that lead out of the folder are not taken`() = runTest {
        for (name in listOf("../x", "", "a/b", "A", "a".repeat(99))) {
            assertFailsWith<IllegalArgumentException> {
                store.read(name)
            }
        }
    }

    @Test
    fun `a folder that cannot be written is told`() = runTest {
        folder.resolve("not").writeText("a file where a folder should be")
        assertIs<StoreResult.Failed>(store.write("settings", "x"))
    }

    @Test
    fun `a claim keeps other windows and other processes out until it is released or its process is gone`() = runTest {
        val claim = assertNotNull(store.claim("work-one"))
        assertNull(FolderKeyValueStore(folder.resolve("not/there/yet")).claim("work-one"))
        claim.release()
        val other = AutosavingProcess.start(folder.resolve("not/there/yet"))
        try {
            other.awaitCopies(3)
            assertNull(store.claim("work-one"))
        } finally {
            other.kill()
        }
        assertNotNull(store.claim("work-one")).release()
    }

    @Test
    fun `a process that is killed while it keeps its work loses at most the last change`() = runTest {
        val place = folder.resolve("killed")
        var last = 0
        repeat(KILLS) { time ->
            val other = AutosavingProcess.start(place)
            val described = other.awaitCopies(3 + 7 * time)
            other.kill()
            val toldInAll = other.described.coerceAtLeast(described)
            val found = assertIs<SavedProjectResult.Found>(
                ProjectRepository(FolderKeyValueStore(place)).read("one"),
            ).work
            val kept = found.name.toInt()
            assertTrue(kept >= last + toldInAll, "$kept is there, but ${last + toldInAll} was told to be kept")
            last = kept
        }
    }

    @Test
    fun `a torn file is passed over for the one before it`() = runTest {
        val shelf = ProjectRepository(store)
        repeat(2) { assertEquals(SaveResult.Saved, shelf.save(workFor(it.toString()))) }
        val newest = folder.resolve("not/there/yet").listDirectoryEntries("work-one.*").single {
            "\"1\"" in
                it.readText()
        }
        newest.writeText(newest.readText().dropLast(100))
        val found = assertIs<SavedProjectResult.Found>(ProjectRepository(store).read("one"))
        assertEquals("0", found.work.name)
        assertTrue(found.isPartial)
    }

    private companion object {
        const val KILLS = 4
    }
}
