package robotran.ui.learning

import androidx.compose.ui.graphics.ImageBitmap
import robotran.brick.program.BrickProgram
import robotran.language.ProgramLanguage
import robotran.programs.CompilerLoading
import robotran.programs.ProgramCompiler
import robotran.programs.ProgramResult
import robotran.programs.ProgramSource
import robotran.programs.SourceFile
import robotran.projects.PENBOT_CALIBRATION
import robotran.simulation.RobotLoad
import robotran.ui.sheet.PictureBounds
import robotran.ui.sheet.SheetColours
import robotran.ui.sheet.SheetPictures
import robotran.workshop.examples.examples
import robotran.world.file.BuiltInWorlds

/**
 * Thumbnails of what the examples draw. A Java program shows the drawing of its Robolang version, since compiling it
 * takes longer; a program without one is compiled.
 */
internal object ExamplePictures : CardPictures<String> {
    private val pictures = SheetPictures()
    private val reader = ProgramCompiler(PENBOT_CALIBRATION)

    override fun ready(subject: String, colours: SheetColours, room: PictureBounds): ImageBitmap? =
        pictures.ready(twinOf(subject) ?: subject, colours, room)

    /** The thumbnail of the example [subject]. If the compiler cannot be loaded, shows the sheet before the run. */
    override suspend fun of(subject: String, colours: SheetColours, room: PictureBounds): ImageBitmap {
        val name = twinOf(subject) ?: subject
        return pictures.of(name, BuiltInWorlds.plain, colours, room) {
            listOfNotNull(programOf(name)).map { RobotLoad(listOf(it)) }
        }
    }

    private suspend fun programOf(name: String): BrickProgram? {
        val source = ProgramLanguage.ROBOLANG.examples[name]?.let { ProgramSource.Robolang(name, it) }
            ?: ProgramLanguage.JAVA.examples[name]?.let { ProgramSource.Java(name, listOf(SourceFile(name, it))) }
            ?: return null
        if (reader.prepareFor(source) is CompilerLoading.Failed) return null
        return (reader.compileNow(source) as? ProgramResult.Ready)?.program
    }

    /** The Robolang version of the example [name]: `wall-bouncer.robo` for `WallBouncer.java`. */
    private fun twinOf(name: String): String? = ProgramLanguage.ROBOLANG.examples.keys.firstOrNull {
        it == name ||
            it.replace("-", "").removeSuffix(".robo") == name.lowercase().removeSuffix(".java")
    }
}
