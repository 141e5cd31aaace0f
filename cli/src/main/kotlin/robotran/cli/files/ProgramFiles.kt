package robotran.cli.files

import robotran.brick.program.BrickProgram
import robotran.cli.messages.FileMessages
import robotran.language.ProgramLanguage
import robotran.languagesupport.SourceFile
import robotran.programs.Program
import robotran.programs.ProgramSource
import java.nio.file.Path
import kotlin.io.path.isDirectory
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name

/** The result of reading program files. */
internal sealed interface ProgramFiles {
    /**
     * @property programs at least one, at most as many as fit on a brick, ordered by the first file of each.
     * @property notes how their files were read although they are unusual, in sentences.
     */
    data class Success(val programs: List<NamedProgram>, val notes: List<String> = emptyList()) : ProgramFiles

    /** The files cannot be used. [reason] is a sentence that names the file. */
    data class Failure(val reason: String) : ProgramFiles
}

/**
 * A program and its origin.
 *
 * @property path its first file as the user entered it.
 * @property project the project or link that contains it, as shown to the user; null if it is a separate file.
 */
internal data class NamedProgram(val path: String, val source: ProgramSource, val project: String? = null)

/**
 * Reads the files [names]. Each `.robo`, `.jar`, `.nqc`, `.lasm` or `.rcx` file and each folder of `.class` files is one
 * program. All `.java` files together are one program, and so are all `.class` files. Duplicates are ignored.
 */
internal fun readProgramFiles(names: List<String>, messages: FileMessages): ProgramFiles {
    val groups = names.distinct().groupBy { name ->
        FILES_OF_ONE_PROGRAM.firstOrNull { isNamed(name, it) } ?: name
    }.values
    if (groups.size > BrickProgram.MAX_PROGRAMS) {
        return ProgramFiles.Failure(messages.tooManyPrograms(BrickProgram.MAX_PROGRAMS, groups.size))
    }
    val notes = mutableListOf<String>()
    val programs =
        groups.map { files ->
            when (val result = readProgram(files, messages)) {
                is ReadProgram.Success -> NamedProgram(files.first(), result.source).also { notes += result.notes }
                is ReadProgram.Failure -> return ProgramFiles.Failure(result.reason)
            }
        }
    return ProgramFiles.Success(programs, notes)
}

private fun readProgram(names: List<String>, messages: FileMessages): ReadProgram {
    val first = names.first()
    val language = languageOf(first)?.takeIf { isNamed(first, it.extension) }
    return when {
        isNamed(first, JAVA) -> readJava(names, messages)
        language != null -> readWithIncluded(first, language, messages)
        isNamed(first, RCX_IMAGE) -> readFirmwareImage(first, messages)
        isNamed(first, CLASS) -> readClassFiles(names, messages)
        isNamed(first, JAR) -> readJar(first, messages)
        isFolder(first) -> readClassFolder(first, messages)
        else -> ReadProgram.Failure(messages.notAProgram(first, PROGRAM_ENDINGS))
    }
}

private fun readJava(names: List<String>, messages: FileMessages): ReadProgram {
    val notes = mutableListOf<String>()
    val files =
        names.map { name ->
            when (val file = readJavaFile(name, isAlone = names.size == 1, messages)) {
                is TextFile.Success -> SourceFile(file.name, file.text).also { notes += file.notes }
                is TextFile.Failure -> return ReadProgram.Failure(file.reason)
            }
        }
    return ReadProgram.Success(Program.of(files).copy(name = nameOf(files.first().name)), notes)
}

/**
 * Reads the Java file [name].
 *
 * @param isAlone whether the user has named this file only. Of several, which may be all in a folder, none is read through
 * a link to another folder: a program of somebody else's cannot get at other files of the user.
 */
internal fun readJavaFile(name: String, isAlone: Boolean, messages: FileMessages): TextFile =
    if (!isAlone && isLinkOutside(name)) {
        TextFile.Failure(messages.leadsOutside(name))
    } else {
        readTextFile(name, messages)
    }

/** The first of [files] that is a link out of its folder and that the user has not named; null if there is none. */
internal fun linkOutside(files: List<String>, named: List<String>): String? =
    files.firstOrNull { it !in named && isLinkOutside(it) }

private fun isLinkOutside(name: String): Boolean = runCatching { isLinkOutside(Path.of(name)) }.getOrDefault(false)

/**
 * Returns the files to pass to [readProgramFiles] for one program: all sources in a folder of Java sources, otherwise
 * the file or folder itself.
 */
internal fun filesOfProgram(name: String): List<String> {
    val sources =
        if (isFolder(name)) {
            runCatching {
                Path.of(name).listDirectoryEntries()
            }.getOrDefault(emptyList()).map { it.toString() }.filter { isNamed(it, JAVA) }.sorted()
        } else {
            emptyList()
        }
    return sources.ifEmpty { listOf(name) }
}

/** Whether there are class files in the folder [name]. */
internal fun hasClassFiles(name: String): Boolean =
    runCatching { Path.of(name).listDirectoryEntries("*$CLASS").isNotEmpty() }.getOrDefault(false)

/** The name of the file or folder [path] without its parent folders. */
internal fun nameOf(path: String): String = Path.of(path).toAbsolutePath().normalize().name

internal fun isFolder(name: String): Boolean = runCatching { Path.of(name).isDirectory() }.getOrDefault(false)

internal const val ROBOLANG = ".robo"

internal const val JAVA = ".java"

internal const val JAR = ".jar"

/** The endings of files with programs. */
internal val PROGRAM_ENDINGS =
    ProgramLanguage.entries.map { it.extension }.filter { it !in FIRMWARE_ENDINGS } + CLASS + JAR + FIRMWARE_ENDINGS
private val FILES_OF_ONE_PROGRAM = listOf(JAVA, CLASS)
