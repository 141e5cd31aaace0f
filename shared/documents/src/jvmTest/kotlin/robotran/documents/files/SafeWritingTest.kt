package robotran.documents.files

import robotran.documents.StoreResult
import java.nio.channels.FileChannel
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption.WRITE
import java.nio.file.attribute.FileTime
import java.nio.file.attribute.PosixFilePermissions
import kotlin.concurrent.thread
import kotlin.io.path.createDirectory
import kotlin.io.path.createFile
import kotlin.io.path.getPosixFilePermissions
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.readBytes
import kotlin.io.path.readText
import kotlin.io.path.setLastModifiedTime
import kotlin.io.path.setPosixFilePermissions
import kotlin.io.path.writeText
import kotlin.test.AfterTest
import kotlin.test.Test
import kotlin.test.assertContentEquals
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

class SafeWritingTest {
    private val folder: Path = Files.createTempDirectory("writing")
    private val file = folder.resolve("work.robotran")

    @AfterTest
    fun clean() {
        folder.toFile().deleteRecursively()
    }

    private fun write(text: String) = writeSafely(file, text.encodeToByteArray())

    private fun names() = folder.listDirectoryEntries().map { it.name }.sorted()

    @Test
    fun `a file and its folders are made`() {
        val deep = folder.resolve("a/b/work.robotran")
        assertEquals(StoreResult.Done, writeSafely(deep, byteArrayOf(1, 2)))
        assertContentEquals(byteArrayOf(1, 2), deep.readBytes())
    }

    @Test
    fun `who reads a file while it is written sees all of the old or all of the new`() {
        val (old, new) = listOf("o", "n").map { it.repeat(300_000) }
        write(old)
        val writer = thread { repeat(WRITES) { write(if (it % 2 == 0) new else old) } }
        val seen = mutableSetOf<String>()
        while (writer.isAlive) seen += file.readText()
        writer.join()
        assertTrue(setOf(old, new).containsAll(seen), "${seen.map { it.length }}")
    }

    @Test
    fun `a full disk is told, what was there stays, and nothing lies about`() {
        write("before")
        // Linux has a device that is always full.
        val result = writeSafely(file, "after".encodeToByteArray()) { target ->
            TemporaryFile(
                target.resolveSibling("full").createFile(),
                FileChannel.open(Path.of("/dev/full"), WRITE),
            )
        }
        assertEquals(StoreResult.Full, result)
        assertEquals("before", file.readText())
        assertEquals(listOf("work.robotran"), names())
    }

    @Test
    fun `a file keeps its permissions`() {
        write("before")
        for (permissions in listOf("rw-------", "rw-rw-r--", "rwxr-xr-x")) {
            file.setPosixFilePermissions(PosixFilePermissions.fromString(permissions))
            assertEquals(StoreResult.Done, write("after"))
            assertEquals(permissions, PosixFilePermissions.toString(file.getPosixFilePermissions()))
        }
    }

    @Test
    fun `writing leaves nothing beside the file, and follows a link to it`() {
        val link = Files.createSymbolicLink(folder.resolve("link.robotran"), file.also { it.writeText("x") })
        assertEquals(StoreResult.Done, writeSafely(link, byteArrayOf(1, 2)))
        assertContentEquals(byteArrayOf(1, 2), file.readBytes())
        assertTrue(Files.isSymbolicLink(link))
        assertEquals(listOf("link.robotran", "work.robotran"), names())
    }

    @Test
    fun `a temporary file of another writer is not touched, an old one is cleared away`() {
        val other = folder.resolve(".work.robotran.new").also { it.writeText("of another writer") }
        assertEquals(StoreResult.Done, write("mine"))
        assertEquals("of another writer", other.readText())
        other.setLastModifiedTime(FileTime.fromMillis(0))
        assertEquals(StoreResult.Done, write("mine again"))
        assertEquals(listOf("work.robotran"), names())
    }

    @Test
    fun `a link in place of the temporary file leads nowhere`() {
        val secret = folder.resolve("secret").also { it.writeText("whole") }
        Files.createSymbolicLink(folder.resolve(".work.robotran.new"), secret)
        assertEquals(StoreResult.Done, write("mine"))
        assertEquals("whole", secret.readText())
        assertEquals("mine", file.readText())
    }

    @Test
    fun `a folder is not replaced`() {
        file.createDirectory()
        assertIs<StoreResult.Failed>(write("mine"))
        assertEquals(listOf("work.robotran"), names())
    }

    @Test
    fun `a device stays a device`() {
        assertEquals(StoreResult.Done, writeSafely(Path.of("/dev/null"), byteArrayOf(1)))
        assertTrue(Files.exists(Path.of("/dev/null")) && !Files.isRegularFile(Path.of("/dev/null")))
        assertEquals(StoreResult.Full, writeSafely(Path.of("/dev/full"), byteArrayOf(1)))
    }

    @Test
    fun `the longest name that a file may have is no hindrance`() {
        val long = folder.resolve("ä".repeat(120) + ".robotran")
        assertEquals(StoreResult.Done, writeSafely(long, byteArrayOf(1)))
        assertEquals(1, long.readBytes().size)
    }

    private companion object {
        const val WRITES = 60
    }
}
