package robotran.documents.files

import robotran.documents.StoreResult
import java.io.IOException
import java.nio.ByteBuffer
import java.nio.channels.WritableByteChannel
import java.nio.file.AccessDeniedException
import java.nio.file.AtomicMoveNotSupportedException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardCopyOption.ATOMIC_MOVE
import java.nio.file.StandardCopyOption.REPLACE_EXISTING
import java.nio.file.StandardOpenOption.WRITE

/**
 * Writes [bytes] to [path], the only way in which this code base writes a file that people see. Whatever happens
 * meanwhile, the file has either all of its old content or all of the new: a temporary file beside it is written, synced
 * to disk, and renamed. A file keeps its permissions, a symbolic link its target, which gets the content. A device or a
 * pipe is written as it is.
 */
fun writeSafely(path: Path, bytes: ByteArray): StoreResult = writeSafely(path, bytes, ::openTemporary)

/** @param open creates the temporary file. */
internal fun writeSafely(path: Path, bytes: ByteArray, open: (Path) -> TemporaryFile): StoreResult = try {
    when {
        Files.isDirectory(path) -> StoreResult.Failed("$path: Is a directory")
        Files.exists(path) && !Files.isRegularFile(path) -> writeThrough(path, bytes)

        else -> replaceContent(
            if (Files.isSymbolicLink(path)) path.toRealPath() else path.toAbsolutePath(),
            bytes,
            open,
        )
    }
} catch (problem: IOException) {
    resultOf(problem, isFull = false)
} catch (problem: SecurityException) {
    StoreResult.Failed(problem.message ?: problem.toString())
}

private fun replaceContent(target: Path, bytes: ByteArray, open: (Path) -> TemporaryFile): StoreResult {
    // A rename would also replace a file that is read-only.
    if (Files.exists(target) &&
        !Files.isWritable(target)
    ) {
        throw AccessDeniedException("$target", null, "Read-only file")
    }
    target.parent?.let { if (!Files.isDirectory(it)) Files.createDirectories(it) }
    val temporary = open(target)
    return try {
        temporary.write(bytes)
        replace(temporary.path, target)
        temporary.settle()
        StoreResult.Done
    } catch (problem: IOException) {
        // Read before the temporary file is deleted, which frees space.
        val room = roomAt(target)
        temporary.discard()
        resultOf(problem, isFull = room < bytes.size)
    }
}

private fun writeThrough(path: Path, bytes: ByteArray): StoreResult {
    Files.newByteChannel(path, WRITE).use { it.writeAll(bytes) }
    return StoreResult.Done
}

internal fun WritableByteChannel.writeAll(bytes: ByteArray) {
    val buffer = ByteBuffer.wrap(bytes)
    while (buffer.hasRemaining()) write(buffer)
}

private fun replace(from: Path, to: Path) {
    try {
        Files.move(from, to, ATOMIC_MOVE, REPLACE_EXISTING)
    } catch (_: AtomicMoveNotSupportedException) {
        Files.move(from, to, REPLACE_EXISTING)
    }
}

private fun roomAt(path: Path): Long =
    runCatching { Files.getFileStore(path.parent).usableSpace }.getOrDefault(Long.MAX_VALUE)

private fun resultOf(problem: IOException, isFull: Boolean): StoreResult =
    if (isFull || problem.saysFull()) StoreResult.Full else StoreResult.Failed(problem.message ?: problem.toString())

private fun IOException.saysFull(): Boolean = FULL.any { it in message.orEmpty().lowercase() }

/** Messages of Linux, Android, macOS and Windows as passed on by Java. */
private val FULL = listOf("no space left", "enospc", "disk quota", "not enough space", "disk full")
