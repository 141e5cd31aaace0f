package robotran.ui.platform

import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.withContext
import robotran.documents.ProjectLock
import robotran.documents.StoreResult
import robotran.documents.files.writeSafely
import robotran.workshop.platform.KeyValueStore
import java.io.IOException
import java.nio.channels.FileChannel
import java.nio.channels.FileLock
import java.nio.channels.OverlappingFileLockException
import java.nio.charset.CharacterCodingException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption.CREATE
import java.nio.file.StandardOpenOption.WRITE
import java.util.concurrent.ConcurrentHashMap
import kotlin.coroutines.CoroutineContext
import kotlin.io.path.deleteIfExists
import kotlin.io.path.exists
import kotlin.io.path.isRegularFile
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.readText

/**
 * Texts as files in [folder], one each. Claims are OS locks on empty files next to them, which the OS releases when the
 * process ends for any reason.
 *
 * @param reading the context for reading texts and for claims; writes never run on the caller's thread.
 */
class FolderKeyValueStore(private val folder: Path, private val reading: CoroutineContext = Dispatchers.IO) :
    KeyValueStore {
    override suspend fun names(): List<String> = withContext(reading) {
        try {
            val files = folder.listDirectoryEntries("*$TEXT").filter { it.isRegularFile() && !it.name.startsWith(".") }
            files.map { it.name.removeSuffix(TEXT) }
        } catch (_: IOException) {
            emptyList()
        }
    }

    override suspend fun read(name: String): String? = withContext(reading) {
        try {
            fileOf(name).takeIf { it.exists() }?.readText()
        } catch (_: IOException) {
            null
        } catch (_: CharacterCodingException) {
            null
        }
    }

    override suspend fun write(name: String, text: String): StoreResult =
        withContext(Dispatchers.IO) { writeSafely(fileOf(name), text.encodeToByteArray()) }

    override suspend fun remove(name: String): StoreResult = withContext(Dispatchers.IO) {
        try {
            fileOf(name).deleteIfExists()
            StoreResult.Done
        } catch (problem: IOException) {
            StoreResult.Failed(problem.message ?: problem.toString())
        }
    }

    override suspend fun claim(name: String): ProjectLock? = withContext(reading) {
        val file = folder.resolve("claims").resolve("${checked(name)}.lock").toAbsolutePath()
        if (CLAIMED.putIfAbsent(file, NOTHING) != null) return@withContext null
        when (val lock = lock(file)) {
            Locking.Taken -> null.also { CLAIMED.remove(file) }

            // Without OS locks, at least the windows of this process are separated.
            Locking.Impossible -> ProjectLock { CLAIMED.remove(file) }

            is Locking.Locked -> {
                CLAIMED[file] = lock.channel
                ProjectLock { CLAIMED.remove(file)?.close() }
            }
        }
    }

    private fun lock(file: Path): Locking = try {
        Files.createDirectories(file.parent)
        val channel = FileChannel.open(file, CREATE, WRITE)
        val lock: FileLock? = try {
            channel.tryLock()
        } catch (_: OverlappingFileLockException) {
            null
        }
        if (lock == null) Locking.Taken.also { channel.close() } else Locking.Locked(channel)
    } catch (_: IOException) {
        Locking.Impossible
    }

    private fun fileOf(name: String): Path = folder.resolve("${checked(name)}$TEXT")

    private fun checked(name: String): String = name.also {
        require(NAME.matches(it)) { "$it is not the name of a text" }
    }

    private sealed interface Locking {
        class Locked(val channel: FileChannel) : Locking

        data object Taken : Locking

        data object Impossible : Locking
    }

    private companion object {
        const val TEXT = ".txt"
        const val LONGEST_NAME = robotran.documents.KeyValueStore.MAXIMUM_NAME
        val NAME = Regex("[a-z][a-z0-9.-]{0,${LONGEST_NAME - 1}}")

        /**
         * An OS lock belongs to the whole process, so this map tracks its windows. A lock ends with its channel, which
         * is therefore kept here and not by callers.
         */
        val CLAIMED = ConcurrentHashMap<Path, AutoCloseable>()
        val NOTHING = AutoCloseable { }
    }
}
