package robotran.cli.files

import robotran.cli.console.messages
import robotran.cli.messages.CommandMessages
import robotran.console.Console
import robotran.documents.COURSE_EXTENSION
import robotran.documents.FileKind
import robotran.documents.StoreResult
import robotran.documents.files.writeSafely
import robotran.language.Language
import java.io.IOException
import java.nio.file.InvalidPathException
import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.isDirectory
import kotlin.io.path.isRegularFile
import kotlin.io.path.isSameFileAs
import kotlin.io.path.isSymbolicLink
import kotlin.io.path.name
import kotlin.io.path.readSymbolicLink

/** The result of writing a whole file. Unless it is [Written], what was there is unchanged. */
sealed interface FileWriting {
    data object Written : FileWriting

    data object DiskFull : FileWriting

    /** The file is a symbolic link to another file, or to none. [reason] is a sentence that names both. */
    data class IsLink(val reason: String) : FileWriting

    /** [problem] is the error message of the operating system. */
    data class Failed(val problem: String) : FileWriting
}

/**
 * Writes [bytes] to the file at [path], see [writeSafely]. A symbolic link is not followed to another file. Errors are in
 * [language] and name the file without its folders.
 */
fun writeFile(path: Path, bytes: ByteArray, language: Language): FileWriting =
    writeFile(path, path.name, bytes, CommandMessages.of(language))

/** The same. Returns null on success, otherwise an error message that calls the file [name], as the user entered it. */
internal fun writeFile(name: String, bytes: ByteArray, messages: CommandMessages): String? = try {
    when (val result = writeFile(Path.of(name), name, bytes, messages)) {
        FileWriting.Written -> null
        FileWriting.DiskFull -> messages.diskFull(name)
        is FileWriting.IsLink -> result.reason
        is FileWriting.Failed -> messages.unwritable(name, result.problem)
    }
} catch (_: InvalidPathException) {
    messages.notAFileName(name)
}

private fun writeFile(path: Path, name: String, bytes: ByteArray, messages: CommandMessages): FileWriting = try {
    if (path.isSymbolicLink() && (path.isRegularFile() || !path.exists())) {
        FileWriting.IsLink(messages.isSymbolicLink(name, "${path.readSymbolicLink()}"))
    } else {
        when (val result = writeSafely(path, bytes)) {
            StoreResult.Done -> FileWriting.Written
            StoreResult.Full -> FileWriting.DiskFull
            StoreResult.NoAnswer -> FileWriting.Failed("timeout")
            is StoreResult.Failed -> FileWriting.Failed(result.reason)
        }
    }
} catch (problem: IOException) {
    FileWriting.Failed(problem.message.orEmpty())
}

/**
 * Whether a command that reads [inputs] may write [outputs]: none of them is a file that it reads, and each is named
 * once. Prints an error if not. To be asked before the work, which may take long. Outputs to the console are null or -.
 */
internal fun mayWrite(inputs: List<String>, outputs: List<String?>, console: Console): Boolean {
    val names = outputs.filterNotNull().filter { it != ON_CONSOLE }
    val twice = names.withIndex().firstOrNull { (number, name) -> names.take(number).any { isSame(it, name) } }
    val input = names.firstOrNull { name -> inputs.any { isReadAs(it, name) } }
    val reason = input?.let(console.messages::isInput) ?: twice?.let { console.messages.writtenTwice(it.value) }
    reason?.let(console::complain)
    return reason == null
}

/** Whether [output] is the file [input], a file that is read with it, or one in the folder [input]. */
private fun isReadAs(input: String, output: String): Boolean = try {
    val (read, written) = Path.of(input) to Path.of(output)
    when {
        !written.isRegularFile() -> false
        isSame(input, output) -> true
        read.isDirectory() -> liesIn(read, written) && !isOnlyWritten(output)
        isNamed(input, COURSE_EXTENSION) -> output.endsWith(FileKind.PROJECT.extension) && isBeside(read, written)
        else -> isIncluded(input, written)
    }
} catch (_: InvalidPathException) {
    false
}

private fun isBeside(course: Path, file: Path) = course.toAbsolutePath().parent?.let { liesIn(it, file) } ?: false

private fun isOnlyWritten(name: String) = ONLY_WRITTEN.any { name.endsWith(it, ignoreCase = true) }

private fun isIncluded(program: String, file: Path): Boolean {
    val language = languageOf(program)?.takeIf { it.mayHaveFiles } ?: return false
    val read =
        readWithIncluded(program, language, CommandMessages.of(Language.ENGLISH)) as? ReadProgram.Success
            ?: return false
    return read.source.files.any { isSame(it.name, "$file") }
}

/** A file has many names: relative ones, links, capital letters on some systems. */
private fun isSame(one: String, other: String): Boolean = try {
    val (first, second) = Path.of(one) to Path.of(other)
    if (first.exists() && second.exists()) {
        first.isSameFileAs(second)
    } else {
        first.toAbsolutePath().normalize() == second.toAbsolutePath().normalize()
    }
} catch (_: InvalidPathException) {
    one == other
} catch (_: IOException) {
    false
}

/** The endings of outputs that no command reads, so that a folder of hand-ins may hold the results, too. */
private val ONLY_WRITTEN = listOf(".csv", ".xml", ".png", ".svg")

/** The name of an output that goes to the console. */
internal const val ON_CONSOLE = "-"
