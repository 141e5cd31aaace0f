package robotran.workshop.programs

import robotran.brick.kind.BrickKind
import robotran.language.ProgramLanguage
import robotran.languagesupport.uniqueName
import robotran.programs.Program
import robotran.programs.support

/** A new program in [language] for a [brick] whose name differs from all [others]. */
internal fun newProgram(language: ProgramLanguage, others: List<Program>, brick: BrickKind): Program {
    val files = language.support.files
    val stem = files.nameFor("program").removeSuffix(language.extension)
    val name = uniqueName(stem, language.extension, others.flatMap { it.files }.map { it.name })
    return Program(name, language, files.newProgram(name, brick))
}
