package robotran.programs

import robotran.language.Language
import robotran.language.source.Diagnostic
import robotran.language.source.Severity
import robotran.legofirmware.FirmwareProgram
import robotran.legofirmware.assembly.AssemblyResult
import robotran.legofirmware.assembly.assemble
import robotran.legofirmware.image.CodeLine
import robotran.legofirmware.image.LineTable
import robotran.legofirmware.image.RcxImage
import robotran.legofirmware.image.RcxImageResult
import robotran.legofirmware.image.VariableTable
import robotran.legofirmware.image.message
import robotran.legofirmware.image.readRcxImage
import robotran.legofirmware.listing.assemblyListing
import robotran.nqc.NqcOptions
import robotran.nqc.NqcProgram
import robotran.nqc.NqcResult
import robotran.nqc.compileNqc
import robotran.nqc.messages.NqcMessages

/** Makes programs for LEGO's own firmware. */
internal class FirmwareProgramCompiler(private val settings: FirmwareSettings, private val language: Language) {
    fun read(source: ProgramSource.ForLegoFirmware): ProgramResult = when (source) {
        is ProgramSource.Nqc -> readNqc(source)
        is ProgramSource.Lasm -> readLasm(source)
        is ProgramSource.FirmwareImage -> readImage(source)
    }

    private fun readNqc(source: ProgramSource.Nqc): ProgramResult {
        val main = source.files.first()
        val options = NqcOptions(settings.target, settings.isOldNqc, includedFiles(source.files))
        val messages = NqcMessages.of(language)
        return when (val result = compileNqc(simpleName(main.name), main.text, options, messages)) {
            is NqcResult.HasErrors -> ProgramResult.HasErrors(result.diagnostics.map { named(source, it) })

            is NqcResult.Ready -> ready(
                source,
                result.program.image,
                linesOf(result.program, isOneFile = source.files.size == 1),
                result.warnings.map { named(source, it) },
                result.program.variables,
            )
        }
    }

    /** The texts by the names that `#include` gives them, whose folders may be others than in [files]. */
    private fun includedFiles(files: List<SourceFile>): Map<String, String> {
        val texts = files.drop(1).associate { simpleName(it.name) to it.text }
        val included = files.flatMap { nqcIncludes(it.text) }
        return texts + included.mapNotNull { name -> texts[simpleName(name)]?.let { name to it } }
    }

    /** What the API does belongs to no line of the pupil's. */
    private fun linesOf(program: NqcProgram, isOneFile: Boolean) = LineTable(
        program.lines.mapValues { (_, lines) ->
            lines.filter { it.range.line > 0 }
                .map { CodeLine(it.address, it.range.line, simpleName(it.range.file).takeUnless { isOneFile }) }
        },
    )

    /** The compiler knows only what `#include` calls a file. */
    private fun named(source: ProgramSource, diagnostic: Diagnostic): Diagnostic {
        val file = source.files.find { simpleName(it.name) == simpleName(diagnostic.file) } ?: source.files.first()
        return diagnostic.copy(file = file.name)
    }

    private fun readLasm(source: ProgramSource.Lasm): ProgramResult =
        when (val result = assemble(source.text, language, settings.target)) {
            is AssemblyResult.Rejected -> ProgramResult.HasErrors(result.diagnostics.map { named(source, it) })

            is AssemblyResult.Assembled -> ready(
                source,
                result.image,
                result.lines,
                result.warnings.map { named(source, it) },
            )
        }

    private fun readImage(source: ProgramSource.FirmwareImage): ProgramResult =
        when (val result = readRcxImage(source.bytes)) {
            is RcxImageResult.Refused -> {
                ProgramResult.HasErrors(
                    listOf(Diagnostic(Severity.ERROR, source.name, null, result.fault.message(language))),
                )
            }

            is RcxImageResult.Read -> {
                val warnings = result.warnings.map {
                    Diagnostic(Severity.WARNING, source.name, null, it.message(language))
                }
                ready(source, result.image, result.image.assemblyListing().lines, warnings)
            }
        }

    private fun ready(
        source: ProgramSource,
        image: RcxImage,
        lines: LineTable,
        warnings: List<Diagnostic>,
        variables: VariableTable? = null,
    ) = ProgramResult.Ready(FirmwareProgram(source.name, image, lines, language, variables), warnings)
}

/** What a brick with LEGO's own firmware runs; null for a program for another firmware. */
val ProgramResult.Ready.firmwareImage: RcxImage? get() = (program as? FirmwareProgram)?.image

/** The same program as assembly text, whose lines are those of its log; null if it cannot run. */
fun ProgramSource.FirmwareImage.toLasm(): ProgramSource.Lasm? = when (val result = readRcxImage(bytes)) {
    is RcxImageResult.Refused -> null
    is RcxImageResult.Read -> ProgramSource.Lasm(lasmName(name), result.image.assemblyListing().text)
}

/** Why no brick can run it, in a sentence; null if one can. */
fun ProgramSource.FirmwareImage.fault(language: Language): String? =
    (readRcxImage(bytes) as? RcxImageResult.Refused)?.fault?.message(language)

private fun lasmName(image: String): String = image.substringBeforeLast('.') + ".lasm"
