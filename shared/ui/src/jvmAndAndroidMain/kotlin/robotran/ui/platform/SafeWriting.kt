package robotran.ui.platform

import robotran.documents.StoreResult
import java.io.IOException
import java.nio.ByteBuffer
import java.nio.channels.FileChannel
import java.nio.file.AtomicMoveNotSupportedException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardCopyOption.ATOMIC_MOVE
import java.nio.file.StandardCopyOption.REPLACE_EXISTING
import java.nio.file.StandardOpenOption.CREATE
import java.nio.file.StandardOpenOption.TRUNCATE_EXISTING
import java.nio.file.StandardOpenOption.WRITE

/** Writes [bytes] to [path] atomically: writes a temporary file next to it, syncs it to disk, and renames it. */
fun writeSafely(path: Path, bytes: ByteArray): StoreResult {
    val target = if (Files.isSymbolicLink(path)) path.toRealPath() else path.toAbsolutePath()
    val beside = target.resolveSibling(".${target.fileName}.new")
    return try {
        Files.createDirectories(target.parent)
        FileChannel.open(beside, CREATE, WRITE, TRUNCATE_EXISTING).use { channel ->
            val buffer = ByteBuffer.wrap(bytes)
            while (buffer.hasRemaining()) channel.write(buffer)
            channel.force(true)
        }
        replace(beside, target)
        StoreResult.Done
    } catch (problem: IOException) {
        val room = roomAt(target)
        runCatching { Files.deleteIfExists(beside) }
        if (room < bytes.size || problem.saysFull()) {
            StoreResult.Full
        } else {
            StoreResult.Failed(problem.message ?: problem.toString())
        }
    } catch (problem: SecurityException) {
        StoreResult.Failed(problem.message ?: problem.toString())
    }
}

private fun replace(from: Path, to: Path) {
    try {
        Files.move(from, to, ATOMIC_MOVE, REPLACE_EXISTING)
    } catch (_: AtomicMoveNotSupportedException) {
        Files.move(from, to, REPLACE_EXISTING)
    }
}

/** Read before the temporary file is deleted, which frees space. */
private fun roomAt(path: Path): Long =
    runCatching { Files.getFileStore(path.parent).usableSpace }.getOrDefault(Long.MAX_VALUE)

private fun IOException.saysFull(): Boolean = FULL.any { it in message.orEmpty().lowercase() }

/** Messages of Linux, Android, macOS and Windows as passed on by Java. */
private val FULL = listOf("no space left", "enospc", "disk quota", "not enough space", "disk full")
