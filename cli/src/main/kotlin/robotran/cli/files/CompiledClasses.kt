package robotran.cli.files

import robotran.cli.messages.FileMessages
import robotran.programs.ProgramSource
import robotran.tinyvm.config.TinyVmLimits
import java.nio.file.Path
import kotlin.io.path.extension
import kotlin.io.path.isDirectory
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.nameWithoutExtension

/** Reads the class files [names] and their nested classes, which must lie next to them. */
internal fun readClassFiles(names: List<String>, messages: FileMessages): ReadProgram =
    reading(names.first(), messages, ReadProgram::Failure) {
        val paths = names.map(Path::of).flatMap { listOf(it) + innerClassesOf(it) }.distinct()
        if (paths.size > 1) {
            paths.firstOrNull(::isLinkOutside)?.let {
                return@reading ReadProgram.Failure(messages.leadsOutside("$it"))
            }
        }
        val areNamesUnique = paths.distinctBy { it.name }.size == paths.size
        compiled(nameOf(names.first()), paths, messages) { if (areNamesUnique) it.name else it.toString() }
    }

/** Reads all class files in the folder [name] and its subfolders. */
internal fun readClassFolder(name: String, messages: FileMessages): ReadProgram =
    reading(name, messages, ReadProgram::Failure) {
        val folder = Path.of(name)
        val paths = filesIn(folder, MAX_FILES_IN_FOLDER) { _, problem -> throw problem }
            .filter { isClassFile(folder.relativize(it).toString()) }
        paths.firstOrNull { !liesIn(folder, it) }?.let {
            return@reading ReadProgram.Failure(messages.leadsOutside("$it"))
        }
        compiled(nameOf(name), paths.take(TinyVmLimits.CLASSES + 1), messages) { folder.relativize(it).toString() }
    }

/**
 * Returns the program made of the class files [files], keyed by path. [mainClass] is the class to start; null for the
 * first class that has a main method.
 */
internal fun programOf(
    name: String,
    files: Map<String, ByteArray>,
    messages: FileMessages,
    mainClass: String? = null,
): ReadProgram = when {
    files.isEmpty() -> ReadProgram.Failure(messages.noClassFile(name))
    files.size > TinyVmLimits.CLASSES -> ReadProgram.Failure(messages.tooManyClasses(name, TinyVmLimits.CLASSES))
    else -> ReadProgram.Success(ProgramSource.CompiledClasses(name, files, mainClass))
}

/** Reports that the class file [file] exceeds the size limit. */
internal fun tooLarge(file: String, messages: FileMessages): ReadProgram =
    ReadProgram.Failure(messages.classFileTooLarge(file, TinyVmLimits.CLASS_FILE_BYTES))

/**
 * Whether [file], a path in a folder or a jar, is a class of the program. Classes in META-INF (for newer Java versions)
 * and module descriptors do not count.
 */
internal fun isClassFile(file: String): Boolean =
    file.endsWith(CLASS) && !file.startsWith("META-INF") && file.substringAfterLast('/') != "module-info$CLASS"

private fun compiled(name: String, paths: List<Path>, messages: FileMessages, nameOf: (Path) -> String): ReadProgram {
    val files = LinkedHashMap<String, ByteArray>()
    for (path in paths.take(TinyVmLimits.CLASSES + 1)) {
        val file = nameOf(path)
        val limit = TinyVmLimits.CLASS_FILE_BYTES
        when (val content = readContent(path, file, limit, messages) { messages.classFileTooLarge(file, limit) }) {
            is FileContent.Failure -> return ReadProgram.Failure(content.reason)
            is FileContent.Success -> files[file] = content.bytes
        }
    }
    return programOf(name, files, messages)
}

private fun innerClassesOf(classFile: Path): List<Path> {
    val folder = classFile.toAbsolutePath().parent ?: return emptyList()
    val prefix = classFile.nameWithoutExtension + "$"
    if (!folder.isDirectory()) return emptyList()
    val inner = folder.listDirectoryEntries().filter { it.name.startsWith(prefix) && ".${it.extension}" == CLASS }
    return inner.sorted().map { classFile.resolveSibling(it.name) }
}

internal const val CLASS = ".class"

/** Among them may be sources and other things. */
private const val MAX_FILES_IN_FOLDER = 100_000
