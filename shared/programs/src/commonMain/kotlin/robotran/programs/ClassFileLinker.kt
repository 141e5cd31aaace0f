package robotran.programs

import robotran.lejoslinker.ImageResult
import robotran.lejoslinker.config.ImageOptions
import robotran.lejoslinker.layoutOnBrick
import robotran.lejoslinker.linkLejosImage
import robotran.lejoslinker.messages.ImageMessages
import robotran.tinyvm.TinyVmProgram
import robotran.tinyvm.TinyVmResult
import robotran.tinyvm.config.TinyVmMode
import robotran.tinyvm.linkTinyVm
import robotran.tinyvm.messages.TinyVmMessages

/** Links class files from our own compiler or another one. */
internal class ClassFileLinker(
    private val settings: JavaSettings,
    private val messages: TinyVmMessages,
    private val imageMessages: ImageMessages,
) {
    fun read(source: ProgramSource.CompiledClasses): ProgramResult = link(compiledOf(source))

    fun compiledOf(source: ProgramSource.CompiledClasses) =
        CompiledProgram(source.name, source.classFiles, source.mainClass, emptyList()) {
            diagnosticOf(it, it.sourceFile)
        }

    /**
     * Links [program] for the simulated brick. True to the brick, it must fit a real one, and has the memory and the numbers
     * that its image has there.
     */
    fun link(program: CompiledProgram): ProgramResult {
        if (settings.mode == TinyVmMode.FORGIVING) {
            return simulate(program, program.mainClass) { ProgramResult.Ready(it, program.warnings, program.mainClass) }
        }
        return when (val image = linkImage(program.classFiles, listOfNotNull(program.mainClass))) {
            is ImageResult.Refused -> {
                ProgramResult.HasErrors(image.errors.map(program.locate))
            }

            is ImageResult.Linked -> {
                simulate(program, image.image.entryClasses.single()) {
                    val warnings = program.warnings + image.warnings.map { ProgramDiagnostic(program.name, null, it) }
                    val asOnBrick = it.laidOutAs(image.image.layoutOnBrick(settings.version))
                    ProgramResult.Ready(asOnBrick, warnings, program.mainClass)
                }
            }
        }
    }

    /** Links the image of programs with [classFiles]; if no [mainClasses] are given, the first one is found. */
    fun linkImage(classFiles: Map<String, ByteArray>, mainClasses: List<String>): ImageResult = linkLejosImage(
        classFiles,
        BrickLibrary.classFilesOfBrick,
        mainClasses,
        ImageOptions(settings.version),
        imageMessages,
    )

    private fun simulate(
        program: CompiledProgram,
        mainClass: String?,
        ready: (TinyVmProgram) -> ProgramResult,
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
        )
        return when (result) {
            is TinyVmResult.Rejected -> ProgramResult.HasErrors(listOf(program.locate(result.refusal)))
            is TinyVmResult.Ready -> ready(result.program)
        }
    }
}
