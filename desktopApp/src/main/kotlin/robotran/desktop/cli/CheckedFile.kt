package robotran.desktop.cli

import kotlinx.coroutines.runBlocking
import robotran.desktop.TextFile
import robotran.desktop.readTextFile
import robotran.programs.Mistake
import robotran.programs.ProgramReader
import robotran.programs.ProgramResult
import robotran.programs.ProgramSource
import robotran.programs.SourceFile
import robotran.ui.workshop.PENBOT_CALIBRATION

/** A file as `robotran check` meets it. */
internal sealed interface CheckedFile {
    /** A Robolang program. */
    data class Robolang(val file: RobolangFile) : CheckedFile

    /** One of the files of a Java program. */
    data class Java(val mistakes: List<Mistake>, val warnings: List<Mistake>) : CheckedFile

    /** It cannot be read; [reason] is a sentence that names the file. */
    data class Unreadable(val reason: String) : CheckedFile
}

/** Checks the files [names], in their order: each `.robo` file by itself, all `.java` files together as one program. */
internal fun checkFiles(names: List<String>): List<Pair<String, CheckedFile>> {
    val java = checkJava(names.filter { it.endsWith(JAVA) }.distinct())
    return names.map { name -> name to (java[name] ?: checkRobolang(name)) }
}

private fun checkRobolang(name: String): CheckedFile =
    when (val file = readRobolangFile(name)) {
        is RobolangFile.Unreadable -> CheckedFile.Unreadable(file.reason)
        else -> CheckedFile.Robolang(file)
    }

private fun checkJava(names: List<String>): Map<String, CheckedFile> {
    val read = names.associateWith(::readTextFile)
    val sources = read.mapNotNull { (name, file) -> (file as? TextFile.Read)?.let { SourceFile(name, it.text) } }
    val result = if (sources.isEmpty()) null else readJava(sources)
    return read.mapValues { (name, file) ->
        when (file) {
            is TextFile.Refused -> CheckedFile.Unreadable(file.reason)
            is TextFile.Read -> CheckedFile.Java(mistakesOf(result, name), warningsOf(result, name))
        }
    }
}

private fun readJava(sources: List<SourceFile>): ProgramResult =
    runBlocking { ProgramReader(PENBOT_CALIBRATION).read(ProgramSource.Java(sources.first().name, sources)) }

private fun mistakesOf(
    result: ProgramResult?,
    file: String,
): List<Mistake> = (result as? ProgramResult.Mistaken)?.mistakes.orEmpty().filter { it.file == file }

private fun warningsOf(
    result: ProgramResult?,
    file: String,
): List<Mistake> = (result as? ProgramResult.Ready)?.warnings.orEmpty().filter { it.file == file }

private const val JAVA = ".java"
