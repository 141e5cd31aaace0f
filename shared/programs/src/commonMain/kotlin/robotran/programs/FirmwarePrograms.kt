package robotran.programs

import robotran.language.Language
import robotran.language.source.Diagnostic
import robotran.language.source.Severity
import robotran.languagesupport.simpleName
import robotran.legofirmware.FirmwareProgram
import robotran.legofirmware.image.LineTable
import robotran.legofirmware.image.RcxImage
import robotran.legofirmware.image.RcxImageResult
import robotran.legofirmware.image.VariableTable
import robotran.legofirmware.image.message
import robotran.legofirmware.image.readRcxImage
import robotran.legofirmware.listing.assemblyListing
import robotran.legofirmware.support.LasmSupport

/** Compiles this image, with messages in [language]. */
internal fun ProgramSource.FirmwareImage.compile(language: Language): ProgramResult =
    when (val result = readRcxImage(bytes)) {
        is RcxImageResult.Failure -> {
            ProgramResult.Failure(
                listOf(Diagnostic(Severity.ERROR, name, null, result.fault.message(language))),
            )
        }

        is RcxImageResult.Success -> {
            val warnings = result.warnings.map {
                Diagnostic(Severity.WARNING, name, null, it.message(language))
            }
            ready(name, result.image, result.image.assemblyListing().lines, warnings, language)
        }
    }

/** The compiler knows only what `#include` calls a file. */
internal fun named(program: Program, diagnostic: Diagnostic): Diagnostic {
    val file = program.files.find { simpleName(it.name) == simpleName(diagnostic.file) } ?: program.files.first()
    return diagnostic.copy(file = file.name)
}

internal fun ready(
    name: String,
    image: RcxImage,
    lines: LineTable,
    warnings: List<Diagnostic>,
    language: Language,
    variables: VariableTable? = null,
) = ProgramResult.Success(FirmwareProgram(name, image, lines, language, variables), warnings)

/** What a brick with LEGO's own firmware runs; null for a program for another firmware. */
val ProgramResult.Success.firmwareImage: RcxImage? get() = (program as? FirmwareProgram)?.image

/** The same program as assembly text, whose lines are those of its log; null if it cannot run. */
fun ProgramSource.FirmwareImage.toLasm(): Program? = when (val result = readRcxImage(bytes)) {
    is RcxImageResult.Failure -> null
    is RcxImageResult.Success -> Program(lasmName(name), LasmSupport.language, result.image.assemblyListing().text)
}

/** Why no brick can run it, in a sentence; null if one can. */
fun ProgramSource.FirmwareImage.fault(language: Language): String? =
    (readRcxImage(bytes) as? RcxImageResult.Failure)?.fault?.message(language)

private fun lasmName(image: String): String = image.substringBeforeLast('.') + LasmSupport.language.extension
