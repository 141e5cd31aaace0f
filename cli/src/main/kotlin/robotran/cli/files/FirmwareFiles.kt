package robotran.cli.files

import robotran.cli.messages.FileMessages
import robotran.language.ProgramLanguage
import robotran.languagesupport.SourceFile
import robotran.legofirmware.image.FirmwareLimits
import robotran.programs.Program
import robotran.programs.ProgramSource
import robotran.programs.support
import robotran.projects.ProjectLimits
import java.nio.file.Path
import kotlin.io.path.isRegularFile

/**
 * Reads the program [name] in [language] with the files that it includes, which lie beside it or in folders there: a program of
 * somebody else's cannot get at other files of the user.
 */
internal fun readWithIncluded(name: String, language: ProgramLanguage, messages: FileMessages): ReadProgram {
    val files = LinkedHashMap<String, SourceFile>()
    val notes = mutableListOf<String>()
    val waiting = ArrayDeque(listOf(name))
    while (waiting.isNotEmpty() && files.size < ProjectLimits.MAXIMUM_FILES) {
        val next = waiting.removeFirst()
        if (next in files) continue
        when (val file = readTextFile(next, messages)) {
            is TextFile.Failure -> return ReadProgram.Failure(file.reason)

            is TextFile.Success -> {
                files[next] = SourceFile(file.name, file.text)
                notes += file.notes
                for (included in language.support.files.includes(file.text)) {
                    when (val found = findIncluded(included, next, name)) {
                        is IncludedFile.Found -> waiting += found.name

                        IncludedFile.Outside -> {
                            val line =
                                file.text.lines().indexOfFirst { included in language.support.files.includes(it) } + 1
                            return ReadProgram.Failure(messages.includesOutside(next, line, included))
                        }

                        IncludedFile.Missing -> {}
                    }
                }
            }
        }
    }
    return ReadProgram.Success(Program(nameOf(files.getValue(name).name), language, files.values.toList()), notes)
}

private sealed interface IncludedFile {
    data class Found(val name: String) : IncludedFile

    /** Not in the program's folder, whether it is there or not. */
    data object Outside : IncludedFile

    /** The compiler tells this. */
    data object Missing : IncludedFile
}

/** Looks for [included] beside [file], then beside the [program]. */
private fun findIncluded(included: String, file: String, program: String): IncludedFile {
    val folder = Path.of(program).toAbsolutePath().normalize().parent ?: return IncludedFile.Missing
    val places = listOf(file, program).mapNotNull { name ->
        runCatching { Path.of(name).resolveSibling(included).normalize() }.getOrNull()
    }
    val (inside, outside) = places.partition { isNamedIn(folder, it) }
    val files = inside.filter { it.isRegularFile() }
    val found = files.firstOrNull { liesIn(folder, it) }
    return when {
        found != null -> IncludedFile.Found("$found")
        files.isNotEmpty() || outside.isNotEmpty() -> IncludedFile.Outside
        else -> IncludedFile.Missing
    }
}

internal fun readFirmwareImage(name: String, messages: FileMessages): ReadProgram =
    reading(name, messages, ReadProgram::Failure) {
        when (val file = readContent(Path.of(name), name, FirmwareLimits.IMAGE_BYTES, messages)) {
            is FileContent.Failure -> ReadProgram.Failure(file.reason)
            is FileContent.Success -> ReadProgram.Success(ProgramSource.FirmwareImage(nameOf(name), file.bytes))
        }
    }

/** A compiled program for LEGO's own firmware. */
internal const val RCX_IMAGE = ".rcx"

/** The endings of programs for LEGO's own firmware. */
internal val FIRMWARE_ENDINGS =
    ProgramLanguage.entries.filter { it.support.isForLegoFirmware }.map { it.extension } + RCX_IMAGE
