package robotran.cli.files

import robotran.cli.messages.FileMessages
import robotran.tinyvm.config.TinyVmLimits
import java.io.InputStream
import java.nio.file.Path
import java.util.jar.Attributes
import java.util.jar.JarFile
import java.util.jar.Manifest
import java.util.zip.ZipEntry
import java.util.zip.ZipFile
import kotlin.io.path.fileSize

/**
 * Reads all class files in the jar [name]. Its manifest may name the main class. Never unpacks more than the maximum
 * size of a program.
 */
internal fun readJar(name: String, messages: FileMessages): ReadProgram =
    reading(name, messages, ReadProgram::Failure) {
        val path = Path.of(name)
        notAFile(path, name, messages)?.let { return@reading ReadProgram.Failure(it) }
        if (path.fileSize() > LARGEST_JAR_BYTES) {
            return@reading ReadProgram.Failure(messages.fileTooLarge(name, LARGEST_JAR_BYTES))
        }
        ZipFile(path.toFile()).use { jar ->
            val entries = jar.entries().asSequence().filter { !it.isDirectory && isClassFile(it.name) }
            val files = LinkedHashMap<String, ByteArray>()
            var bytes = 0
            for (entry in entries.take(TinyVmLimits.CLASSES + 1)) {
                val content = jar.open(entry) { it.readNBytes(TinyVmLimits.CLASS_FILE_BYTES + 1) }
                if (content.size > TinyVmLimits.CLASS_FILE_BYTES) {
                    return@reading tooLarge("$name: ${entry.name}", messages)
                }
                bytes += content.size
                if (bytes > MAX_JAR_BYTES) {
                    return@reading ReadProgram.Failure(messages.jarTooLarge(name, MAX_JAR_BYTES))
                }
                files[entry.name] = content
            }
            programOf(nameOf(name), files, messages, mainClassOf(jar))
        }
    }

/** The main class in the manifest of [jar], with slashes; null if the manifest is missing, unreadable or names none. */
private fun mainClassOf(jar: ZipFile): String? {
    val entry = jar.getEntry(JarFile.MANIFEST_NAME) ?: return null
    val bytes = jar.open(entry) { it.readNBytes(MAX_MANIFEST_BYTES) }
    val manifest = runCatching { Manifest(bytes.inputStream()) }.getOrNull()
    return manifest?.mainAttributes?.getValue(Attributes.Name.MAIN_CLASS)?.trim()?.replace('.', '/')
}

private fun <T> ZipFile.open(entry: ZipEntry, read: (InputStream) -> T): T = getInputStream(entry).use(read)

/** A jar may also hold images and sounds, but its whole directory is read. */
private const val LARGEST_JAR_BYTES = 64_000_000L

/** Far more than the brick can hold. */
private const val MAX_JAR_BYTES = 16_000_000
private const val MAX_MANIFEST_BYTES = 100_000
