package robotran.legofirmware.assembly

import robotran.language.Language
import robotran.legofirmware.image.FirmwareTarget

/**
 * Assembles a text of the form that [robotran.legofirmware.listing.assemblyListing] gives. Chunks and symbols get the
 * order of NQC's compiler: subroutines, tasks, variables; names come from the comments of a listing.
 *
 * @param target the firmware that the program is for; commands that only a newer one knows are errors.
 */
fun assemble(source: String, language: Language, target: FirmwareTarget = FirmwareTarget.RCX2): AssemblyResult =
    Assembler(language, target).assemble(source)
