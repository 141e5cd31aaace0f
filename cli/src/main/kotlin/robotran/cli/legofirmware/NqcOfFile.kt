package robotran.cli.legofirmware

import robotran.brick.kind.BrickKind
import robotran.cli.files.NamedProgram
import robotran.cli.files.ProgramFiles
import robotran.cli.files.ROBOLANG
import robotran.cli.files.isNamed
import robotran.cli.files.readProgramFiles
import robotran.cli.input.RobolangFile
import robotran.cli.input.lineOf
import robotran.cli.input.readRobolangFile
import robotran.cli.messages.CommandMessages
import robotran.console.ExitCode
import robotran.language.Language
import robotran.programs.FirmwareSettings
import robotran.programs.Program
import robotran.robolang.messages.NqcTranslationMessages
import robotran.robolang.nqc.NqcTranslationNote
import robotran.robolang.nqc.translateToNqc

/** What a Robolang program becomes for LEGO's own firmware. */
internal sealed interface NqcOfFile {
    /**
     * @property program in NQC.
     * @property lost what NQC cannot do, one line each; the program leaves it out.
     * @property changed what NQC does nearly the same, one line each.
     */
    class Success(val program: NamedProgram, val lost: List<String>, val changed: List<String>) : NqcOfFile {
        val text: String get() = program.source.files.single().text
    }

    /** @property lines what is wrong, one line each. */
    class Failure(val lines: List<String>, val code: ExitCode) : NqcOfFile
}

/** Translates the Robolang program [name]. */
internal fun nqcOf(name: String, language: Language): NqcOfFile =
    when (val file = readRobolangFile(name, language, BrickKind.ofLegoFirmware)) {
        is RobolangFile.Unreadable -> NqcOfFile.Failure(listOf(file.reason), ExitCode.BAD_INPUT)

        is RobolangFile.HasErrors -> {
            NqcOfFile.Failure(file.notes + file.diagnostics.map { lineOf(name, it) }, ExitCode.PROGRAM_FAILED)
        }

        is RobolangFile.Ready -> {
            val translation = translateToNqc(file.program, NqcTranslationMessages.of(language))
            val (lost, changed) = translation.notes.partition { it.isLost }
            val source = Program.of(translation.fileName, translation.nqc)
            val line = { note: NqcTranslationNote -> "$name:${note.range.line}:${note.range.column}: ${note.message}" }
            val messages = CommandMessages.of(language)
            NqcOfFile.Success(
                NamedProgram(name, source),
                lost.map(line),
                file.notes + changed.map { messages.warning(line(it)) },
            )
        }
    }

/** Compiles the program [name] for LEGO's own firmware; a program in Robolang becomes NQC first. */
internal fun firmwareImageOf(name: String, settings: FirmwareSettings, language: Language): FirmwareImageOfFile {
    if (isNamed(name, ROBOLANG)) {
        return when (val translated = nqcOf(name, language)) {
            is NqcOfFile.Failure -> FirmwareImageOfFile.Failure(translated.lines, translated.code)
            is NqcOfFile.Success -> imageOf(translated, settings, language)
        }
    }
    return when (val read = readProgramFiles(listOf(name), CommandMessages.of(language))) {
        is ProgramFiles.Failure -> FirmwareImageOfFile.Failure(listOf(read.reason), ExitCode.BAD_INPUT)

        is ProgramFiles.Success -> {
            when (val built = firmwareImageOf(read.programs.single(), settings, language)) {
                is FirmwareImageOfFile.Failure -> FirmwareImageOfFile.Failure(read.notes + built.lines, built.code)
                is FirmwareImageOfFile.Success -> FirmwareImageOfFile.Success(
                    built.image,
                    read.notes + built.warnings,
                )
            }
        }
    }
}

private fun imageOf(
    translated: NqcOfFile.Success,
    settings: FirmwareSettings,
    language: Language,
): FirmwareImageOfFile {
    if (translated.lost.isNotEmpty()) return FirmwareImageOfFile.Failure(translated.lost, ExitCode.PROGRAM_FAILED)
    return when (val built = firmwareImageOf(translated.program, settings, language)) {
        is FirmwareImageOfFile.Failure -> built
        is FirmwareImageOfFile.Success -> FirmwareImageOfFile.Success(built.image, translated.changed + built.warnings)
    }
}
