package robotran.desktop

import robotran.programs.ProgramSource
import robotran.tinyvm.TinyVmLimits
import java.io.IOException
import java.nio.file.InvalidPathException
import java.nio.file.NoSuchFileException
import java.nio.file.Path
import java.util.jar.Attributes
import java.util.jar.JarFile
import java.util.zip.ZipException
import kotlin.io.path.extension
import kotlin.io.path.fileSize
import kotlin.io.path.isDirectory
import kotlin.io.path.isRegularFile
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.nameWithoutExtension
import kotlin.io.path.readBytes
import kotlin.io.path.walk

/** Reads the class files [names], and those of the classes inside these, which lie beside them. */
internal fun readClassFiles(names: List<String>): ProgramFile =
    reading(names.first()) {
        val paths = names.map(Path::of).flatMap { listOf(it) + innerClassesOf(it) }.distinct()
        compiled(nameOf(names.first()), paths.map { it.toString() to it })
    }

/** Reads all class files in the folder [name] and the folders in it. */
internal fun readClassFolder(name: String): ProgramFile =
    reading(name) {
        val folder = Path.of(name)
        val paths = folder.walk().filter { it.isRegularFile() && it.name.endsWith(CLASS) }.sorted().take(TinyVmLimits.CLASSES + 1).toList()
        compiled(folder.toAbsolutePath().normalize().name, paths.map { folder.relativize(it).toString() to it })
    }

/** Reads all class files in the jar [name]; its manifest may say which to begin with. */
internal fun readJar(name: String): ProgramFile =
    reading(name) {
        JarFile(name).use { jar ->
            val entries = jar.entries().asSequence().filter { !it.isDirectory && it.name.endsWith(CLASS) }.take(TinyVmLimits.CLASSES + 1).toList()
            val classes = entries.associate { entry -> entry.name to jar.getInputStream(entry).use { it.readNBytes(TinyVmLimits.CLASS_FILE_BYTES + 1) } }
            val mainClass = jar.manifest?.mainAttributes?.getValue(Attributes.Name.MAIN_CLASS)?.trim()?.replace('.', '/')
            program(nameOf(name), classes, mainClass)
        }
    }

private fun innerClassesOf(classFile: Path): List<Path> {
    val folder = classFile.toAbsolutePath().parent ?: return emptyList()
    val prefix = classFile.nameWithoutExtension + "$"
    if (!folder.isDirectory()) return emptyList()
    val inner = folder.listDirectoryEntries().filter { it.name.startsWith(prefix) && ".${it.extension}" == CLASS }
    return inner.sorted().map { classFile.resolveSibling(it.name) }
}

private fun compiled(name: String, files: List<Pair<String, Path>>): ProgramFile {
    files.firstOrNull { (_, path) -> path.fileSize() > TinyVmLimits.CLASS_FILE_BYTES }?.let { (file, _) -> return tooLarge(file) }
    return program(name, files.associate { (file, path) -> file to path.readBytes() })
}

private fun program(name: String, classes: Map<String, ByteArray>, mainClass: String? = null): ProgramFile {
    val large = classes.entries.firstOrNull { it.value.size > TinyVmLimits.CLASS_FILE_BYTES }
    return when {
        classes.isEmpty() -> ProgramFile.Refused("There is no class file in $name.")
        classes.size > TinyVmLimits.CLASSES -> ProgramFile.Refused("$name has too many classes: a brick takes ${TinyVmLimits.CLASSES}.")
        large != null -> tooLarge(large.key)
        else -> ProgramFile.Read(ProgramSource.ClassFiles(name, classes, mainClass))
    }
}

private fun tooLarge(file: String) =
    ProgramFile.Refused("$file is too large: a class file can have ${TinyVmLimits.CLASS_FILE_BYTES} bytes at most.")

private fun reading(name: String, read: () -> ProgramFile): ProgramFile =
    try {
        read()
    } catch (_: NoSuchFileException) {
        ProgramFile.Refused("There is no file $name.")
    } catch (_: InvalidPathException) {
        ProgramFile.Refused("There is no file $name.")
    } catch (_: ZipException) {
        ProgramFile.Refused("$name is no jar, or a damaged one.")
    } catch (problem: IOException) {
        ProgramFile.Refused("$name could not be read: ${problem.message}")
    }
