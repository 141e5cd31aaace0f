package robotran.documents.files

import java.io.IOException
import java.nio.channels.FileChannel
import java.nio.file.FileAlreadyExistsException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption.CREATE_NEW
import java.nio.file.StandardOpenOption.WRITE
import java.nio.file.attribute.PosixFileAttributeView
import java.util.UUID
import java.util.concurrent.ConcurrentHashMap

/**
 * A file beside another one, whose new content it gets.
 *
 * @param abandoned one that a killed process has left; null for none.
 */
internal class TemporaryFile(val path: Path, private val channel: FileChannel, private val abandoned: Path? = null) {
    init {
        Unfinished.paths.add(path)
    }

    /** Returns once [bytes] are on the disk. */
    fun write(bytes: ByteArray) = channel.use {
        it.writeAll(bytes)
        it.force(true)
    }

    /** It has become the file. */
    fun settle() {
        Unfinished.paths.remove(path)
        abandoned?.let { runCatching { Files.deleteIfExists(it) } }
    }

    fun discard() {
        runCatching { channel.close() }
        runCatching { Files.deleteIfExists(path) }
        Unfinished.paths.remove(path)
    }
}

/**
 * Creates a temporary file beside [target], with its permissions. It follows no link, and no two writers share one. Its
 * name is mostly the same, so that the next write finds what a killed process has left.
 */
internal fun openTemporary(target: Path): TemporaryFile {
    val start = ".${target.fileName.toString().take(LONGEST_START)}"
    val plain = target.resolveSibling("$start.new")
    val file = try {
        TemporaryFile(plain, FileChannel.open(plain, CREATE_NEW, WRITE))
    } catch (_: FileAlreadyExistsException) {
        val other = target.resolveSibling("$start.${UUID.randomUUID()}.new")
        TemporaryFile(other, FileChannel.open(other, CREATE_NEW, WRITE), plain.takeIf(::isAbandoned))
    }
    copyAccess(target, file.path)
    return file
}

private fun isAbandoned(path: Path): Boolean = runCatching {
    System.currentTimeMillis() - Files.getLastModifiedTime(path).toMillis() > LONGEST_WRITE_MILLISECONDS
}.getOrDefault(false)

/** Before there is any content, which others may not be allowed to read. Another owner can be set by few. */
private fun copyAccess(from: Path, to: Path) {
    if (!Files.exists(from)) return
    val old = Files.getFileAttributeView(from, PosixFileAttributeView::class.java) ?: return
    val new = Files.getFileAttributeView(to, PosixFileAttributeView::class.java) ?: return
    try {
        val access = old.readAttributes()
        runCatching { new.setOwner(access.owner()) }
        runCatching { new.setGroup(access.group()) }
        new.setPermissions(access.permissions())
    } catch (_: IOException) {
        // Some file systems of other machines have no permissions.
    } catch (_: UnsupportedOperationException) {
        // The same.
    }
}

/** The temporary files of this process, deleted if it is asked to end while it writes. */
private object Unfinished {
    val paths: MutableSet<Path> = ConcurrentHashMap.newKeySet()

    init {
        // Fails only if the process is already ending.
        runCatching {
            Runtime.getRuntime().addShutdownHook(
                Thread { paths.forEach { path -> runCatching { Files.deleteIfExists(path) } } },
            )
        }
    }
}

/** So that the name of the temporary file is not too long where that of the file is just short enough. */
private const val LONGEST_START = 40
private const val LONGEST_WRITE_MILLISECONDS = 600_000L
