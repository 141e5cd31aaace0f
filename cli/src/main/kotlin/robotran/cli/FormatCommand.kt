package robotran.cli

import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.CoreCliktCommand
import com.github.ajalt.clikt.core.ProgramResult
import com.github.ajalt.clikt.parameters.arguments.argument
import com.github.ajalt.clikt.parameters.arguments.multiple
import com.github.ajalt.clikt.parameters.groups.provideDelegate
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.types.choice
import robotran.cli.files.TextFile
import robotran.cli.files.isNamed
import robotran.cli.files.readTextFile
import robotran.cli.files.writeFile
import robotran.cli.input.lineOf
import robotran.cli.input.readRobolangText
import robotran.cli.messages.CommandMessages
import robotran.console.Console
import robotran.console.ExitCode
import robotran.console.LanguageOption
import robotran.documents.TextChange
import robotran.nqc.support.NqcSupport
import robotran.robolang.format.FormatResult
import robotran.robolang.format.formatRobolang
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.wording.ChangedWords
import robotran.robolang.wording.changeWords
import robotran.robolang.words.Vocabulary

/** `robotran format FILE..`: formats programs in place. With `--check` it only lists the unformatted ones. */
internal class FormatCommand(private val console: Console) : CoreCliktCommand("format") {
    private val files by argument("FILE", help = "programs in Robolang (.robo) or NQC (.nqc)").multiple(required = true)
    private val onlyChecks by option("--check", help = "changes nothing and tells which files would change").flag()

    private val words by option("--words", help = "writes Robolang in the words of this language")
        .choice(Vocabulary.all.associateBy { it.language.tag })

    private val spoken by LanguageOption()
    private val sentences get() = CommandMessages.of(spoken.language)

    override fun help(context: Context) = "Lays programs out: indentation, spaces, small letters."

    override fun run() {
        throw ProgramResult(files.maxOf { format(it).status })
    }

    private fun format(name: String): ExitCode {
        val isNqc = isNamed(name, NQC)
        return when (val file = if (isNqc) readTextFile(name, sentences) else readRobolangText(name, spoken.language)) {
            is TextFile.Failure -> refuse(file.reason)
            is TextFile.Success -> if (isNqc) {
                settle(
                    name,
                    file,
                    NqcSupport.code.format(file.text).orEmpty(),
                )
            } else {
                format(name, file)
            }
        }
    }

    private fun format(name: String, file: TextFile.Success): ExitCode =
        when (val result = words?.let { changeWords(file.text, it) } ?: ChangedWords.Success(file.text)) {
            is ChangedWords.Success -> format(name, file, result.text)

            is ChangedWords.NamesInTheWay -> {
                console.complain(sentences.namesInTheWay(name, result.names))
                ExitCode.PROGRAM_FAILED
            }
        }

    private fun format(name: String, file: TextFile.Success, text: String): ExitCode =
        when (val result = formatRobolang(text, RobolangMessages.of(spoken.language))) {
            is FormatResult.Success -> settle(name, file, result.text)

            is FormatResult.Failure -> {
                result.diagnostics.forEach { console.complain(lineOf(name, it)) }
                ExitCode.PROGRAM_FAILED
            }
        }

    /** A program in another encoding becomes one in UTF-8, which others can read, too. */
    private fun settle(name: String, file: TextFile.Success, formatted: String): ExitCode {
        val encoding = file.changes.firstNotNullOfOrNull { (it as? TextChange.Decoded)?.encoding?.ownName }
        if (file.text == formatted && encoding == null) return ExitCode.DONE
        if (onlyChecks) {
            console.complain(encoding?.let { sentences.notInUtf8(name, it) } ?: sentences.notFormatted(name))
            return ExitCode.PROGRAM_FAILED
        }
        writeFile(name, formatted.encodeToByteArray(), sentences)?.let { return refuse(it) }
        encoding?.let { console.complain(sentences.nowInUtf8(name, it)) }
        return ExitCode.DONE
    }

    private fun refuse(reason: String): ExitCode {
        console.complain(reason)
        return ExitCode.BAD_INPUT
    }
}

private const val NQC = ".nqc"
