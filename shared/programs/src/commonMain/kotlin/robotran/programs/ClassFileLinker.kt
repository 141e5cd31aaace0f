package robotran.programs

import robotran.language.source.Diagnostic
import robotran.language.source.Severity
import robotran.lejoslinker.ImageResult
import robotran.lejoslinker.config.ImageOptions
import robotran.lejoslinker.linkLejosImage
import robotran.lejoslinker.messages.ImageMessages
import robotran.tinyvm.TinyVmResult
import robotran.tinyvm.config.BrickLayout
import robotran.tinyvm.config.TinyVmMode
import robotran.tinyvm.linkTinyVm
import robotran.tinyvm.messages.TinyVmMessages

/** Links class files for an RCX with leJOS, from our own compiler or another one. */
internal class ClassFileLinker(
    private val settings: JavaSettings,
    private val messages: TinyVmMessages,
    private val imageMessages: ImageMessages,
) : ProgramLinker {
    /** Links what another compiler made, unless it uses what the brick that it is for does not have. */
    fun link(source: ProgramSource.CompiledClasses, gaps: CompiledGaps): ProgramResult {
        val result = link(compiledOf(source))
        val mistakes = if (result is ProgramResult.Success) gaps.find(source.classFiles) else emptyList()
        return if (mistakes.isEmpty()) result else ProgramResult.Failure(mistakes)
    }

    /** Links [program] for the simulated brick. True to the brick, it must fit a real one. */
    override fun link(program: CompiledProgram): ProgramResult {
        if (settings.mode == TinyVmMode.FORGIVING) return simulate(program, program.mainClass, null, emptyList())
        return when (val image = linkImage(program.classFiles, listOfNotNull(program.mainClass))) {
            is ImageResult.Failure -> ProgramResult.Failure(program.diagnosticsOf(image.errors))

            is ImageResult.Success -> {
                val warnings = image.warnings.map { Diagnostic(Severity.WARNING, program.name, null, it) }
                simulate(program, image.image.entryClasses.single(), image.image.layout, warnings)
            }
        }
    }

    /** Links the image of programs with [classFiles]; if no [mainClasses] are given, the first one is found. */
    fun linkImage(classFiles: Map<String, ByteArray>, mainClasses: List<String>): ImageResult = linkLejosImage(
        classFiles,
        BrickLibrary.classFilesOfBrick,
        mainClasses,
        ImageOptions(settings.version, isTrimmed = true),
        imageMessages,
    )

    /** @param layout of the program's image; null if a real brick may not be able to run it. */
    private fun simulate(
        program: CompiledProgram,
        mainClass: String?,
        layout: BrickLayout?,
        warnings: List<Diagnostic>,
    ): ProgramResult {
        val result = linkTinyVm(
            program.name,
            program.classFiles,
            BrickLibrary.classFilesFor(settings),
            mainClass,
            settings.mode,
            messages,
            settings.speed,
            settings.version,
            layout,
        )
        return when (result) {
            is TinyVmResult.Failure -> ProgramResult.Failure(listOf(program.locate(result.refusal)))
            is TinyVmResult.Success -> ProgramResult.Success(
                result.program,
                program.warnings + warnings,
                program.mainClass,
            )
        }
    }
}
