package robotran.cli.files

import robotran.cli.messages.FileMessages
import robotran.legofirmware.image.FirmwareLimits
import robotran.programs.ProgramSource
import robotran.programs.SourceFile
import robotran.programs.nqcIncludes
import robotran.projects.ProjectLimits
import java.nio.file.Path
import kotlin.io.path.isRegularFile

/** Reads the NQC program [name] with the files that it includes, which lie beside it or in folders there. */
internal fun readNqc(name: String, messages: FileMessages): ReadProgram {
    val files = LinkedHashMap<String, SourceFile>()
    val remarks = mutableListOf<String>()
    val waiting = ArrayDeque(listOf(name))
    while (waiting.isNotEmpty() && files.size < ProjectLimits.MAXIMUM_FILES) {
        val next = waiting.removeFirst()
        if (next in files) continue
        when (val file = readTextFile(next, messages)) {
            is TextFile.Rejected -> {
                return ReadProgram.Rejected(file.reason)
            }

            is TextFile.Read -> {
                files[next] = SourceFile(file.name, file.text)
                remarks += file.remarks
                nqcIncludes(file.text).mapNotNullTo(waiting) { fileBeside(next, it) ?: fileBeside(name, it) }
            }
        }
    }
    return ReadProgram.Read(ProgramSource.Nqc(nameOf(files.getValue(name).name), files.values.toList()), remarks)
}

/** The path of [included], as [name] names it; null if there is no such file, which the compiler tells. */
private fun fileBeside(name: String, included: String): String? =
    runCatching { Path.of(name).resolveSibling(included).normalize() }.getOrNull()
        ?.takeIf { it.isRegularFile() }?.toString()

internal fun readLasm(name: String, messages: FileMessages): ReadProgram =
    when (val file = readTextFile(name, messages)) {
        is TextFile.Read -> ReadProgram.Read(ProgramSource.Lasm(nameOf(file.name), file.text), file.remarks)
        is TextFile.Rejected -> ReadProgram.Rejected(file.reason)
    }

internal fun readFirmwareImage(name: String, messages: FileMessages): ReadProgram =
    reading(name, messages, ReadProgram::Rejected) {
        when (val file = readContent(Path.of(name), name, FirmwareLimits.IMAGE_BYTES, messages)) {
            is FileContent.Rejected -> ReadProgram.Rejected(file.reason)
            is FileContent.Read -> ReadProgram.Read(ProgramSource.FirmwareImage(nameOf(name), file.bytes))
        }
    }

internal const val NQC = ".nqc"

internal const val LASM = ".lasm"

/** A compiled program for LEGO's own firmware. */
internal const val RCX_IMAGE = ".rcx"

/** The endings of programs for LEGO's own firmware. */
internal val FIRMWARE_ENDINGS = listOf(NQC, LASM, RCX_IMAGE)
