package robotran.programs

import robotran.lejoslinker.ImageResult
import robotran.lejoslinker.config.ImageOptions
import robotran.lejoslinker.layoutOnBrick
import robotran.lejoslinker.linkLejosImage
import robotran.lejoslinker.messages.ImageMessages
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
     * Links [program] for the simulated brick. True to the brick, it must also fit a real one, and has the memory and the
     * numbers that its image has there.
     */
    fun link(program: CompiledProgram): ProgramResult = when (val result = linkForSimulation(program)) {
        is TinyVmResult.Rejected -> {
            ProgramResult.HasErrors(listOf(program.locate(result.refusal)))
        }

        is TinyVmResult.Ready -> {
            val mainClass = result.program.mainClass
            when (val image = checkForBrick(program, mainClass)) {
                is ImageResult.Refused -> {
                    ProgramResult.HasErrors(image.errors.map(program.locate))
                }

                is ImageResult.Linked -> {
                    val warnings = program.warnings + image.warnings.map { ProgramDiagnostic(program.name, null, it) }
                    val asOnBrick = result.program.laidOutAs(image.image.layoutOnBrick(settings.version))
                    ProgramResult.Ready(asOnBrick, warnings, program.mainClass)
                }

                null -> {
                    ProgramResult.Ready(result.program, program.warnings, program.mainClass)
                }
            }
        }
    }

    /** Links [program] for the simulated brick, which finds code that is not sound. */
    fun linkForSimulation(program: CompiledProgram): TinyVmResult = linkTinyVm(
        program.name,
        program.classFiles,
        BrickLibrary.classFilesFor(settings),
        program.mainClass,
        settings.mode,
        messages,
        settings.speed,
        settings.version,
    )

    /** Links the image of programs with [classFiles], which [linkForSimulation] has accepted. */
    fun linkImage(classFiles: Map<String, ByteArray>, mainClasses: List<String>): ImageResult = linkLejosImage(
        classFiles,
        BrickLibrary.classFilesOfBrick,
        mainClasses,
        ImageOptions(settings.version),
        imageMessages,
    )

    private fun checkForBrick(program: CompiledProgram, mainClass: String): ImageResult? = when (settings.mode) {
        TinyVmMode.BRICK -> linkImage(program.classFiles, listOf(mainClass))
        TinyVmMode.FORGIVING -> null
    }
}
