package robotran.assignments.collecting

import robotran.assignments.messages.CollectingMessages

/**
 * Finds all files among the collected ones, also in zips and zips inside them, within the [CollectingLimits]. A folder
 * in which there is none is a [FoundFile] without a name, so that its pupil is not forgotten.
 */
internal class Unpacking(private val messages: CollectingMessages) {
    private val found = mutableListOf<FoundFile>()
    private val folders = linkedSetOf<List<String>>()

    suspend fun unpack(files: List<CollectedFile>): List<FoundFile> {
        for (file in files) {
            val path = pathOf(file.path) ?: continue
            if (found.size >= CollectingLimits.MAXIMUM_FILES) break
            when {
                isNoFile(file.path, path) -> Unit

                FoundKind.of(path.last()) == FoundKind.ZIP -> {
                    found += unpacked(file.bytes, path, CollectingLimits.MAXIMUM_ZIP_BYTES, 1)
                }

                FoundKind.of(path.last()) == FoundKind.OTHER -> found += FoundFile(path, FoundContent.Ignored)
                else -> found += FoundFile(path, FoundContent.Bytes(file.bytes))
            }
        }
        return found + emptyFolders()
    }

    /** Whether [path] is a folder, or something that an editor has left behind; its folder is noted. */
    private fun isNoFile(written: String, path: List<String>): Boolean {
        val isFolder = written.endsWith('/') || written.endsWith('\\')
        if (!isFolder && !isLeftBehind(path.last())) return false
        (if (isFolder) path else path.dropLast(1)).takeIf { it.isNotEmpty() }?.let(folders::add)
        return true
    }

    private fun emptyFolders(): List<FoundFile> {
        val full = found.flatMapTo(mutableSetOf()) { file -> file.path.indices.map { file.path.take(it) } }
        val empty = folders.filter { it !in full }
        // A folder that holds only empty ones is none itself.
        val holding = empty.flatMapTo(mutableSetOf()) { path -> path.indices.map { path.take(it) } }
        return empty.filter { it !in holding }.map { FoundFile(it + "", FoundContent.Ignored) }
    }

    /** The files in [zip]; or the zip itself with a problem, if it cannot be unpacked or becomes too large. */
    private suspend fun unpacked(zip: ByteArray, path: List<String>, budget: Int, depth: Int): List<FoundFile> {
        val name = path.last()
        val problem = { reason: String -> listOf(FoundFile(path, FoundContent.Problem(reason))) }
        val entries = when (val reading = readZip(zip)) {
            is ZipReading.Read -> reading.entries
            ZipReading.Broken -> return problem(messages.brokenZip(name))
            ZipReading.Zip64 -> return problem(messages.zip64(name))
            ZipReading.TooManyEntries -> return problem(messages.tooManyEntries(name, CollectingLimits.MAXIMUM_ENTRIES))
        }
        val folder = path.dropLast(1) + stemOf(name)
        val files = mutableListOf<FoundFile>()
        var left = budget
        for (entry in entries) {
            val place = folder + (pathOf(entry.path) ?: continue)
            if (isNoFile(entry.path, place)) continue
            val kind = FoundKind.of(place.last())
            if (kind == FoundKind.OTHER) {
                files += FoundFile(place, FoundContent.Ignored)
                continue
            }
            val isZip = kind == FoundKind.ZIP
            if (isZip && depth == CollectingLimits.MAXIMUM_DEPTH) {
                files += FoundFile(place, FoundContent.Problem(messages.zipTooDeep(place.last(), depth)))
                continue
            }
            val limit = if (isZip) CollectingLimits.MAXIMUM_INNER_ZIP_BYTES else CollectingLimits.MAXIMUM_FILE_BYTES
            val reason = problemOf(entry, place.last(), limit)
            val content = if (reason == null) entry.content(minOf(limit, left)) else null
            if (content == null && entry.size > left) return problem(messages.zipTooLarge(name, budget))
            left -= content?.size ?: 0
            if (content != null && isZip) {
                val inner = unpacked(content, place, minOf(left, limit), depth + 1)
                left -= inner.sumOf { (it.content as? FoundContent.Bytes)?.bytes?.size ?: 0 }
                files += inner
            } else {
                val problemOfFile = FoundContent.Problem(reason ?: messages.brokenZip(place.last()))
                files += FoundFile(place, content?.let(FoundContent::Bytes) ?: problemOfFile)
            }
            if (found.size + files.size > CollectingLimits.MAXIMUM_FILES) {
                return problem(messages.tooManyEntries(name, CollectingLimits.MAXIMUM_FILES))
            }
        }
        return files
    }

    private fun problemOf(entry: ZippedFile, name: String, limit: Int): String? = when {
        entry.isEncrypted -> messages.encrypted(name)
        !entry.isKnownMethod -> messages.unknownCompression(name)
        entry.size > limit -> messages.tooLarge(name, limit)
        else -> null
    }
}
